// SPDX-License-Identifier: GPL-3.0-or-later
// Tables of data that repeat a test in each language of the window.
#pragma once

#include <QFileInfo>
#include <QTest>

#include <vector>

namespace sparkout {

inline void addLanguages() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"en", "ru"}) {
        QTest::newRow(language) << language;
    }
}

/// At the usual size of the font and a larger one.
inline void addLanguagesAndSizes() {
    QTest::addColumn<QString>("language");
    QTest::addColumn<int>("percent");
    for (const char* language : {"en", "ru"}) {
        for (const int percent : {100, 130}) {
            QTest::addRow("%s %d", language, percent) << language << percent;
        }
    }
}

inline void addFilesAndLanguages(const QStringList& paths,
                                 const std::vector<const char*>& languages = {"en", "ru"}) {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("language");
    for (const QString& path : paths) {
        for (const char* language : languages) {
            QTest::addRow("%s %s", qPrintable(QFileInfo(path).baseName()), language)
                << path << language;
        }
    }
}

} // namespace sparkout
