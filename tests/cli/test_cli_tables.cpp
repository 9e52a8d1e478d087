// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Every table of commas that the program writes, of a project whose texts are hostile: nothing but
// line ends steers a display, and no text is a formula.
#include "tests/cli/cli_bench.h"
#include "tests/registry.h"

namespace test_cli_tables {

using namespace sparkout;
using namespace cli;

class TestCliTables : public FolderTest {
    Q_OBJECT

private slots:
    void initTestCase() {
        begin();
        for (const char* name : {"complete", "internal-plunge"}) {
            json project = samples::sample(name);
            project["title"] = hostile;
            project["author"] = project["notes"] = project["part"]["name"] = hostile;
            project["material"]["grade"] = project["machine"]["name"] = hostile;
            project["sweep"] = {
                {"inputs",
                 {{{"input", "/wheel/dullness"}, {"from", 0.01}, {"to", 0.04}, {"points", 2}}}}};
            project["batch"] = {{"parts", 3},
                                {"factors", {{"dullness", {{"uniform", {0.015, 0.03}}}}}}};
            m_files << save(QString::fromLatin1(name) + ".sparkout", project.dump());
        }
    }

    void noTableSteersOrReckons() {
        int tables = 0, cells = 0;
        for (const QString& file : m_files) {
            const QString trace = m_folder.filePath("trace.csv");
            QCOMPARE(run({"simulate", file, "--trace", trace}).status, 0);
            const std::vector<std::string> written{samples::readText(trace.toStdString()),
                                                   run({"batch", file, "--csv"}).out,
                                                   run({"sweep", file, "--csv"}).out};
            QFile::remove(trace);
            for (const std::string& table : written) {
                cells += checkTable(QString::fromStdString(table));
                ++tables;
            }
        }
        QCOMPARE(tables, 6);
        QVERIFY(cells > 1000);
    }

    /// The same of what is printed for people.
    void noReportSteersTheTerminal() {
        for (const QString& file : m_files) {
            for (const char* command : {"simulate", "batch", "sweep"}) {
                const ProcessOutcome outcome = run({command, file});
                QCOMPARE(outcome.status, 0);
                checkPlain(QString::fromStdString(outcome.out + outcome.err));
            }
        }
    }

private:
    static void checkPlain(const QString& text) {
        for (const QChar c : text) {
            QVERIFY2(c == u'\n' || (c.isPrint() && c.unicode() != 0x202E),
                     qPrintable(QString::number(c.unicode(), 16)));
        }
    }

    static int checkTable(const QString& table) {
        checkPlain(table);
        int count = 0;
        const QStringList rows = table.split(u'\n', Qt::SkipEmptyParts);
        for (const QString& row : rows) {
            for (const QString& cell : row.split(u',')) {
                bool number = false;
                cell.toDouble(&number);
                const QString inside = cell.startsWith(u'"') ? cell.mid(1) : cell;
                [&] {
                    QVERIFY2(number || inside.isEmpty()
                                 || !QStringView(u"=+-@").contains(inside[0]),
                             qPrintable(cell));
                }();
                ++count;
            }
        }
        return count;
    }

    inline static const std::string hostile = "=cmd|' /C calc'!A0\u202E\x1b[2J";
    QStringList m_files;
};

} // namespace test_cli_tables

SPARKOUT_TEST(test_cli_tables, TestCliTables)
#include "test_cli_tables.moc"
