// SPDX-License-Identifier: GPL-3.0-or-later
// The course hand-out: its numbers worked out again from the print, its questions run again, its
// formats read back, and the dialog that asks what it is to have.
#include "core/project/project_file.h"
#include "core/simulation/simulate.h"
#include "tests/core/formula_reader.h"
#include "tests/ui/report_reading.h"
#include "tests/ui/view_fixtures.h"
#include "ui/dialogs/examples_dialog.h"
#include "ui/dialogs/handout_dialog.h"
#include "ui/language.h"
#include "ui/report/course_handout.h"
#include "ui/report/exercises.h"
#include "ui/report/formula_markup.h"
#include "ui/report/pages.h"
#include "ui/report/report_text.h"
#include "ui/session/cycle_cursor.h"
#include "ui/session/document.h"
#include "ui/session/settings.h"
#include "ui/session/source_names.h"
#include "ui/views/formula_text.h"

#include <QApplication>
#include <QCheckBox>
#include <QComboBox>
#include <QFileInfo>
#include <QPushButton>
#include <QRegularExpression>
#include <QTest>

#include <algorithm>
#include <clocale>
#include <cmath>

using namespace sparkout;
using report::Format;
using report::Formula;
using report::HandoutOptions;
using report::HandoutView;
using report::Report;

namespace {

const QDate today(2026, 11, 22);

OutcomePtr exampleOutcome(const QString& path) {
    Document document;
    return hasErrors(document.openCopy(ExamplesDialog::textOf(path)))
               ? nullptr
               : runProject(document.project(), {});
}

/// With everything that limits the feed.
Project fullProject(Project project) {
    project.part.tolerance.roughness_ra_um = 0.4;
    project.material.burn_rise_k = 700;
    project.machine.wheel_drive_kw = 7.5;
    project.machine.work_drive_kw = 1;
    project.wheel.grain_surface_energy_j_m2 = 18;
    project.wheel.grain_modulus_gpa = 390;
    project.wheel.bond_surface_energy_j_m2 = 4;
    project.wheel.bond_modulus_gpa = 65;
    return project;
}

Report handout(const OutcomePtr& outcome, const HandoutOptions& options = {}) {
    return report::courseHandout(outcome, QStringLiteral("/tmp/part.sparkout"), today, options);
}

std::vector<Formula> formulasOf(const Report& report) {
    std::vector<Formula> formulas;
    for (const report::Block& block : report.blocks) {
        if (const auto* formula = std::get_if<Formula>(&block)) {
            formulas.push_back(*formula);
        }
    }
    return formulas;
}

/// A printed number as C reads it: "8,38·10⁻⁷" as "8.38e-07".
QString plainNumbers(QString text) {
    static const QRegularExpression power(QStringLiteral("·10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)"));
    static const QString raised = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    for (auto found = power.match(text); found.hasMatch(); found = power.match(text)) {
        QString exponent = QStringLiteral("e");
        for (const QChar c : found.captured(1)) {
            exponent += c == u'⁻' ? QChar(u'-') : QChar(u'0' + int(raised.indexOf(c)));
        }
        text.replace(found.capturedStart(), found.capturedLength(), exponent);
    }
    return text.replace(QLocale().decimalPoint(), QStringLiteral("."));
}

/// The value of a printed expression, by the reader of the engine's tests.
double worthOf(const QString& printed) {
    const std::string text = "{x} = " + plainNumbers(printed).toStdString();
    FormulaStep step;
    step.text = text.c_str();
    step.result = {"x", 0, ""};
    return fixtures::workOut(step).value;
}

/// The number before the unit, and half a unit of its last digit.
std::pair<double, double> printedResult(const QString& text) {
    const QString number = plainNumbers(text.section(QChar::Nbsp, 0, 0)).replace(u'−', u'-');
    const QString mantissa = number.section(u'e', 0, 0);
    const qsizetype point = mantissa.indexOf(u'.');
    const qsizetype decimals = point < 0 ? 0 : mantissa.size() - point - 1;
    const int power = number.contains(u'e') ? number.section(u'e', 1).toInt() : 0;
    return {number.toDouble(), 0.5 * std::pow(10.0, double(power - decimals))};
}

QString onOneLine(QString text) {
    return text.replace(QChar::Nbsp, u' ').simplified();
}

void addCases(const std::vector<const char*>& languages = {"en", "ru"}) {
    QTest::addColumn<QString>("path");
    QTest::addColumn<QString>("language");
    for (const QString& path : ExamplesDialog::paths()) {
        for (const char* language : languages) {
            QTest::addRow("%s %s", qPrintable(QFileInfo(path).baseName()), language)
                << path << QString::fromLatin1(language);
        }
    }
}

/// Symbols in an expression: what is no number, function or sign.
void addSymbols(const report::FormulaNode& node, std::set<QString>& symbols) {
    static const QStringList functions{QStringLiteral("π"), QStringLiteral("exp"),
                                       QStringLiteral("tg"), QStringLiteral("ierfc"),
                                       QStringLiteral("ierfc⁻¹")};
    if (node.kind == report::FormulaNode::Kind::text && !node.text.front().isDigit()
        && !functions.contains(node.text)) {
        symbols.insert(node.text);
    }
    for (const report::FormulaNode& part : node.parts) {
        addSymbols(part, symbols);
    }
}

/// What is asked for, read off a run by this test.
double measured(report::Asked asked, const SimulationResult& result, const Visit* visit) {
    using report::Asked;
    double low = 1e9, high = -1e9, runout = 0;
    for (const SectionResult& section : result.sections) {
        low = std::min(low, section.diameterDeviationMin_mm);
        high = std::max(high, section.diameterDeviationMax_mm);
        runout = std::max(runout, section.radialRunout_mm);
    }
    switch (asked) {
    case Asked::stepFeed_um: return visit->actual_mm * 1000;
    case Asked::stepForce_n: return visit->normalForce_n;
    case Asked::time_min: return result.time_s / 60;
    case Asked::count: return result.cycleCount;
    case Asked::spread_um: return (high - low) * 1000;
    case Asked::runout_um: return runout * 1000;
    case Asked::peakForce_n: return result.peakNormalForce_n;
    case Asked::peakPower_kw: return result.peakPower_w / 1000;
    }
    return 0;
}

const Visit* visitOf(const Trajectory& trajectory, const Place& place, int radius) {
    for (const Pass& pass : trajectory.passes) {
        const Place& at = pass.place;
        if (at.zone == place.zone && at.section == place.section && at.stage == place.stage
            && at.step == place.step && at.cycleCount == place.cycleCount
            && at.revolution == place.revolution) {
            return &trajectory.visits[pass.firstVisit + static_cast<std::size_t>(radius)];
        }
    }
    return nullptr;
}

} // namespace

class TestHandout : public QObject {
    Q_OBJECT

    /// Every equation worked out from its print; how many had numbers put in.
    static int workedOut(const Report& report) {
        int count = 0;
        for (const Formula& formula : formulasOf(report)) {
            const QString whole = inOneLine(formula);
            const auto [value, half] = printedResult(inOneLine(formula.sides.back()));
            if (formula.sides.size() < 3) {
                continue; // it states what the engine found
            }
            const QString numbers = inOneLine(formula.sides[formula.sides.size() - 2]);
            const double worth = worthOf(numbers);
            if (!(std::abs(worth - value) <= half * (1 + 1e-9))) {
                qWarning("%s: %.12g", qPrintable(whole), worth);
                return -1;
            }
            ++count;
        }
        return count;
    }

private slots:
    void init() { m_language.apply(QStringLiteral("en")); }

    void thePrintedNumbersGiveThePrintedResult_data() { addCases(); }
    void thePrintedNumbersGiveThePrintedResult() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const OutcomePtr outcome = exampleOutcome(path);
        QVERIFY(outcome && outcome->ran());
        const auto stages = static_cast<int>(outcome->result.project.cycle.stages.size());
        for (int stage = 1; stage <= stages; ++stage) {
            HandoutOptions options{.views = {}, .answers = false};
            options.step.stage = stage;
            options.step.radius = 5 * stage;
            QVERIFY(workedOut(handout(outcome, options)) >= 15);
        }
    }

    void soTheyDoWhereEverythingLimitsTheFeed() {
        Project coupled = fullProject(fixtures::plungeProject(3));
        coupled.machine.compliance_mm_per_n = {};
        coupled.machine.stiffness_n_um = Stiffness{};
        coupled.part.shaft.segments = {{120, 30}};
        coupled.part.shaft.ground_from_mm = 40;
        coupled.sections_coupled = true;
        Project sharp = fullProject(fixtures::traverseProject());
        sharp.wheel.dullness = 0;
        for (const Project& project : {fullProject(fixtures::traverseProject()),
                                       fullProject(fixtures::plungeProject(3)), coupled, sharp}) {
            const OutcomePtr outcome = fixtures::run(project);
            QVERIFY(outcome->ran());
            for (const char* step : {"z1", "z2", "1,k0", "3,k9"}) {
                const HandoutOptions options{.step = *report::readStepWish(QLatin1String(step)),
                                             .views = {},
                                             .answers = false};
                QVERIFY(workedOut(handout(outcome, options)) >= 20);
            }
        }
    }

    void theBalanceIsOfTheStepThatWasChosen() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const HandoutOptions options{.step = *report::readStepWish(QStringLiteral("20,nz,e2,k7"))};
        const Report made = handout(outcome, options);
        const Place place{Zone::nz, Step::e2, 1, 1, 20, 1};
        const Visit* visit = visitOf(outcome->trajectory, place, 7);
        QVERIFY(visit && visit->actual_mm > 0);
        QStringList lines;
        for (const Formula& formula : formulasOf(made)) {
            lines << inOneLine(formula.sides.front()) + u'=' + inOneLine(formula.sides.back());
        }
        const QString a = formulaNumber({"a", visit->actual_mm, "mm"}, 4);
        QVERIFY2(lines.contains(QStringLiteral("a=%1\u00a0mm").arg(a)),
                 qPrintable(lines.join(u'\n')));
        const QString force = formulaNumber({"P_y", visit->normalForce_n, "N"}, 4);
        QVERIFY(lines.contains(QStringLiteral("P_y=%1\u00a0N").arg(force)));
        const QString left = formulaNumber({"R_k′", visit->radius_mm, "mm"}, 4);
        QVERIFY(lines.contains(QStringLiteral("R_k′=%1\u00a0mm").arg(left)));
    }

    void everySymbolIsExplained() {
        for (const Project& project :
             {fullProject(fixtures::traverseProject()), fullProject(fixtures::plungeProject(2))}) {
            const Report made = handout(fixtures::run(project));
            std::set<QString> used, explained;
            for (const report::Block& block : made.blocks) {
                if (const auto* formula = std::get_if<Formula>(&block)) {
                    addSymbols(formula->sides[0], used);
                    addSymbols(formula->sides[1], used);
                } else if (const auto* table = std::get_if<report::Table>(&block);
                           table && table->symbols) {
                    for (const QStringList& row : table->rows) {
                        explained.insert(row.front());
                        addSymbols(report::leafNode(row.front(), 0), explained);
                    }
                }
            }
            QVERIFY(used.size() > 30);
            for (const QString& symbol : used) {
                QVERIFY2(explained.contains(symbol), qPrintable(symbol));
            }
        }
    }

    void theAnswersAreThoseOfTheChangedProject_data() { addCases({"en"}); }
    void theAnswersAreThoseOfTheChangedProject() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const OutcomePtr outcome = exampleOutcome(path);
        const auto step = report::findStep(outcome->trajectory, report::usualStep());
        QVERIFY(step);
        const std::vector<report::Exercise> exercises = report::makeExercises(*outcome, step);
        QVERIFY(exercises.size() >= 3 && exercises.size() <= 5);
        const QString text =
            reading::textOfHtml(bytesOf(handout(outcome), Format::html)).simplified();
        for (const report::Exercise& exercise : exercises) {
            QVERIFY(!sameProject(exercise.changed, outcome->result.project));
            Trajectory trajectory;
            const SimulationResult result = simulate(exercise.changed, &trajectory);
            QCOMPARE(exercise.status, result.status);
            QVERIFY(text.contains(onOneLine(exercise.question)) && exercise.answers.size() >= 3);
            for (const report::Answer& answer : exercise.answers) {
                const auto visit = [&](const Trajectory& in) {
                    return exercise.at ? visitOf(in, *exercise.at, step->radius) : nullptr;
                };
                QCOMPARE(answer.before,
                         measured(answer.asked, outcome->result, visit(outcome->trajectory)));
                QCOMPARE(answer.after, measured(answer.asked, result, visit(trajectory)));
                const QString row = onOneLine(
                    QStringList{askedName(answer.asked, outcome->result.project.operation),
                                askedNumber(answer.asked, answer.before),
                                askedNumber(answer.asked, answer.after)}
                        .join(u' '));
                QVERIFY2(text.contains(row), qPrintable(row));
            }
        }
    }

    void theFirstQuestionDullsTheWheelAndNothingElse() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const auto exercises =
            report::makeExercises(*outcome, report::findStep(outcome->trajectory));
        Project changed = exercises.front().changed;
        QCOMPARE(changed.wheel.dullness, 2 * outcome->result.project.wheel.dullness);
        changed.wheel.dullness = outcome->result.project.wheel.dullness;
        QVERIFY(sameProject(changed, outcome->result.project));
        const report::Answer& force = exercises.front().answers.at(1);
        QCOMPARE(force.asked, report::Asked::stepForce_n);
        QVERIFY(force.after > force.before);
    }

    void theKeyIsALastPageOfItsOwnAndCanBeLeftOut() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const auto pagesOf = [&](bool answers) {
            const HandoutOptions options{.answers = answers};
            return reading::textOf(bytesOf(handout(outcome, options), Format::pdf))
                .split(u'\f', Qt::SkipEmptyParts);
        };
        const QStringList with = pagesOf(true), without = pagesOf(false);
        QCOMPARE(with.size(), without.size() + 1);
        const QStringList last = with.last().split(u'\n', Qt::SkipEmptyParts);
        QCOMPARE(last.value(0).trimmed(), QStringLiteral("Answers")); // nothing names the part
        for (const QString& page : without) {
            QVERIFY(!page.contains(QStringLiteral("Answers")));
            QVERIFY(!page.contains(QStringLiteral("Difference, %")));
        }
    }

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
        const QStringList fonts = reading::told(QStringLiteral("pdffonts"), {}, pdf)
                                      .split(u'\n', Qt::SkipEmptyParts)
                                      .mid(2);
        static const QRegularExpression embedded(QStringLiteral("\\byes +(yes|no) +(yes|no) +\\d"));
        QVERIFY(!fonts.isEmpty());
        for (const QString& font : fonts) {
            QVERIFY2(font.contains(embedded), qPrintable(font));
        }
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
        static const QRegularExpression bar(QStringLiteral("(?<!\\\\)\\|"));
        qsizetype columns = 0;
        for (const QString& line : text.split(u'\n')) {
            const qsizetype now = line.startsWith(u'|') ? line.count(bar) : 0;
            QVERIFY2(columns == 0 || now == 0 || now == columns, qPrintable(line));
            QVERIFY2(!line.contains(QStringLiteral("|  |")), qPrintable(line));
            columns = now;
        }
    }

    void theRussianHandoutHasNoEnglishWord() {
        m_language.apply(QStringLiteral("ru"));
        for (Project project :
             {fullProject(fixtures::traverseProject()), fullProject(fixtures::plungeProject(2))}) {
            project.machine.name = project.material.grade = project.wheel.marking = {};
            HandoutOptions options;
            options.views.insert(HandoutView::limits);
            QString text = reading::textOfHtml(
                bytesOf(handout(fixtures::run(project), options), Format::html));
            for (const auto& [key, name] : sourceTexts()) {
                text.remove(key);
            }
            static const QRegularExpression english(QStringLiteral("\\b[A-Za-z]{3,}\\b"));
            QStringList words;
            for (auto it = english.globalMatch(text); it.hasNext();) {
                words << it.next().captured();
            }
            for (const char* kept : {"Sparkout", "part", "sparkout", "HRC", "Srad", "rad", "max0",
                                     "exp", "ierfc", "RONt"}) { // names, symbols, functions
                words.removeAll(QString::fromLatin1(kept));
            }
            QVERIFY2(words.isEmpty(), qPrintable(words.join(u' ')));
        }
    }

    void hostileTextsStayTexts() {
        Project project = fixtures::traverseProject();
        project.title = "<script>alert(1)</script> | a\nb \x01 & \"q\"";
        project.part.name = "</title><svg onload=x>";
        project.author = "<math><mi>x</mi></math>";
        const Report made = handout(fixtures::run(project));
        const QByteArray html = bytesOf(made, Format::html);
        QVERIFY(!reading::textOfHtml(html).isEmpty());
        QVERIFY(!html.contains("<script") && html.count("<svg") == 4);
        QCOMPARE(html.count("<math "), qsizetype(formulasOf(made).size()));
        QVERIFY(!html.contains("<math>"));
        const QString markdown = QString::fromUtf8(bytesOf(made, Format::markdown));
        QVERIFY(!markdown.contains(QStringLiteral("<script"))
                && !markdown.contains(QStringLiteral("<math")));
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

    void aStepIsReadFromWords_data() {
        QTest::addColumn<QString>("words");
        QTest::addColumn<bool>("good");
        for (const char* good : {"12", "12,nz,z1,e1,r1,k9", "rz2", " k0 , RZ1", "s0,3"}) {
            QTest::newRow(good) << QString::fromLatin1(good) << true;
        }
        for (const char* bad :
             {"", "12,,k1", "12,13", "nz,rz1", "q3", "k-1", "k", "z1.5", "e1 2"}) {
            QTest::newRow(bad) << QString::fromLatin1(bad) << false;
        }
    }
    void aStepIsReadFromWords() {
        QFETCH(QString, words);
        QFETCH(bool, good);
        QCOMPARE(report::readStepWish(words).has_value(), good);
    }

    void ofTheStepsThatFitTheDeepestCutIsTaken() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        const Trajectory& trajectory = outcome->trajectory;
        const auto step =
            report::findStep(trajectory, *report::readStepWish(QStringLiteral("rz1,z2,e5")));
        QVERIFY(step);
        double deepest = 0;
        for (const Pass& pass : trajectory.passes) {
            for (int k = 0; k < trajectory.radii; ++k) {
                const double a =
                    trajectory.visits[pass.firstVisit + static_cast<std::size_t>(k)].actual_mm;
                const Place& at = pass.place;
                if (at.zone == Zone::rz1 && at.stage == 2 && at.step == Step::e5) {
                    deepest = std::max(deepest, a);
                }
            }
        }
        QVERIFY(deepest > 0);
        QCOMPARE(report::visitAt(trajectory, *step)->actual_mm, deepest);
        QVERIFY(!report::findStep(trajectory, *report::readStepWish(QStringLiteral("99999"))));
        QVERIFY(!report::findStep(trajectory, *report::readStepWish(QStringLiteral("s1"))));
    }

    void theDialogOffersTheStepTheCycleStandsAt() {
        const OutcomePtr outcome = fixtures::run(fixtures::traverseProject());
        CycleCursor cursor;
        cursor.setOutcome(outcome);
        Settings settings = Settings::transient();
        {
            HandoutDialog dialog(outcome, cursor, settings, nullptr);
            const report::StepWish wish = dialog.options().step;
            QCOMPARE(wish.stage, std::optional(1)); // at the end nobody has chosen
            QVERIFY(!wish.count && dialog.options().answers);
            QCOMPARE(dialog.options().views, HandoutOptions().views);
        }
        cursor.toStroke(4);
        cursor.step(CursorUnit::radius, -3);
        HandoutDialog dialog(outcome, cursor, settings, nullptr);
        const auto step = report::findStep(outcome->trajectory, dialog.options().step);
        QVERIFY(step);
        QCOMPARE(step->radius, cursor.radius());
        QCOMPARE(step->pass, cursor.progress().open);
        dialog.findChild<QCheckBox*>(QStringLiteral("view-cycle"))->click();
        dialog.findChild<QCheckBox*>(QStringLiteral("handoutAnswers"))->click();
        dialog.findChild<QPushButton*>(QStringLiteral("makeHandout"))->click();
        QCOMPARE(dialog.result(), int(QDialog::Accepted));
        const HandoutDialog again(outcome, cursor, settings, nullptr);
        QCOMPARE(again.options().views, (std::set{HandoutView::feeds, HandoutView::profiles}));
        QVERIFY(!again.options().answers);
    }

    void aCycleThatWasNotRecordedHasNoStepButQuestions() {
        auto outcome = std::make_shared<Outcome>(*fixtures::run(fixtures::traverseProject()));
        outcome->trajectory = {};
        outcome->feeds = {};
        outcome->limits = {};
        const Report made = handout(outcome);
        QVERIFY(formulasOf(made).empty());
        const QString text = reading::textOfHtml(bytesOf(made, Format::html));
        QVERIFY(text.contains(QStringLiteral("too long to be recorded")));
        QVERIFY(text.contains(QStringLiteral("Questions")));
        CycleCursor cursor;
        Settings settings = Settings::transient();
        HandoutDialog dialog(outcome, cursor, settings, nullptr);
        QVERIFY(!dialog.findChild<QComboBox*>()->isEnabled());
    }

private:
    Language m_language;
};

int main(int argc, char** argv) {
    QApplication app(argc, argv);
    std::setlocale(LC_NUMERIC, "C"); // as the program does
    TestHandout test;
    return QTest::qExec(&test, argc, argv);
}
#include "test_handout.moc"
