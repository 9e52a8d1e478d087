// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The formats of the course hand-out, read back: pages, a web page, Markdown; languages, figures.
#include "core/search/state_grid.h"
#include "tests/registry.h"
#include "tests/ui/report/handout_bench.h"
#include "tests/ui/support/report_reading.h"
#include "ui/report/format/formula_writer.h"
#include "ui/report/format/pages.h"
#include "ui/text/texts.h"
#include "ui/views/study/state_grid_text.h"

#include <QRegularExpression>

#include <utility>

namespace sparkout::test_handout_formats {

using namespace handout_bench;

class TestHandoutFormats : public QObject {
    Q_OBJECT

private slots:
    void init() { m_language.apply(QStringLiteral("en")); }

    void everyExampleMakesPagesWithEmbeddedFonts_data() {
        addCases();
        QTest::newRow("every input there is")
            << QStringLiteral(SPARKOUT_SOURCE_DIR "/tests/data/projects/everything.sparkout")
            << QStringLiteral("en");
    }

    void everyExampleMakesPagesWithEmbeddedFonts() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const OutcomePtr outcome = exampleOutcome(path);
        const Report made = handout(outcome);
        const QByteArray pdf = bytesOf(made, Format::pdf);
        const QString text = reading::textOf(pdf);
        for (const Formula& formula : formulasOf(made)) {
            const QString number = inOneLine(formula.sides.back()).section(QChar::Nbsp, 0, 0);
            QVERIFY2(text.contains(number), qPrintable(number));
            QVERIFY(text.contains(formula.label));
        }
        const QString info = reading::told(QStringLiteral("pdfinfo"), {}, pdf);
        QVERIFY2(info.contains(made.title) && info.contains(QStringLiteral("(A4)")),
                 qPrintable(info));
        QCOMPARE(reading::fontsLeftOut(pdf), QStringList());
    }

    void theWebPageHasTheFormulasAsMathMl_data() { addCases({"ru"}); }
    void theWebPageHasTheFormulasAsMathMl() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const Report made = handout(exampleOutcome(path));
        const QByteArray html = bytesOf(made, Format::html);
        QVERIFY(!reading::textOfHtml(html).isEmpty());
        QCOMPARE(html.count("<math "), qsizetype(formulasOf(made).size()));
        QVERIFY(html.contains("<mfrac>") && html.contains("<msqrt>") && html.contains("<msub>"));
        QVERIFY(!html.contains("src=") && !html.contains("<link"));
        QCOMPARE(html.count("<svg"), 4); // the sketch and three figures
    }

    void theMarkdownHasTheFormulasInALine_data() { addCases({"en"}); }
    void theMarkdownHasTheFormulasInALine() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const Report made = handout(exampleOutcome(path));
        QString text = QString::fromUtf8(bytesOf(made, Format::markdown));
        QVERIFY(text.contains(QStringLiteral("k<sub>s</sub> = ")));
        static const QRegularExpression tags(QStringLiteral("</?su[bp]>|<br>"));
        QVERIFY(!text.remove(tags).contains(u'<'));
        QCOMPARE(reading::raggedRow(text), QString());
    }

    // Both answers and the way back are the engine's.
    void theGridOfDynamicProgrammingIsPrinted() {
        for (const char* name : {"shaft-30h6-factory", "plunge-shaft-two-stage"}) {
            const OutcomePtr outcome =
                exampleOutcome(QStringLiteral(":/examples/%1.sparkout").arg(QLatin1String(name)));
            QVERIFY(outcome);
            const Project& project = outcome->result.project;
            const auto grid = fillStateGrid(project, usualStateGrid(project));
            const ExactAnswer exact = exactAnswer(*grid);
            const HandoutOptions options{.views = {HandoutView::grid}};
            const Report report = handout(outcome, options);
            QStringList paragraphs;
            int figures = 0;
            std::vector<std::size_t> rows;
            for (const report::Block& block : report.blocks) {
                if (const auto* paragraph = std::get_if<report::Paragraph>(&block)) {
                    paragraphs << paragraph->text;
                } else if (const auto* table = std::get_if<report::Table>(&block)) {
                    if (table->head.contains(QStringLiteral("m*"))) {
                        rows.push_back(table->rows.size());
                    }
                } else if (std::holds_alternative<report::Figure>(block)) {
                    ++figures;
                }
            }
            QVERIFY(paragraphs.contains(StateGridText::ruleAnswer(*grid)));
            QVERIFY(paragraphs.contains(StateGridText::provenAnswer(exact)));
            QVERIFY(figures >= 1);
            QVERIFY(rows
                    == (grid->time_s ? std::vector<std::size_t>{10} : std::vector<std::size_t>{}));
        }
    }

    void theRussianHandoutHasNoEnglishWord() {
        m_language.apply(QStringLiteral("ru"));
        for (Project project :
             {fullProject(fixtures::traverseProject()), fullProject(fixtures::plungeProject(2))}) {
            project.machine->name = project.material->grade = project.wheel->marking = {};
            HandoutOptions options;
            options.views.insert(HandoutView::limits);
            options.views.insert(HandoutView::grid);
            QString text = reading::textOfHtml(
                bytesOf(handout(fixtures::run(project), options), Format::html));
            for (const auto& [key, name] : sourceTexts()) {
                text.remove(key);
            }
            QCOMPARE(reading::englishWords(text, {"rad", "max0", "exp", "ierfc", "RONt", "min"}),
                     QStringList());
        }
    }

    void onlyTheFiguresAskedForAreThere() {
        const OutcomePtr outcome = fixtures::run(fullProject(fixtures::traverseProject()));
        for (const auto& [words, count] :
             {std::pair("", 0), std::pair("limits", 1), std::pair("profiles,feeds", 2),
              std::pair("feeds,cycle,profiles,limits", 4)}) {
            const HandoutOptions options{.views = *report::readHandoutViews(QLatin1String(words))};
            const QByteArray html = bytesOf(handout(outcome, options), Format::html);
            QCOMPARE(html.count("<svg"), 1 + count);
            QCOMPARE(report::readHandoutViews(report::handoutViewText(options.views)),
                     std::optional(options.views));
        }
        QVERIFY(!report::readHandoutViews(QStringLiteral("feeds,film")));
    }

    void theFeedsOfTheStepNameItsStages() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const HandoutOptions options{.views = {HandoutView::feeds}};
        const QString text = reading::textOfHtml(bytesOf(handout(outcome, options), Format::html));
        for (const char* step : {"E1", "E2", "E3", "E4"}) {
            QVERIFY2(text.contains(QLatin1String(step) + u' '), step);
        }
    }

private:
    Language m_language;
};

} // namespace sparkout::test_handout_formats

SPARKOUT_TEST(test_handout_formats, TestHandoutFormats)
#include "test_handout_formats.moc"
