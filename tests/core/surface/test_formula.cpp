// SPDX-License-Identifier: GPL-3.0-or-later
// What a formula sheet says must be what the engine computed: every equation is read back, worked
// out from its numbers and held against its result, units included.
#include "core/surface/formula.h"

#include "core/quality/power.h"
#include "core/quality/roughness.h"
#include "core/quality/visit_sheet.h"
#include "core/surface/accuracy.h"
#include "core/surface/burn.h"
#include "tests/core/support/formula_reader.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/registry.h"

#include <QFile>

#include <map>

namespace sparkout::test_formula {

using fixtures::anyCutting;
using fixtures::between;
using fixtures::close;
using fixtures::decades;
using fixtures::FormulaError;
using fixtures::holds;
using fixtures::workOut;

std::string plain(const FormulaTerm& term) {
    return QString::number(term.value).toStdString();
}

struct Case {
    Project project;
    double a, b, h, U;
};

std::vector<FormulaSheet> everySheet(const Case& c) {
    const Project& p = c.project;
    const std::vector<double> first{15.001, 15, 14.999, 15.002, 15, 15.003};
    const std::vector<double> last{15.004, 15.001, 15, 15.002, 15.002, 15.001};
    const std::vector<SectionShape> sections{{10, first}, {80, last}};
    const PartAccuracy part = partAccuracy(sections, 0.001);
    return {normalForceSheet(p, c.b, c.a),
            tangentialForceSheet(p, c.b, c.a),
            balanceSheet(p, c.b, c.h * 1e-4, c.a),
            burnLimitSheet(p, c.U, c.h),
            burnLimitSheet(p, c.U, 0),
            roughnessSheet(p, c.a),
            roughnessSheet(p, {.depth_mm = c.a,
                               .overlap = 1 + c.b / 50,
                               .pressed_mm = 3 * c.a,
                               .step_s = 0.4,
                               .sparkOut_s = 2 * c.b / 100,
                               .at = {}}),
            roughnessLimitSheet(p, c.a / 10, c.b),
            *selfSharpeningSheet(p),
            wheelPowerSheet(p, c.b, c.a),
            workPowerSheet(p, c.b, c.a),
            wheelPowerLimitSheet(p, c.b, 1e6 * c.b),
            workPowerLimitSheet(p, c.b, 1e4 * c.b),
            radialRunoutSheet(sections[0], 0.001),
            totalRunoutSheet(sections, 0.001),
            roundnessSheet(part.sections[0].minimumZone),
            cylindricitySheet(part.minimumZone)};
}

Case anyCase() {
    Case c{anyCutting(), decades(-5, -1), between(1, 100), decades(-4, -0.5), between(200, 1500)};
    Wheel& wheel = *c.project.wheel;
    wheel.grain_surface_energy_j_m2 = decades(0, 4);
    wheel.grain_modulus_gpa = between(50, 900);
    wheel.bond_surface_energy_j_m2 = decades(0, 4);
    wheel.bond_modulus_gpa = between(10, 300);
    if (fixtures::oneIn(2)) {
        wheel.bond_bridge_mm = between(0.01, 1);
        wheel.grains_per_mm2 = between(0.5, 50);
    }
    return c;
}

class TestFormula : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { setRapidcheckRuns(500); }

    void everyEquationIsWhatItsNumbersGive() {
        QVERIFY(holds("worked out", [] {
            for (const FormulaSheet& sheet : everySheet(anyCase())) {
                RC_ASSERT(!sheet.steps.empty());
                for (const FormulaStep& step : sheet.steps) {
                    const fixtures::Quantity said = workOut(step);
                    if (!(std::abs(said.value - step.result.value) <= 4 * said.uncertainty)) {
                        RC_FAIL(std::string(sheet.name) + ": " + formulaInNumbers(step, plain)
                                + " is " + std::to_string(said.value) + ", stated "
                                + std::to_string(step.result.value));
                    }
                }
            }
        }));
    }

    // A later equation takes over what an earlier one gave, number and unit.
    void numbersPassFromStepToStep() {
        QVERIFY(holds("passed on", [] {
            for (const FormulaSheet& sheet : everySheet(anyCase())) {
                std::map<std::string, FormulaTerm> results;
                for (const FormulaStep& step : sheet.steps) {
                    for (const FormulaTerm& term : step.terms) {
                        const auto earlier = results.find(term.symbol);
                        if (isConstant(term) || earlier == results.end()) {
                            continue;
                        }
                        RC_ASSERT(close(term.value, earlier->second.value, 1e-12));
                        RC_ASSERT(std::string(term.unit) == earlier->second.unit);
                    }
                    results.insert_or_assign(step.result.symbol, step.result);
                }
            }
        }));
    }

    // The sheet is filled by the function that computes, so the last digit is the same.
    void resultIsTheFunctionsOwn() {
        QVERIFY(holds("same number", [] {
            const Case c = anyCase();
            const Project& p = c.project;
            const BurnModel burn(p);
            const double root = std::sqrt(c.a);
            const std::pair<FormulaSheet, double> expected[] = {
                {normalForceSheet(p, c.b, c.a), forceLaw(p).normal(c.b, root)},
                {tangentialForceSheet(p, c.b, c.a), forceLaw(p).tangential(c.b, root)},
                {burnLimitSheet(p, c.U, c.h), burn.limitDepth(c.U, c.h)},
                {roughnessSheet(p, c.a), RoughnessModel(p).roughness(c.a)},
                {wheelPowerSheet(p, c.b, c.a), PowerModel(p).wheelPower(c.b, c.a)},
                {workPowerSheet(p, c.b, c.a), PowerModel(p).workPower(c.b, c.a)},
                {wheelPowerLimitSheet(p, c.b, 1e6), PowerModel(p).wheelLimitDepth(c.b, 1e6)},
                {workPowerLimitSheet(p, c.b, 1e4), PowerModel(p).workLimitDepth(c.b, 1e4)},
            };
            for (const auto& [sheet, value] : expected) {
                RC_ASSERT(sheet.result().value == value);
            }
            const auto wheel = selfSharpening(p);
            const FormulaSheet limit = *selfSharpeningSheet(p);
            RC_ASSERT(limit.result().value == wheel->limitDepth().value_or(wheel->allowed));
        }));
    }

    // The balance's depth is that of the engine's pass: the full-law case of the vectors, first
    // revolution of 5 µm.
    void balanceOfTheVectorsComesOut() {
        const FormulaSheet sheet = balanceSheet(fixtures::plunge(), 40, 2e-5, 0.005);
        const FormulaStep& depth = sheet.steps[sheet.steps.size() - 2];
        QCOMPARE(depth.result.symbol, "a");
        QVERIFY(fixtures::within(depth.result.value * 1000, 2.244004, 0.5e-6));
        QVERIFY(fixtures::within(
            sheet.result().value,
            2e-5 * forceLaw(fixtures::plunge()).normal(40, std::sqrt(depth.result.value)), 1e-15));
    }

    // Every source is a key of core/SOURCES.md.
    void sourcesAreKeysOfTheList() {
        QFile file(QStringLiteral(SPARKOUT_SOURCE_DIR "/core/SOURCES.md"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray list = file.readAll();
        Case c{fixtures::plunge(), 0.005, 40, 0.1, 700};
        c.project.wheel->grain_surface_energy_j_m2 = 18;
        c.project.wheel->grain_modulus_gpa = 390;
        c.project.wheel->bond_surface_energy_j_m2 = 4;
        c.project.wheel->bond_modulus_gpa = 65;
        for (const FormulaSheet& sheet : everySheet(c)) {
            QVERIFY(*sheet.name);
            const QByteArray key(sheet.source);
            const bool model = key.startsWith("MODEL-");
            QVERIFY2(list.contains("| " + (model ? QByteArray("MODEL-1 … MODEL-16") : key) + " |"),
                     key.constData());
        }
    }

    void textIsWrittenInSymbolsAndInNumbers() {
        const FormulaSheet sheet = normalForceSheet(fixtures::plunge(), 40, 0.0025);
        const FormulaStep& friction = sheet.steps[3];
        QCOMPARE(formulaInSymbols(friction, plain), std::string("k_r = η·σ_i·√(D_e)/3"));
        QCOMPARE(formulaInNumbers(friction, plain), std::string("0.02·2000·√(28.5714)/3"));
        QCOMPARE(sheet.result().symbol, "P_y");
        QCOMPARE(sheet.result().unit, "N");
        const std::string units = fillFormula(friction, [](const FormulaTerm& term) {
            return isConstant(term) ? plain(term) : std::string("[") + term.unit + "]";
        });
        QCOMPARE(units, std::string("[N/mm^1.5] = []·[MPa]·√([mm])/3"));
    }

    void textThatNamesNoTermStaysAsItIs() {
        const FormulaStep step{"{x} = {y} + {z", {"x", 1, ""}, {{"q", 2, ""}}};
        QCOMPARE(formulaInSymbols(step, plain), std::string("x = y + {z"));
    }

    // What the reader allows for roundings stays small, but for what cancels in print.
    void roundingsAllowedAreFew() {
        for (const FormulaStep& step : normalForceSheet(fixtures::plunge(), 40, 0.005).steps) {
            QVERIFY(workOut(step).uncertainty <= 1e-13 * std::abs(step.result.value));
        }
    }

    // The reader itself refuses what is wrong, else the tests above could not fail.
    void readerSeesWrongEquations_data() {
        addColumns<QByteArray, bool>("text", "readable");
        QTest::newRow("right") << QByteArray("{F} = {a}·{p}") << true;
        QTest::newRow("unit") << QByteArray("{F} = {a}/{p}") << false;
        QTest::newRow("sum") << QByteArray("{F} = {a}·{p} + {a}") << false;
        QTest::newRow("unused") << QByteArray("{F} = {p}·{p}") << false;
        QTest::newRow("no term") << QByteArray("{F} = {a}·{p}·{q}") << false;
        QTest::newRow("other result") << QByteArray("{G} = {a}·{p}") << false;
        QTest::newRow("rest") << QByteArray("{F} = {a}·{p})") << false;
    }
    void readerSeesWrongEquations() {
        QFETCH(QByteArray, text);
        QFETCH(bool, readable);
        const FormulaStep step{text.constData(), {"F", 6, "N"}, {{"a", 2, "mm²"}, {"p", 3, "MPa"}}};
        if (readable) {
            QCOMPARE(workOut(step).value, 6.0);
        } else {
            QVERIFY_THROWS_EXCEPTION(FormulaError, workOut(step));
        }
    }
};

} // namespace sparkout::test_formula

SPARKOUT_TEST(test_formula, TestFormula)
#include "test_formula.moc"
