// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The cycle card in its three formats, read back with poppler's tools.
#include "core/project/machine.h"
#include "tests/ui/support/languages.h"
#include "tests/ui/support/report_reading.h"
#include "tests/ui/support/view_fixtures.h"
#include "ui/kit/pdf_details.h"
#include "ui/report/cycle_card.h"
#include "ui/report/format/pages.h"
#include "ui/report/format/report_text.h"
#include "ui/report/operation_setup.h"
#include "ui/results/verdict_table.h"
#include "ui/session/document.h"
#include "ui/text/field_text.h"
#include "ui/text/language.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/window/dialogs/examples_dialog.h"

#include <QRegularExpression>

#include <algorithm>
#include <clocale>

using namespace sparkout;
using report::Format;
using namespace reading;

namespace {

const QDate day(2026, 11, 22);

OutcomePtr outcomeOf(const QString& path) {
    Document document;
    return hasErrors(document.openCopy(ExamplesDialog::textOf(path)))
               ? nullptr
               : evaluate(document.project(), {});
}

QByteArray made(const OutcomePtr& outcome, Format format, const QDate& date = day) {
    return bytesOf(report::CycleCard::write(outcome, QStringLiteral("/tmp/part.sparkout"), date),
                   format);
}

/// Numbers that the card must hold, from the engine's result.
QStringList numbersOf(const Outcome& outcome) {
    QStringList numbers{
        verdict::time(outcome.result),
        threeDigits(TimeUnit(outcome.shop.cycle.time_s).of(outcome.shop.cycle.time_s))};
    for (const Stage& stage : outcome.result.project.cycle->stages) {
        const auto& feed = outcome.result.project.operation == Operation::traverse
                               ? stage.radial_feed_mm
                               : stage.radial_feed_mm_min;
        if (feed && stage.spark_out.mode == SparkOut::Mode::none) {
            numbers << showNumber(*feed, QLocale());
        }
    }
    for (const SectionResult& section : outcome.result.sections) {
        numbers << Names::signedMicrometres(section.diameterDeviationMin_mm * 1000)
                << Names::signedMicrometres(section.diameterDeviationMax_mm * 1000);
    }
    return numbers;
}

} // namespace

class TestReport : public QObject {
    Q_OBJECT

private slots:
    void init() { m_language.apply(QStringLiteral("en")); }

    void everyExampleHasItsNumbersInEveryFormat_data() {
        addFilesAndLanguages(ExamplesDialog::paths());
    }
    void everyExampleHasItsNumbersInEveryFormat() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const OutcomePtr outcome = outcomeOf(path);
        QVERIFY(outcome && outcome->ran());
        const QByteArray pdf = made(outcome, Format::pdf), html = made(outcome, Format::html);
        const QString markdown = QString::fromUtf8(made(outcome, Format::markdown));
        for (const QString& text : {textOf(pdf), textOfHtml(html), markdown}) {
            for (const QString& number : numbersOf(*outcome)) {
                QVERIFY2(text.contains(number), qPrintable(number + u'\n' + text));
            }
        }
        const QString info = told(QStringLiteral("pdfinfo"), {}, pdf);
        const auto title = report::CycleCard::write(outcome, {}, day).title;
        QVERIFY2(info.contains(title), qPrintable(info));
        QVERIFY2(info.contains(QStringLiteral("(A4)")), qPrintable(info));
        QCOMPARE(fontsLeftOut(pdf), QStringList());
        QVERIFY(!html.contains("<td></td>") && !html.contains("<dd></dd>"));
        QVERIFY(!html.contains("src=") && !html.contains("<link")); // nothing from elsewhere
        QCOMPARE(html.count("<svg"), 2);
        QCOMPARE(raggedRow(markdown), QString());
        QVERIFY(markdown.count(QStringLiteral("\n|")) > 10);
        static const QRegularExpression twice(QStringLiteral("^\\*(.+): \\1\\*$"),
                                              QRegularExpression::MultilineOption);
        QVERIFY(!markdown.contains(twice));
    }

    void theRussianCardHasNoEnglishWord_data() {
        addFilesAndLanguages(ExamplesDialog::paths(), {"ru"});
    }
    void theRussianCardHasNoEnglishWord() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        OutcomePtr outcome = outcomeOf(path);
        QVERIFY(outcome && outcome->ran());
        Project project = outcome->result.project; // without the texts of the user
        project.title = project.notes = project.author = project.part->name = {};
        project.machine->name = project.material->grade = project.wheel->marking = {};
        outcome = evaluate(project, {});
        QCOMPARE(englishWords(textOfHtml(made(outcome, Format::html))), QStringList());
    }

    void twoExportsOfOneProjectDifferByTheDateOnly() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        for (const Format format : {Format::html, Format::markdown}) {
            QCOMPARE(made(outcome, format), made(outcome, format));
            QByteArray other = made(outcome, format, day.addDays(1));
            QVERIFY(other != made(outcome, format));
            other.replace(dateText(day.addDays(1)).toUtf8(), dateText(day).toUtf8());
            QCOMPARE(other, made(outcome, format));
        }
        QCOMPARE(made(outcome, Format::pdf), made(outcome, Format::pdf)); // of one day
    }

    void thePdfHasItsProperties() {
        Project project = fixtures::traverseProject();
        project.title = "Вал (1) \\ shaft";
        project.author = "Ф. И. Отчество";
        const QByteArray pdf = made(fixtures::run(project), Format::pdf);
        const QString info = told(QStringLiteral("pdfinfo"), {}, pdf);
        for (const char* line :
             {"Title: +Cycle card .*Вал \\(1\\) \\\\ shaft\n", "Subject: +Вал \\(1\\)",
              "Author: +Ф\\. И\\. Отчество\n", "Creator: +Sparkout \\d", "22 .*2026"}) {
            const QRegularExpression wanted(QString::fromUtf8(line));
            QVERIFY2(info.contains(wanted), qPrintable(wanted.pattern() + u'\n' + info));
        }
    }

    void whatIsNoWholePdfGetsNoDetails() {
        const QByteArray pdf = made(fixtures::run(fixtures::traverseProject()), Format::pdf);
        QVERIFY(!withDetails(pdf, {}).isEmpty());
        QVERIFY(withDetails(pdf.left(pdf.size() / 2), {}).isEmpty());
        QVERIFY(withDetails("no PDF", {}).isEmpty());
        QVERIFY(withDetails({}, {}).isEmpty());
        QVERIFY(withDetails(pdf, {{}, {}, {}, {}, {}, {}, {{QStringLiteral("a"), 99, 0}}})
                    .isEmpty()); // there is no such page
    }

    void aLongTableRepeatsItsHeadOnEveryPage() {
        constexpr int most = 100; // stages of a cycle
        Project project = fixtures::traverseProject();
        project.gauge->control = Control::position;
        Stage stage = project.cycle->stages.front();
        stage.stock_mm = project.part->stock_mm / most;
        project.cycle->stages.assign(most, stage);
        const OutcomePtr outcome = fixtures::run(project);
        QVERIFY(outcome->ran());
        const QString text = textOf(made(outcome, Format::pdf));
        const QStringList pages = text.split(u'\f', Qt::SkipEmptyParts);
        const QString count = QString::number(pages.size());
        int withRows = 0;
        static const QRegularExpression row(QStringLiteral("^ *\\d+ +0\\.004 +1800 "),
                                            QRegularExpression::MultilineOption);
        qsizetype rows = 0;
        for (qsizetype i = 0; i < pages.size(); ++i) {
            QVERIFY2(pages[i].contains(QStringLiteral("page %1 of %2").arg(i + 1).arg(count)),
                     qPrintable(pages[i]));
            const qsizetype here = pages[i].count(row);
            rows += here;
            if (here > 0) {
                ++withRows;
                QVERIFY2(pages[i].contains(QStringLiteral("Spark-out")), qPrintable(pages[i]));
            }
        }
        QVERIFY(withRows >= 3);
        QCOMPARE(rows, most); // none is lost or cut
    }

    void hostileTextsStayTexts() {
        Project project = fixtures::traverseProject();
        project.title = "<script>alert(1)</script> | a\nb \x01 & \"q\" $x^2$ \u202Etxt";
        project.title.push_back('\0');
        project.title += "thereafter";
        project.part->name = "</title><svg onload=x>";
        project.machine->name = "a | b <img src=x>";
        project.notes = "<script>alert(2)</script>\n| x | y |\n# no heading\n1. no list\n*no*";
        const OutcomePtr outcome = fixtures::run(project);
        const QByteArray html = made(outcome, Format::html);
        QVERIFY(!textOfHtml(html).isEmpty());
        QVERIFY(!html.contains("<script") && !html.contains("<img") && html.count("<svg") == 2);
        const QString markdown = QString::fromUtf8(made(outcome, Format::markdown));
        QVERIFY(!markdown.contains(u'<')
                || markdown.count(u'<') == markdown.count(QStringLiteral("<br>")));
        for (const QString& text : {markdown, QString::fromUtf8(html)}) {
            QVERIFY(!text.contains(QChar(0)) && !text.contains(QChar(0x202e)));
            QVERIFY(text.contains(QStringLiteral("thereafter"))); // nor does a title end there
        }
        QVERIFY(markdown.contains(QStringLiteral("\\$x^2\\$")));
        QVERIFY(markdown.contains(QStringLiteral("a \\| b")));
        QVERIFY(markdown.contains(QStringLiteral("\n\\# no heading")));
        QVERIFY(markdown.contains(QStringLiteral("\n1\\. no list")));
        const QString text = textOf(made(outcome, Format::pdf));
        QVERIFY(text.contains(QStringLiteral("<script>alert(2)</script>")));
    }

    /// All stages remove the part's stock, a spark-out its own too.
    void theStocksOfTheCardAddUpToTheParts() {
        int sparkOuts = 0;
        for (const QString& path : ExamplesDialog::paths()) {
            const OutcomePtr outcome = outcomeOf(path);
            QVERIFY(outcome && outcome->ran());
            const Project& project = outcome->result.project;
            const report::Table table = report::OperationSetup::stages(*outcome);
            const auto column = table.head.indexOf(QStringLiteral("Stock per side, mm"));
            QVERIFY(column > 0);
            double sum = 0;
            for (std::size_t z = 0; z < project.cycle->stages.size(); ++z) {
                sum += QLocale().toDouble(table.rows.at(z).at(column));
                sparkOuts +=
                    project.cycle->stages[z].spark_out.mode == SparkOut::Mode::none ? 0 : 1;
            }
            QVERIFY2(std::abs(sum - project.part->stock_mm) < 1e-9, qPrintable(path));
            QCOMPARE(QLocale().toDouble(table.rows.back().at(column)), project.part->stock_mm);
        }
        QVERIFY(sparkOuts > 1);
    }

    void theCardStatesNoSizeWhereStripsStayUncut() {
        Project project = fixtures::traverseProject();
        project.part->tolerance.roughness_ra_um = 1.6;
        project.cycle->stages.back().axial_feed_mm_min =
            2 * project.wheel->width_mm * project.machine->work_speed_rpm;
        const OutcomePtr outcome = fixtures::run(project);
        QVERIFY(outcome->ran());
        for (const QStringList& row : report::CycleCard::accuracy(*outcome).rows) {
            QCOMPARE(row.at(2), QStringLiteral("–"));
            QCOMPARE(row.at(3), QStringLiteral("–"));
            QCOMPARE(row.at(4), QStringLiteral("–")); // runout
            QCOMPARE(row.at(5), QStringLiteral("–")); // roundness
            QCOMPARE(row.back(), QStringLiteral("–"));
        }
        const QString text = textOf(made(outcome, Format::pdf)).simplified();
        QVERIFY(text.contains(QStringLiteral("Not met: overlap")));
        QVERIFY2(text.contains(QStringLiteral("strips stay uncut")), qPrintable(text));
    }

    void theCardSaysWhereTheMachineIsNotKnown() {
        Project project = fixtures::traverseProject();
        project.machine->geometric_runout_um = 0;
        const auto heads = [&project] {
            const QStringList head = report::CycleCard::accuracy(*fixtures::run(project)).head;
            return std::pair(head.at(4), head.at(5));
        };
        const auto plain =
            std::pair(QStringLiteral("Radial runout, µm"), QStringLiteral("Roundness, µm"));
        const QString unknown = QStringLiteral(", machine not known");
        QVERIFY(heads() == std::pair(plain.first + unknown, plain.second + unknown));
        project.machine->geometric_runout_um = 1;
        QVERIFY(heads() == std::pair(plain.first, plain.second + unknown));
        project.machine->form = MachineForm{{{1, 2, 1}}, {{2, 3, 2}}, {}, {}};
        QVERIFY(heads() == plain);
        const QString text = textOf(made(fixtures::run(project), Format::pdf)).simplified();
        QVERIFY(!text.contains(QStringLiteral("machine not known")));
        QVERIFY2(text.contains(QStringLiteral("with an even number of lobes the diameters")),
                 qPrintable(text));
        project.machine->form.reset();
        QVERIFY(textOf(made(fixtures::run(project), Format::pdf))
                    .simplified()
                    .contains(QStringLiteral("machine not known")));
    }

    void cardSaysHowTheCycleStands() {
        Project project = fixtures::traverseProject();
        project.machine->geometric_runout_um = 10; // of 6 allowed
        const OutcomePtr outcome = fixtures::run(project);
        const auto holds = std::ranges::all_of(outcome->constraints, &ConstraintResult::holds);
        QVERIFY(!holds);
        QVERIFY(textOf(made(outcome, Format::pdf)).contains(QStringLiteral("Not met: ")));
        m_language.apply(QStringLiteral("ru"));
        const QString russian = textOf(made(outcome, Format::pdf));
        QVERIFY(russian.contains(QStringLiteral("Не выполнено: ")));
        QVERIFY(russian.contains(QStringLiteral("стр. 1 из ")));
    }

private:
    Language m_language;
};

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // as the program does
    TestReport test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_report.moc"
