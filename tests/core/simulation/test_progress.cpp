// SPDX-License-Identifier: GPL-3.0-or-later
// How far a recorded cycle has run: what its last visits left, held against going through all.
#include "core/simulation/progress.h"
#include "core/simulation/stock_layers.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/registry.h"

namespace sparkout::test_progress {

using fixtures::within;

constexpr double allowed_mm = 1e-12;

struct Recorded {
    explicit Recorded(const Project& project) : result(simulateUnchecked(project, &trajectory)) {}
    Trajectory trajectory;
    SimulationResult result;
};

Project plungeOf3() {
    Project p = fixtures::plunge();
    p.sections = 3;
    p.part->radii_per_section = 12;
    p.machine->compliance_mm_per_n = std::vector<double>{2e-5, 3e-5, 4e-5};
    return p;
}

std::vector<Recorded> samples() {
    std::vector<Recorded> runs;
    runs.emplace_back(fixtures::traverse());
    runs.emplace_back(plungeOf3());
    return runs;
}

/// Every moment of a cycle: passes that begin and end together, at a few of their radii.
std::vector<Progress> moments(const Trajectory& trajectory) {
    std::vector<Progress> all;
    const std::vector<Pass>& passes = trajectory.passes;
    for (std::size_t open = 0, end = 0; open < passes.size(); open = end) {
        while (end < passes.size() && passes[end].start_s == passes[open].start_s
               && passes[end].duration_s == passes[open].duration_s) {
            ++end;
        }
        for (const int k : {0, trajectory.radii / 3, trajectory.radii - 1}) {
            all.push_back({open, end, k});
        }
    }
    return all;
}

class TestProgress : public QObject {
    Q_OBJECT

private slots:
    void theLastVisitIsTheNewestOfEachRadius() {
        for (const Recorded& run : samples()) {
            for (const Progress& moment : moments(run.trajectory)) {
                const LastVisits last =
                    lastVisits(run.trajectory, run.result.sections.size(), moment);
                LastVisits all(last.size(), std::vector<const Visit*>(last.front().size()));
                for (std::size_t i = 0; i < moment.end; ++i) {
                    const Pass& pass = run.trajectory.passes[i];
                    for (std::size_t k = 0; k < all.front().size(); ++k) {
                        if (i < moment.open || static_cast<int>(k) <= moment.radius) {
                            all[sectionOf(pass.place)][k] =
                                &run.trajectory.visits[pass.firstVisit + k];
                        }
                    }
                }
                QVERIFY(last == all);
            }
        }
    }

    void atTheEndTheRadiiAreThoseOfTheResult() {
        for (const Recorded& run : samples()) {
            const Progress end = progressAfter(run.trajectory, run.result.cycleCount);
            QVERIFY(endsStroke(run.trajectory, end));
            QVERIFY(within(timeOf(run.trajectory, end), run.result.time_s, 1e-9));
            const LastVisits last = lastVisits(run.trajectory, run.result.sections.size(), end);
            for (std::size_t i = 0; i < last.size(); ++i) {
                for (std::size_t k = 0; k < last[i].size(); ++k) {
                    QCOMPARE(last[i][k]->radius_mm, run.result.sections[i].radii_mm[k]);
                }
            }
        }
    }

    void theBlankHasNoVisits() {
        for (const Recorded& run : samples()) {
            const Progress blank = progressAfter(run.trajectory, 0);
            QVERIFY(blank.isBlank() && endsStroke(run.trajectory, blank));
            QCOMPARE(timeOf(run.trajectory, blank), 0.0);
            for (const auto& section :
                 lastVisits(run.trajectory, run.result.sections.size(), blank)) {
                QVERIFY(std::ranges::all_of(section, [](const Visit* v) { return !v; }));
            }
        }
    }

    void timeGrowsThroughTheMoments() {
        for (const Recorded& run : samples()) {
            double before_s = 0;
            int ends = 0;
            for (const Progress& moment : moments(run.trajectory)) {
                const double now_s = timeOf(run.trajectory, moment);
                QVERIFY(now_s > before_s);
                before_s = now_s;
                ends += endsStroke(run.trajectory, moment) ? 1 : 0;
            }
            QCOMPARE(ends, run.result.cycleCount);
        }
    }

    /// The layers done lie between blank and final radius, and never shrink.
    void theLayersDoneGrowToTheWholeStock() {
        for (const Recorded& run : samples()) {
            const LayerSeries series = makeLayerSeries(run.result, run.trajectory);
            LayersDone before = layersDone(series, run.trajectory, {});
            QCOMPARE(before.count, std::size_t{0});
            for (const Progress& moment : moments(run.trajectory)) {
                const LayersDone now = layersDone(series, run.trajectory, moment);
                QVERIFY(now.count >= before.count);
                for (std::size_t j = 0; j < now.sum_mm.size(); ++j) {
                    QVERIFY(now.sum_mm[j] >= before.sum_mm[j] - allowed_mm);
                    QVERIFY(sumDone_mm(series, now, j, now.count)
                            >= sumDone_mm(series, now, j, now.count - 1) - allowed_mm);
                }
                before = now;
            }
            QCOMPARE(before.count, series.spans.size());
            for (std::size_t j = 0; j < before.sum_mm.size(); ++j) {
                QVERIFY(within(before.sum_mm[j], allLayers(series).sum_mm[j], allowed_mm));
            }
        }
    }
};

} // namespace sparkout::test_progress

SPARKOUT_TEST(test_progress, TestProgress)
#include "test_progress.moc"
