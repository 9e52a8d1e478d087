// SPDX-License-Identifier: GPL-3.0-or-later
// The laws a factor may follow, what it stands for, and where feeding starts in a batch.
#include "core/batch/batch_run.h"
#include "core/batch/scenario_source.h"
#include "core/batch/usual_batch.h"
#include "core/file/blanks_csv.h"
#include "core/process/system_compliance.h"

#include "tests/core/support/batch_fixtures.h"
#include "tests/registry.h"

#include <map>
#include <numeric>
#include <set>

namespace sparkout::test_batch_factors {

using fixtures::close;
using fixtures::uniform;
using fixtures::within;

/// Share of a triangular law below x, integrated from its density by hand.
double triangularShare(double x, double a, double c, double b) {
    return x <= c ? (x - a) * (x - a) / ((b - a) * (c - a))
                  : 1 - (b - x) * (b - x) / ((b - a) * (b - c));
}

/// One factor over a Latin hypercube.
std::vector<double> valuesOf(std::optional<Factor> Factors::*factor, const Factor& law, int parts) {
    Project project = fixtures::plunge();
    project.batch = Batch{};
    project.batch->parts = parts;
    project.batch->factors.*factor = law;
    const ScenarioSource source(project);
    std::vector<double> values;
    for (std::int64_t part = 0; part < source.parts(); ++part) {
        values.push_back(source.values(part).at(0));
    }
    return values;
}

double meanOf(const std::vector<double>& values) {
    return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Fed to a position, with stocks that scatter about the nominal 0.2 mm.
Project positionBatch(Project project) {
    project.gauge->control = Control::position;
    project.batch = Batch{};
    project.batch->parts = 20;
    project.batch->factors.stock_mm = uniform(0.17, 0.23);
    return project;
}

std::vector<MeasuredColumn> columnsOf(const char* csv) {
    const auto read = readMeasuredBlanks(csv);
    const auto* columns = std::get_if<std::vector<MeasuredColumn>>(&read);
    return columns ? *columns : std::vector<MeasuredColumn>();
}

class TestBatchFactors : public QObject {
    Q_OBJECT

private slots:
    void aTriangularFactorHasItsShares_data() {
        QTest::addColumn<double>("mode");
        addRow("inside", 0.16);
        addRow("at the low end", 0.1);
        addRow("at the high end", 0.2);
    }
    void aTriangularFactorHasItsShares() {
        QFETCH(double, mode);
        const GivenFactor factor{FactorKind::stock, fixtures::triangular(0.1, mode, 0.2), {0, 10}};
        for (const double share : {1e-9, 0.01, 0.3, 0.5, 0.6, 0.61, 0.9, 1 - 1e-9}) {
            const double x = factorQuantile(factor, share);
            QVERIFY(x >= 0.1 && x <= 0.2);
            QVERIFY(within(triangularShare(x, 0.1, mode, 0.2), share, 1e-9));
        }
        const auto values =
            valuesOf(&Factors::stock_mm, fixtures::triangular(0.1, mode, 0.2), 5000);
        QVERIFY(within(meanOf(values), (0.1 + mode + 0.2) / 3, 1e-5)); // of a hypercube: ~ N⁻³ᐟ²
        QCOMPARE(cornerEnds(factor).low, 0.1);
        QCOMPARE(cornerEnds(factor).high, 0.2);
    }

    void cornersOfANormalFactorAreThreeDeviationsAwayOrItsTruncation() {
        GivenFactor factor{FactorKind::stock, fixtures::normal(0.2, 0.01), {0, 10}};
        QVERIFY(within(cornerEnds(factor).low, 0.17, 1e-15));
        QVERIFY(within(cornerEnds(factor).high, 0.23, 1e-15));
        factor.law.normal = {0.02, 0.01};
        QCOMPARE(cornerEnds(factor).low, 0.0); // what is allowed
        factor.law.within = {0.015, 0.022};
        QCOMPARE(cornerEnds(factor).low, 0.015);
        QCOMPARE(cornerEnds(factor).high, 0.022);
    }

    /// Whatever the compliance comes from, each of its terms is as many times as large.
    /// A quarter of IT10 of the diameter before grinding in each direction: 100 µm from 30 to 50
    /// mm, 120 µm up to 80 mm.
    void usualStockScattersAsTurningLeavesIt() {
        Project project = fixtures::plunge();
        const auto usual = [&project](double diameter_mm, double stock_mm) {
            project.part->diameter_mm = diameter_mm;
            project.part->stock_mm = stock_mm;
            return *usualFactor(FactorKind::stock, project).uniform;
        };
        using Ends = std::vector<double>;
        QCOMPARE(usual(40, 0.15), (Ends{0.125, 0.175}));
        QCOMPARE(usual(49.8, 0.15), (Ends{0.12, 0.18})); // 50.1 mm when turned
        project.part->surface = Surface::internal;
        QCOMPARE(usual(50.2, 0.15), (Ends{0.125, 0.175})); // 49.9 mm
        project.part->surface = Surface::external;
        QCOMPARE(usual(40, 0.05), (Ends{0.033, 0.067})); // a third of a small stock
        QCOMPARE(usual(40, 0.5), (Ends{0.465, 0.535}));  // 7 % of a large one
        QCOMPARE(usual(600, 0.5), (Ends{0.465, 0.535})); // beyond the standard's sizes
    }

    void aFactorOfTheComplianceMultipliesAllOfIt() {
        const Project project = fixtures::steppedTraverse();
        Project softer = project;
        putFactor(FactorKind::compliance, 1.25, softer);
        const auto before = complianceAlong(project, 21), after = complianceAlong(softer, 21);
        QCOMPARE(after.size(), std::size_t{21});
        for (std::size_t i = 0; i < after.size(); ++i) {
            const ComplianceParts &a = before[i].parts, &b = after[i].parts;
            QVERIFY(close(b.wheelHead, 1.25 * a.wheelHead, 1e-12));
            QVERIFY(within(b.headstock, 1.25 * a.headstock, 1e-18));
            QVERIFY(within(b.tailstock, 1.25 * a.tailstock, 1e-18));
            QVERIFY(within(b.bending, 1.25 * a.bending, 1e-18));
            QVERIFY(within(b.rests, 1.25 * a.rests, 1e-18));
        }
    }

    void equalEndsAreAConstant() {
        for (const Factor& law : {uniform(0.2, 0.2), fixtures::normal(0.2, 0),
                                  fixtures::triangular(0.2, 0.2, 0.2), fixtures::measured({0.2})}) {
            for (const double value : valuesOf(&Factors::stock_mm, law, 9)) {
                QCOMPARE(value, 0.2);
            }
        }
    }

    void ofMeasuredBlanksEachIsAsFrequentAsAnyOther() {
        const Factor law = fixtures::measured({0.21, 0.18, 0.2, 0.18, 0.23});
        std::map<double, int> counts;
        for (const double value : valuesOf(&Factors::stock_mm, law, 50)) {
            ++counts[value];
        }
        const std::map<double, int> expected{{0.18, 20}, {0.2, 10}, {0.21, 10}, {0.23, 10}};
        QVERIFY(counts == expected);
        Project project = fixtures::plunge();
        project.batch = Batch{};
        project.batch->factors.stock_mm = law;
        const FactorEnds ends = cornerEnds(givenFactors(project).at(0));
        QVERIFY(ends.low == 0.18 && ends.high == 0.23);
    }

    void theContactWidthIsTheWheelsInTraverseAndThePartsInPlunge() {
        Project traverse = fixtures::traverse(), plunge = fixtures::plunge();
        for (Project* project : {&traverse, &plunge}) {
            project->batch = Batch{};
            project->batch->factors.contact_width_mm = uniform(30, 39);
            QVERIFY(checkBatch(*project).empty());
        }
        const ScenarioSource strokes(traverse), sections(plunge);
        for (std::int64_t part = 0; part < 5; ++part) {
            const Project stroked = strokes.project(part), plunged = sections.project(part);
            QCOMPARE(stroked.wheel->width_mm, strokes.values(part).at(0));
            QCOMPARE(stroked.part->length_mm, traverse.part->length_mm);
            QCOMPARE(plunged.part->length_mm, sections.values(part).at(0));
            QCOMPARE(plunged.wheel->width_mm, plunge.wheel->width_mm);
        }
    }

    // --- position control: the datum is the nominal blank's [MODEL-7] ---------------------------

    void atTheNominalBlankTheDatumChangesNothing() {
        Project project = fixtures::traverse();
        project.gauge->control = Control::position;
        const SimulationResult own = simulateUnchecked(project);
        project.gauge->datum_mm = makeBlank(*project.part).totalInfeed_mm;
        QVERIFY(fixtures::sameBits(simulateUnchecked(project), own));
        project.gauge->control = Control::gauge;
        const SimulationResult gauged = simulateUnchecked(project);
        project.gauge->datum_mm.reset();
        QVERIFY(fixtures::sameBits(simulateUnchecked(project), gauged)); // not read then
    }

    // The wheel head goes through the same positions for every part: the same time; and a system
    // that does not yield leaves every part as they leave the nominal one.
    void fedToAPositionEveryPartTakesTheSameTimeAndEndsAtTheTarget() {
        Project stiff = fixtures::stiffBatch(20);
        const ScenarioSource source(positionBatch(stiff));
        const SimulationResult nominal = simulateUnchecked(source.nominal());
        const std::optional nominalDatum = makeBlank(*stiff.part).totalInfeed_mm;
        std::set<double> stocks;
        for (std::int64_t part = 0; part < 20; ++part) {
            const Project project = source.project(part);
            stocks.insert(project.part->stock_mm);
            QCOMPARE(project.gauge->datum_mm, nominalDatum);
            const SimulationResult result = simulateUnchecked(project);
            QVERIFY(result.status == RunStatus::completed);
            QCOMPARE(result.time_s, nominal.time_s);
            QCOMPARE(result.countsByStage, nominal.countsByStage);
            const auto& radii = result.sections.at(0).radii_mm;
            for (std::size_t k = 0; k < radii.size(); ++k) {
                QVERIFY(within(radii[k], nominal.sections.at(0).radii_mm[k], 1e-9));
            }
            QVERIFY(within(radii.back(), targetRadius(*project.part), 1e-9)); // the last one cut
        }
        QVERIFY(*stocks.begin() < 0.2 && *stocks.rbegin() > 0.2);
    }

    // By the gauge the time follows the stock instead, 0.9 mm/min, to within two revolutions.
    void byTheGaugeTheTimeFollowsTheStock() {
        Project project = positionBatch(fixtures::stiffBatch(20));
        project.gauge->control = Control::gauge;
        const ScenarioSource source(project);
        const double revolution_s = 60.0 / 180;
        for (std::int64_t part = 0; part < 20; ++part) {
            const Project one = source.project(part);
            QVERIFY(within(simulateUnchecked(one).time_s, one.part->stock_mm / 0.9 * 60,
                           2.01 * revolution_s));
            QVERIFY(!one.gauge->datum_mm);
        }
    }

    // A larger blank is met deeper: what it has more is cut in the first revolution.
    void aLargerBlankIsCutDeeperAtOnceAndASmallerOneLater() {
        Project project = fixtures::stiffBatch(1);
        project.gauge->control = Control::position;
        project.gauge->datum_mm = 0.2;
        const double perRevolution = 0.9 / 180;
        const auto firstCut = [&project](double stock_mm) {
            project.part->stock_mm = stock_mm;
            const fixtures::Traced run(project);
            const int K = project.part->radii_per_section;
            return run.visit(run.passesOf(0).at(0), K - 1).actual_mm;
        };
        QVERIFY(within(firstCut(0.2), perRevolution, 1e-9));
        QVERIFY(within(firstCut(0.23), perRevolution + 0.03, 1e-9));
        QCOMPARE(firstCut(0.17), 0.0);
    }

    // --- measured blanks ------------------------------------------------------------------------

    void bothDialectsAreRead_data() {
        QTest::addColumn<QByteArray>("csv");
        addRow("comma", QByteArray("stock_mm,dullness\n0.15,0.02\n0.16,0.03\n"));
        addRow("semicolon, decimal comma",
               QByteArray("stock_mm;dullness\r\n0,15;0,02\r\n0,16;0,03\r\n"));
        addRow("tab", QByteArray("stock_mm\tdullness\n0.15\t0,02\n0,16\t0.03"));
        addRow("other columns, gaps, quotes, byte order mark",
               QByteArray("\xEF\xBB\xBF\"no\";\"stock_mm\";\"note\";dullness\n1;\"0,15\";x;0,02\n"
                          "\n2;;y;\n3;0.16;;3e-2\n"));
    }
    void bothDialectsAreRead() {
        QFETCH(QByteArray, csv);
        const auto columns = columnsOf(csv);
        QCOMPARE(columns.size(), std::size_t{2});
        QVERIFY(columns[0].kind == FactorKind::stock && columns[1].kind == FactorKind::dullness);
        QCOMPARE(columns[0].values, (std::vector<double>{0.15, 0.16}));
        QCOMPARE(columns[1].values, (std::vector<double>{0.02, 0.03}));
        Batch batch;
        batch.factors.stock_mm = uniform(0.1, 0.2);
        putMeasured(columns, batch);
        QVERIFY(!batch.factors.stock_mm->uniform);
        QCOMPARE(*batch.factors.stock_mm->measured, columns[0].values);
        QCOMPARE(*batch.factors.dullness->measured, columns[1].values);
    }

    void aTableThatIsNoneIsRefusedWithItsLine_data() {
        addColumns<QByteArray, int, QByteArray>("csv", "line", "text");
        addRow("nothing", QByteArray(), 1, QByteArray());
        addRow("no heading", QByteArray("0.15\n0.16\n"), 1, QByteArray());
        addRow("twice", QByteArray("stock_mm,stock_mm\n1,2\n"), 1, QByteArray("stock_mm"));
        addRow("a word", QByteArray("stock_mm\n0.1\n\nwide\n"), 4, QByteArray("wide"));
        addRow("no number", QByteArray("stock_mm\nnan\n"), 2, QByteArray("nan"));
        addRow("infinite", QByteArray("stock_mm\n0.1\ninf\n"), 3, QByteArray("inf"));
        addRow("two points", QByteArray("stock_mm;a\n1.0.0;\n"), 2, QByteArray("1.0.0"));
    }
    void aTableThatIsNoneIsRefusedWithItsLine() {
        QFETCH(QByteArray, csv);
        QFETCH(int, line);
        QFETCH(QByteArray, text);
        const auto read = readMeasuredBlanks(std::string_view(csv.constData(), csv.size()));
        const auto* fault = std::get_if<TableFault>(&read);
        QVERIFY(fault);
        QCOMPARE(fault->line, line);
        QCOMPARE(fault->text, text.toStdString());
    }
};

} // namespace sparkout::test_batch_factors

SPARKOUT_TEST(test_batch_factors, TestBatchFactors)
#include "test_batch_factors.moc"
