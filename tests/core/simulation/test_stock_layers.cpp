// SPDX-License-Identifier: GPL-3.0-or-later
// The layers the stock comes off in: they add up to it, and merged ones add up the same.
#include "core/simulation/stock_layers.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_stock_layers {

using fixtures::within;

constexpr double allowed_mm = 1e-12;

struct Layered {
    explicit Layered(const Project& project) : result(simulateUnchecked(project, &trajectory)) {}
    [[nodiscard]] LayerSeries series(std::optional<int> radius = {}) const {
        return makeLayerSeries(result, trajectory, radius);
    }
    Trajectory trajectory;
    SimulationResult result;
};

Project sections(int count, double feed_mm_min = 1.2) {
    Project p = fixtures::plunge();
    p.part->radii_per_section = 12;
    p.part->initial_runout_mm = 0.03;
    p.sections = count;
    std::vector<double> compliance;
    for (int j = 0; j < count; ++j) {
        compliance.push_back(2e-5 * (1 + j));
    }
    p.machine->compliance_mm_per_n = compliance;
    p.cycle->stages = {fixtures::plungeStage(feed_mm_min, 0.15), fixtures::plungeStage(0.3, 0.05),
                       fixtures::sparkStage(fixtures::count(7))};
    return p;
}

std::vector<Project> samples() {
    Project bore = sections(2);
    bore.part->surface = Surface::internal;
    bore.wheel->diameter_mm = 20;
    Project tailstock = fixtures::traverse();
    tailstock.machine->entry_side = EntrySide::tailstock;
    return {fixtures::traverse(), tailstock, sections(3), bore, sections(1, 0.05)};
}

double meanOf(const std::vector<double>& values) {
    double sum = 0;
    for (const double value : values) {
        sum += value;
    }
    return sum / static_cast<double>(values.size());
}

class TestStockLayers : public QObject {
    Q_OBJECT

private slots:
    void theLayersAddUpToBlankLessFinalRadius() {
        for (const Project& project : samples()) {
            const Layered run(project);
            const double touch = makeBlank(*project.part).firstTouchRadius_mm;
            const bool bore = project.part->surface == Surface::internal;
            const std::vector<double> blank =
                profileRadii(*project.part, touch + (bore ? initialRunout(*project.part) : 0));
            const LayerSeries series = run.series();
            QCOMPARE(series.columns.size(), run.result.sections.size());
            for (std::size_t j = 0; j < series.columns.size(); ++j) {
                const LayerColumn& column = series.columns[j];
                const double last = meanOf(run.result.sections[j].radii_mm);
                QVERIFY(within(column.blank_mm, meanOf(blank), allowed_mm));
                QVERIFY(within(column.final_mm, last, allowed_mm));
                double sum = 0;
                for (std::size_t i = 0; i < series.spans.size(); ++i) {
                    const double layer =
                        series.sumAfter_mm(column, i + 1) - series.sumAfter_mm(column, i);
                    QVERIFY(layer >= 0);
                    sum += layer;
                }
                QVERIFY(sum > 0);
                QVERIFY(within(sum, std::abs(column.blank_mm - last), allowed_mm));
                QVERIFY(
                    within(series.radiusAfter_mm(column, series.spans.size()), last, allowed_mm));
            }
        }
    }

    void theMeanOfTheRadiiIsTheMeanLayer() {
        for (const Project& project : samples()) {
            const Layered run(project);
            const LayerSeries mean = run.series();
            const int K = project.part->radii_per_section;
            for (std::size_t j = 0; j < mean.columns.size(); ++j) {
                std::vector<double> sums(mean.spans.size());
                for (int k = 0; k < K; ++k) {
                    const LayerSeries one = run.series(k);
                    QCOMPARE(one.columns[j].final_mm,
                             run.result.sections[j].radii_mm[static_cast<std::size_t>(k)]);
                    for (std::size_t i = 0; i < sums.size(); ++i) {
                        sums[i] += one.columns[j].sum_mm[i] / K;
                    }
                }
                for (std::size_t i = 0; i < sums.size(); ++i) {
                    QVERIFY(within(sums[i], mean.columns[j].sum_mm[i], allowed_mm));
                }
            }
        }
    }

    /// A layer holds the depths of cut of its passes, whichever of them are merged.
    void aLayerIsWhatItsPassesCut() {
        for (const Project& project : samples()) {
            const Layered run(project);
            const LayerSeries series = run.series(3);
            for (std::size_t j = 0; j < series.columns.size(); ++j) {
                std::vector<double> cut(series.spans.size());
                for (const Pass& pass : run.trajectory.passes) {
                    const LayerColumn& column = series.columns[j];
                    if (pass.place.zone == column.zone
                        && (column.zone != Zone::section || pass.place.section == column.section)) {
                        cut[series.spansAt(pass.place.cycleCount) - 1] +=
                            run.trajectory.visits[pass.firstVisit + 3].actual_mm;
                    }
                }
                for (std::size_t i = 0; i < cut.size(); ++i) {
                    const double layer = series.sumAfter_mm(series.columns[j], i + 1)
                                         - series.sumAfter_mm(series.columns[j], i);
                    QVERIFY(within(layer, cut[i], allowed_mm));
                }
            }
        }
    }

    void theSpansFollowEachOtherWithinTheirStages() {
        for (const Project& project : samples()) {
            const Layered run(project);
            const LayerSeries series = run.series();
            QVERIFY(series.spans.size() <= mostLayers + project.cycle->stages.size());
            int next = 1;
            for (const LayerSpan& span : series.spans) {
                QCOMPARE(span.first, next);
                QVERIFY(span.last >= span.first);
                next = span.last + 1;
            }
            QCOMPARE(next - 1, run.result.cycleCount);
            for (const Pass& pass : run.trajectory.passes) {
                const LayerSpan& span = series.spans[series.spansAt(pass.place.cycleCount) - 1];
                QVERIFY(span.last >= pass.place.cycleCount);
                QCOMPARE(span.stage, pass.place.stage);
            }
        }
    }

    void manyRevolutionsAreMerged() {
        const Layered run(sections(1, 0.05));
        QVERIFY(run.result.cycleCount > mostLayers);
        QVERIFY(run.series().spans.front().last > 1);
    }

    void theStretchesCoverTheGroundLengthOnce() {
        for (const Project& project : samples()) {
            std::vector<Stretch> stretches = groundStretches(project);
            std::ranges::sort(stretches, {}, &Stretch::from_mm);
            double at = 0;
            for (const Stretch& stretch : stretches) {
                QVERIFY(within(stretch.from_mm, at, allowed_mm));
                QVERIFY(stretch.to_mm > stretch.from_mm);
                at = stretch.to_mm;
            }
            QVERIFY(within(at, project.part->length_mm, allowed_mm));
        }
    }

    void withoutATrajectoryThereIsNothing() {
        const SimulationResult result = simulateUnchecked(fixtures::traverse());
        QVERIFY(makeLayerSeries(result, {}).columns.empty());
        QVERIFY(makeLayerSeries(result, {}).spans.empty());
    }
};

} // namespace sparkout::test_stock_layers

SPARKOUT_TEST(test_stock_layers, TestStockLayers)
#include "test_stock_layers.moc"
