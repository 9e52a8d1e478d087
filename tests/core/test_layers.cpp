// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of the tree: docs/layers.txt, held against the includes.
#include "tests/registry.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSet>

namespace sparkout::test_layers {

struct Include {
    QString file; ///< relative to the root
    QString text; ///< what stands between the quotes or brackets
};

QList<Include> includesBelow(const QString& folder) {
    const QDir root(QStringLiteral(SPARKOUT_SOURCE_DIR));
    static const QRegularExpression pattern(
        QStringLiteral("^\\s*#\\s*include\\s*[<\"]([^>\"]+)[>\"]"),
        QRegularExpression::MultilineOption);
    QList<Include> includes;
    QDirIterator files(root.filePath(folder), {QStringLiteral("*.h"), QStringLiteral("*.cpp")},
                       QDir::Files, QDirIterator::Subdirectories);
    while (files.hasNext()) {
        QFile file(files.next());
        if (!file.open(QIODevice::ReadOnly)) {
            continue;
        }
        auto matches = pattern.globalMatch(QString::fromUtf8(file.readAll()));
        while (matches.hasNext()) {
            includes.append({root.relativeFilePath(file.fileName()), matches.next().captured(1)});
        }
    }
    return includes;
}

/// The core's public header is a layer of its own, above the others.
QString folderOf(const QString& file) {
    return file == u"core/sparkout.h" ? file : file.section(u'/', 0, -2);
}

/// A folder, and those that its files include.
struct Row {
    QString folder;
    QStringList may;
};

/// Of docs/layers.txt; a row goes on in lines that begin with blanks.
QList<Row> rows() {
    QFile file(QStringLiteral(SPARKOUT_SOURCE_DIR "/docs/layers.txt"));
    QList<Row> rows;
    if (!file.open(QIODevice::ReadOnly)) {
        return rows;
    }
    for (const QString& line : QString::fromUtf8(file.readAll()).split(u'\n')) {
        if (line.isEmpty() || line.startsWith(u'#')) {
            continue;
        }
        if (!line.startsWith(u' ')) {
            rows.append({line.section(u':', 0, 0), {}});
        }
        rows.back().may += line.section(u':', -1).split(u' ', Qt::SkipEmptyParts);
    }
    return rows;
}

class TestLayers : public QObject {
    Q_OBJECT

private slots:
    void aRowNamesOnlyRowsAboveIt() {
        QStringList above;
        for (const Row& row : rows()) {
            QVERIFY2(!above.contains(row.folder), qPrintable(row.folder));
            for (const QString& other : row.may) {
                QVERIFY2(above.contains(other), qPrintable(row.folder + u' ' + other));
            }
            above << row.folder;
        }
        QVERIFY(above.size() > 30);
    }

    void everyFolderHasARow() {
        QSet<QString> named, found;
        for (const Row& row : rows()) {
            named << row.folder;
        }
        for (const char* top : {"core", "words", "ui", "app", "python"}) {
            for (const Include& include : includesBelow(QString::fromLatin1(top))) {
                found << folderOf(include.file);
            }
        }
        QCOMPARE(found, named);
    }

    void filesIncludeWhatTheirRowNames_data() {
        addColumns<QString, QStringList>("folder", "may");
        for (const Row& row : rows()) {
            QTest::newRow(qPrintable(row.folder)) << row.folder << row.may;
        }
    }
    void filesIncludeWhatTheirRowNames() {
        QFETCH(QString, folder);
        QFETCH(QStringList, may);
        static const QRegularExpression ours(QStringLiteral("^(core|words|ui|app|python)/"));
        QSet<QString> used;
        QStringList wrong;
        for (const Include& include : includesBelow(folder.section(u'/', 0, 0))) {
            const QString other = folderOf(include.text);
            if (folderOf(include.file) != folder || !ours.match(include.text).hasMatch()
                || other == folder) {
                continue;
            }
            used << other;
            if (!may.contains(other)) {
                wrong << include.file + QStringLiteral(" includes ") + include.text;
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
        for (const QString& other : may) {
            QVERIFY2(used.contains(other), qPrintable(QStringLiteral("not used: ") + other));
        }
    }

    void librariesStayInTheirLayers_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<QString>("forbidden"); // a regular expression on the include
        const auto row = [](const char* folder, const char* forbidden) {
            QTest::newRow(folder) << QString::fromLatin1(folder) << QString::fromLatin1(forbidden);
        };
        for (const char* folder : {"core", "words"}) {
            row(folder, "^(Q[A-Za-z]|qcustomplot)");
        }
        for (const char* folder : {"ui/text", "ui/session", "ui/table"}) {
            row(folder, "^(qcustomplot|QWidget|QApplication|QMainWindow|"
                        "Q[A-Za-z]*(Button|Dialog|Edit|Label|Layout|View|Box)$)");
        }
    }
    void librariesStayInTheirLayers() {
        QFETCH(QString, folder);
        QFETCH(QString, forbidden);
        const QRegularExpression pattern(forbidden);
        QVERIFY(pattern.match(QStringLiteral("qcustomplot.h")).hasMatch());
        QStringList wrong;
        for (const Include& include : includesBelow(folder)) {
            if (pattern.match(include.text).hasMatch()) {
                wrong << include.file + QStringLiteral(" includes ") + include.text;
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(u'\n')));
    }

    void everySourceNamesItsLicence() {
        const QDir root(QStringLiteral(SPARKOUT_SOURCE_DIR));
        QStringList without;
        for (const char* folder : {"app", "core", "words", "ui", "python", "tests"}) {
            QDirIterator files(root.filePath(QString::fromLatin1(folder)),
                               {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                               QDirIterator::Subdirectories);
            while (files.hasNext()) {
                QFile file(files.next());
                if (!file.open(QIODevice::ReadOnly)
                    || !file.readLine().contains("SPDX-License-Identifier: GPL-3.0-or-later")) {
                    without << root.relativeFilePath(file.fileName());
                }
            }
        }
        QVERIFY2(without.isEmpty(), qPrintable(without.join(QLatin1Char('\n'))));
    }

    void numbersNeverFollowTheLocale() {
        // strtod, stod and printf's %f read and write a comma under ru_RU.
        const QRegularExpression pattern(
            QStringLiteral("\\b(strtod|stod|atof|sscanf)\\b|printf\\([^;]*%[0-9.*]*[efgEFG]"));
        QStringList wrong;
        for (const char* folder : {"app", "core", "python"}) {
            QDirIterator files(
                QDir(QStringLiteral(SPARKOUT_SOURCE_DIR)).filePath(QString::fromLatin1(folder)),
                {QStringLiteral("*.h"), QStringLiteral("*.cpp")}, QDir::Files,
                QDirIterator::Subdirectories);
            while (files.hasNext()) {
                QFile file(files.next());
                QVERIFY(file.open(QIODevice::ReadOnly));
                const auto match = pattern.match(QString::fromUtf8(file.readAll()));
                if (match.hasMatch()) {
                    wrong << file.fileName() + QStringLiteral(": ") + match.captured(0);
                }
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    }
};

} // namespace sparkout::test_layers

SPARKOUT_TEST(test_layers, TestLayers)
#include "test_layers.moc"
