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

/// Of a short run Russian alone, whose words are the longer ones.
inline void addLongerLanguages() {
    QTest::addColumn<QString>("language");
    for (const char* language : {"en", "ru"}) {
        if (qEnvironmentVariableIsSet("SPARKOUT_LONG") || QByteArray(language) == "ru") {
            QTest::newRow(language) << language;
        }
    }
}

/// Of a short run every second file, and those between in the other language.
inline QStringList filesIn(const QString& language, const QStringList& paths) {
    QStringList share;
    for (qsizetype i = 0; i < paths.size(); ++i) {
        if (qEnvironmentVariableIsSet("SPARKOUT_LONG")
            || (i % 2 == 0) == (language == QStringLiteral("en"))) {
            share << paths[i];
        }
    }
    return share;
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
