// SPDX-License-Identifier: GPL-3.0-or-later
// The layers of the tree, read from its includes: app → ui → core, widgets → session, and inside
// the core batch → quality → simulation → process → project → field.
#include "tests/registry.h"

#include <QDirIterator>
#include <QFile>
#include <QRegularExpression>
#include <QSet>
#include <QTest>

namespace test_layers {

namespace {

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

class TestLayers : public QObject {
    Q_OBJECT

private slots:
    void noIncludeGoesUp_data() {
        QTest::addColumn<QString>("folder");
        QTest::addColumn<QString>("forbidden"); // a regular expression on the include
        const auto row = [](const char* folder, const char* forbidden) {
            QTest::newRow(folder) << QString::fromLatin1(folder) << QString::fromLatin1(forbidden);
        };
        row("core", "^(Q[A-Za-z]|qcustomplot|ui/|app/)");
        row("core/project", "^core/(process|simulation|quality|batch|sweep|optimisation)/");
        row("core/process", "^core/(simulation|quality|batch|sweep|optimisation)/");
        // the limits of a depth of cut, which know no cycle, are watched pass by pass
        row("core/simulation", "^core/(quality/(?!burn_table\\.h)|batch|sweep|optimisation)/");
        row("core/quality", "^core/(batch|sweep|optimisation)/");
        row("core/batch", "^core/(sweep|optimisation)/");
        row("core/sweep", "^core/optimisation/");
        row("core/optimisation", "^core/sweep/");
        row("ui/session", "^(app/|ui/(?!session/)|qcustomplot|QWidget|QApplication|QMainWindow|"
                          "Q[A-Za-z]*(Button|Dialog|Edit|Label|Layout|View|Box)$)");
        row("ui", "^app/");
    }
    void noIncludeGoesUp() {
        QFETCH(QString, folder);
        QFETCH(QString, forbidden);
        const QList<Include> includes = includesBelow(folder);
        QVERIFY2(!includes.isEmpty(), qPrintable(folder));
        const QRegularExpression pattern(forbidden);
        QStringList wrong;
        for (const Include& include : includes) {
            if (pattern.match(include.text).hasMatch()) {
                wrong << include.file + QStringLiteral(" includes ") + include.text;
            }
        }
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    }

    void limitsOfADepthOfCutKnowNoCycle() {
        const QRegularExpression limits(QStringLiteral("^core/quality/(burn|burn_table|cutting|"
                                                       "formula|ierfc|rising_root)\\.(h|cpp)$"));
        QSet<QString> seen;
        QStringList wrong;
        for (const Include& include : includesBelow(QStringLiteral("core/quality"))) {
            if (!limits.match(include.file).hasMatch()) {
                continue;
            }
            seen.insert(include.file);
            const bool allowed = !include.text.startsWith(QLatin1String("core/simulation/"))
                                 && (!include.text.startsWith(QLatin1String("core/quality/"))
                                     || limits.match(include.text).hasMatch());
            if (!allowed) {
                wrong << include.file + QStringLiteral(" includes ") + include.text;
            }
        }
        QVERIFY(seen.size() >= 8);
        QVERIFY2(wrong.isEmpty(), qPrintable(wrong.join(QLatin1Char('\n'))));
    }

    void aForbiddenIncludeIsSeen() {
        QVERIFY(QRegularExpression(QStringLiteral("^(Q[A-Za-z])"))
                    .match(QStringLiteral("QString"))
                    .hasMatch());
        bool found = false;
        for (const Include& include : includesBelow(QStringLiteral("ui/session"))) {
            found = found || include.text == QStringLiteral("core/project/project.h");
        }
        QVERIFY2(found, "the includes are read");
    }

    void everySourceNamesItsLicence() {
        const QDir root(QStringLiteral(SPARKOUT_SOURCE_DIR));
        QStringList without;
        for (const char* folder : {"app", "core", "ui", "tests"}) {
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
        for (const char* folder : {"app", "core"}) {
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

} // namespace

} // namespace test_layers

SPARKOUT_TEST(test_layers, TestLayers)
#include "test_layers.moc"
