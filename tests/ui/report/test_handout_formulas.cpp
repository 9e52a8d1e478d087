// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: numbers
// The formulas of the course hand-out: their numbers worked out again from the print.
#include "tests/core/support/formula_reader.h"
#include "tests/registry.h"
#include "tests/ui/report/handout_bench.h"
#include "ui/report/format/formula_writer.h"
#include "ui/text/formula_text.h"

#include <QRegularExpression>

#include <cmath>
#include <set>
#include <utility>

namespace sparkout::test_handout_formulas {

using namespace handout_bench;

/// A printed number as C reads it: "8,38·10⁻⁷" as "8.38e-07", "10⁻⁷" as "1e-07".
QString plainNumbers(QString text) {
    static const QRegularExpression power(QStringLiteral("(·|(?<![\\d.,]))10([⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)"));
    static const QString raised = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
    for (auto found = power.match(text); found.hasMatch(); found = power.match(text)) {
        QString exponent = found.captured(1).isEmpty() ? QStringLiteral("1e") : QStringLiteral("e");
        for (const QChar c : found.captured(2)) {
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

/// Every equation worked out from its print; how many had numbers put in.
int workedOut(const Report& report) {
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

class TestHandoutFormulas : public QObject {
    Q_OBJECT

private slots:
    void init() { m_language.apply(QStringLiteral("en")); }

    void thePrintedNumbersGiveThePrintedResult_data() { addCases(); }
    void thePrintedNumbersGiveThePrintedResult() {
        QFETCH(QString, path);
        QFETCH(QString, language);
        m_language.apply(language);
        const OutcomePtr outcome = exampleOutcome(path);
        QVERIFY(outcome && outcome->ran());
        const auto stages = static_cast<int>(outcome->result.project.cycle->stages.size());
        for (int stage = 1; stage <= stages; ++stage) {
            HandoutOptions options{.views = {}, .answers = false};
            options.step.stage = stage;
            options.step.radius = 5 * stage;
            QVERIFY(workedOut(handout(outcome, options)) >= 15);
        }
    }

    void soTheyDoWhereEverythingLimitsTheFeed() {
        Project coupled = fullProject(fixtures::plungeProject(3));
        coupled.machine->compliance_mm_per_n = {};
        coupled.machine->stiffness_n_um = Stiffness{};
        coupled.part->shaft.segments = {{120, 30}};
        coupled.part->shaft.ground_from_mm = 40;
        coupled.sections_coupled = true;
        Project sharp = fullProject(fixtures::traverseProject());
        sharp.wheel->dullness = 0;
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

private:
    Language m_language;
};

} // namespace sparkout::test_handout_formulas

SPARKOUT_TEST(test_handout_formulas, TestHandoutFormulas)
#include "test_handout_formulas.moc"
