// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/cli/cli_process.h"

#include <QObject>
#include <QTemporaryDir>
#include <QTest>

#include <clocale>
#include <fstream>

namespace cli {

using nlohmann::json;

/// A test of the program with a folder of its own.
class FolderTest : public QObject {
protected:
    void begin() {
        std::setlocale(LC_NUMERIC, "C"); // the application object took the environment's
        QVERIFY(m_folder.isValid());
    }
    QString save(const QString& name, const std::string& content) const {
        const QString path = m_folder.filePath(name);
        std::ofstream(path.toStdString(), std::ios::binary) << content;
        return path;
    }

    QTemporaryDir m_folder;
};

/// A cycle whose last stage gets no nearer to the size.
inline json stuckProject() {
    json slow = sparkout::samples::sample("smallest-plunge");
    slow["cycle"]["stages"] = {{{"radial_feed_mm_min", 0.5}, {"stock_mm", 0.01}},
                               {{"spark_out", "until_size"}, {"stock_mm", 0.14}}};
    return slow;
}

/// A part whose runout no cycle meets.
inline json strictProject() {
    json strict = sparkout::samples::sample("complete");
    strict["part"]["tolerance"]["radial_runout_um"] = 1e-6;
    return strict;
}

inline sparkout::Project projectOf(const QString& file) {
    return sparkout::readProject(sparkout::samples::readText(file.toStdString())).project.value();
}

/// Rows of files that simulate runs.
inline void runnableRows() {
    QTest::addColumn<QString>("file");
    for (const char* name : {"complete", "smallest-plunge", "internal-plunge"}) {
        QTest::newRow(name) << samplePath(name);
    }
}

} // namespace cli
