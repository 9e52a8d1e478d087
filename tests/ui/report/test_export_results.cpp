// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// Results and traces on their way to other programs: the numbers of the engine, to the last bit.
#include "core/file/project_file.h"
#include "core/quality/verdict.h"
#include "core/simulation/progress.h"
#include "tests/registry.h"
#include "tests/ui/report/export_bench.h"
#include "tests/ui/support/file_trouble.h"

namespace sparkout::test_export_results {

using namespace export_bench;

QList<QStringList> linesOf(QByteArray csv, QChar separator) {
    QList<QStringList> lines;
    csv.replace("\xEF\xBB\xBF", "").replace("\r", "");
    for (const QByteArray& line : csv.trimmed().split('\n')) {
        lines << QString::fromUtf8(line).split(separator);
    }
    return lines;
}

/// What sparkout-cli prints of a project.
QByteArray fromCommandLine(const QStringList& arguments) {
    QProcess program;
    program.start(QStringLiteral(SPARKOUT_BUILD_DIR "/app/sparkout-cli"), arguments);
    program.waitForFinished(60'000);
    return program.readAllStandardOutput();
}

class TestExportResults : public ExportTest {
    Q_OBJECT

private slots:
    void initTestCase() { begin(); }

    void theWorkbookHoldsTheResultBitForBit_data() {
        QTest::addColumn<bool>("traverse");
        QTest::newRow("traverse") << true;
        QTest::newRow("plunge") << false;
    }

    void theWorkbookHoldsTheResultBitForBit() {
        QFETCH(bool, traverse);
        const OutcomePtr outcome =
            fixtures::run(smallProject(traverse ? Operation::traverse : Operation::plunge));
        const XlsxReader read = reread(bytesOf(outcome, {ExportFormat::xlsx, everyPart()}));
        QCOMPARE(read.fault(), QString());
        QCOMPARE(read.text("title"), QStringLiteral("=Вал <30h6>"));
        QCOMPARE(read.text("author"), QStringLiteral("А. Иванов"));
        QVERIFY(read.text("program").startsWith(QStringLiteral("Sparkout ")));
        const QStringList names = {QStringLiteral("Inputs"),
                                   QStringLiteral("Whole cycle"),
                                   QStringLiteral("Stages"),
                                   traverse ? QStringLiteral("Zones") : QStringLiteral("Sections"),
                                   QStringLiteral("Final profiles"),
                                   QStringLiteral("Requirements")};
        QCOMPARE(read.names().mid(0, 6), names);
        QCOMPARE(read.names().size(), 9);
        QCOMPARE(read.names()[6],
                 traverse ? QStringLiteral("Trace RZ1") : QStringLiteral("Trace Section 1"));
        checkRequirements(read, *outcome);
        checkZones(read, *outcome);
        checkTrace(read, *outcome);
        checkNoFormula(read);
    }

    void theInputsStandWithSymbolUnitValueAndKey() {
        Project project = smallProject(Operation::traverse);
        project.part->stock_mm = 0.1 + 0.05; // no short decimal
        const XlsxReader read =
            reread(bytesOf(fixtures::run(project), {ExportFormat::xlsx, {ResultPart::inputs}}));
        int seen = 0;
        for (int row = 1; row < read.rows(0); ++row) {
            const QString key = read.text(0, row, 4);
            if (key == u"/part/stock_mm") {
                QVERIFY(sameBits(read.number(0, row, 3), project.part->stock_mm));
                QCOMPARE(read.text(0, row, 2), QStringLiteral("mm"));
                QVERIFY(!read.text(0, row, 1).isEmpty());
                ++seen;
            } else if (key == u"/title") { // a text that a spreadsheet would calculate
                QCOMPARE(read.type(0, row, 3), QStringLiteral("s"));
                QCOMPARE(read.text(0, row, 3), QStringLiteral("=Вал <30h6>"));
                QVERIFY(read.quoted(0, row, 3));
                ++seen;
            }
        }
        QCOMPARE(seen, 2);
    }

    void theTraceInCsvIsThatOfTheCommandLine_data() {
        QTest::addColumn<bool>("russian");
        QTest::newRow("Russian Excel") << true;
        QTest::newRow("English") << false;
    }

    void theTraceInCsvIsThatOfTheCommandLine() {
        QFETCH(bool, russian);
        const QString trace = m_folder.filePath(QStringLiteral("trace.csv"));
        const QString project = projectFile();
        (void)fromCommandLine(
            {QStringLiteral("simulate"), project, QStringLiteral("--trace"), trace});
        const QList<QStringList> wanted = linesOf(trouble::bytesOf(trace), u',');
        const auto format = russian ? ExportFormat::csvRussian : ExportFormat::csvEnglish;
        const QByteArray bytes =
            bytesOf(fixtures::run(projectOf(project)), {format, {ResultPart::trace}});
        QVERIFY(bytes.startsWith("\xEF\xBB\xBF"));
        QList<QStringList> lines = linesOf(bytes, russian ? u';' : u',');
        QVERIFY(wanted.size() > 1000);
        QCOMPARE(lines.size(), wanted.size());
        for (qsizetype row = 1; row < lines.size(); ++row) {
            QCOMPARE(lines[row].size(), wanted[row].size());
            for (qsizetype i = 0; i < wanted[row].size(); ++i) {
                if (i == 3) { // the section, which the table names, counted from 1
                    QVERIFY(lines[row][i].endsWith(
                        QStringLiteral(" %1").arg(wanted[row][i].toInt() + 1)));
                    continue;
                }
                bool isNumber = false;
                const double value = wanted[row][i].toDouble(&isNumber);
                QString cell = lines[row][i];
                QVERIFY(!isNumber || !cell.contains(russian ? u'.' : u','));
                QVERIFY(!isNumber || sameBits(cell.replace(u',', u'.').toDouble(), value));
            }
        }
    }

    void everyPartGoesIntoCsvOfItsOwn() {
        const OutcomePtr outcome = fixtures::run(smallProject(Operation::traverse));
        for (const ResultPart part : allResultParts) {
            const QByteArray bytes = bytesOf(outcome, {ExportFormat::csvRussian, {part}});
            const auto lines = bytes.count("\r\n");
            QCOMPARE(lines, qsizetype(partSheet(outcome, part).rows) + 1);
            QVERIFY2(lines > 2, partKey(part));
        }
    }

    void jsonIsTheObjectOfTheCommandLine() {
        const QString project = projectFile();
        const QByteArray wanted =
            fromCommandLine({QStringLiteral("simulate"), project, QStringLiteral("--json")});
        QVERIFY(wanted.size() > 1000);
        QCOMPARE(bytesOf(fixtures::run(projectOf(project)), {ExportFormat::json, {}}), wanted);
    }

private:
    XlsxReader reread(const QByteArray& bytes) {
        const QString path = m_folder.filePath(QStringLiteral("book.xlsx"));
        trouble::write(path, bytes);
        return XlsxReader(path);
    }

    QString projectFile() {
        return QStringLiteral(SPARKOUT_SOURCE_DIR "/tests/data/projects/smallest-plunge.sparkout");
    }

    static Project projectOf(const QString& path) {
        const QByteArray bytes = trouble::bytesOf(path);
        return readProject(bytes.toStdString()).project.value();
    }

    static void checkRequirements(const XlsxReader& read, const Outcome& outcome) {
        const int head = read.rows(5) - static_cast<int>(outcome.constraints.size());
        QCOMPARE(head, 2); // names and units: of what is used up
        for (std::size_t i = 0; i < outcome.constraints.size(); ++i) {
            const ConstraintResult& c = outcome.constraints[i];
            const int row = head + static_cast<int>(i);
            QVERIFY(sameBits(read.number(5, row, 2), c.value));
            QVERIFY(sameBits(read.number(5, row, 3), c.limit));
            const bool isKnown = marginKnown(c) == MarginKnown::exactly;
            QVERIFY(isKnown ? sameBits(read.number(5, row, 4), c.margin)
                            : read.text(5, row, 4).isEmpty());
            QVERIFY(!read.text(5, row, 1).isEmpty());
        }
    }

    static void checkZones(const XlsxReader& read, const Outcome& outcome) {
        QCOMPARE(read.text(3, 1, 1), QStringLiteral("mm"));
        QCOMPARE(read.text(3, 1, 3), QStringLiteral("µm"));
        for (std::size_t i = 0; i < outcome.result.sections.size(); ++i) {
            const SectionResult& section = outcome.result.sections[i];
            const int row = 2 + static_cast<int>(i);
            QVERIFY(sameBits(read.number(3, row, 1), section.position_mm));
            QVERIFY(sameBits(read.number(3, row, 2), section.compliance_mm_per_n));
            QVERIFY(sameBits(read.number(3, row, 3), section.diameterDeviationMin_mm * 1000));
            QVERIFY(sameBits(read.number(3, row, 5), section.radialRunout_mm * 1000));
        }
    }

    /// Every visit of every zone, in their order.
    static void checkTrace(const XlsxReader& read, const Outcome& outcome) {
        const bool traverse = outcome.result.project.operation == Operation::traverse;
        const int first = traverse ? 7 : 5; // column of the programmed feed
        std::vector<int> rows(outcome.result.sections.size(), 2);
        for (const Pass& pass : outcome.trajectory.passes) {
            const auto section = sectionOf(pass.place);
            const int sheet = 6 + static_cast<int>(section);
            for (int k = 0; k < outcome.trajectory.radii; ++k) {
                const int row = rows[section]++;
                const Visit& visit = outcome.trajectory.visits[pass.firstVisit + std::size_t(k)];
                QVERIFY(sameBits(read.number(sheet, row, 0), visit.time_s / 60));
                QVERIFY(sameBits(read.number(sheet, row, first), visit.programmed_mm));
                QVERIFY(sameBits(read.number(sheet, row, first + 1), visit.actual_mm));
                QVERIFY(sameBits(read.number(sheet, row, first + 2), visit.accumulated_mm));
                QVERIFY(sameBits(read.number(sheet, row, first + 4), visit.normalForce_n));
            }
        }
        for (std::size_t i = 0; i < rows.size(); ++i) {
            QCOMPARE(read.rows(6 + static_cast<int>(i)), rows[i]);
            QCOMPARE(read.text(6, 1, first), QStringLiteral("mm"));
            QCOMPARE(read.frozen(6), QStringLiteral("A3"));
        }
    }
};

} // namespace sparkout::test_export_results

SPARKOUT_TEST(test_export_results, TestExportResults)
#include "test_export_results.moc"
