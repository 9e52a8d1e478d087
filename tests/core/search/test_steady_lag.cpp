// SPDX-License-Identifier: GPL-3.0-or-later
// No radius lags behind the wheel by less or more than its steady lag says.
#include "core/process/force.h"
#include "core/process/system_compliance.h"
#include "core/search/last_stage_bound.h"
#include "core/simulation/plunge.h"
#include "core/simulation/traverse.h"

#include "tests/core/search/followed_cases.h"
#include "tests/registry.h"

#include <utility>

namespace sparkout::test_steady_lag {

using search_cases::Dice;

constexpr double rounding_mm = 1e-12;

/// Steps of a part and a few feeds of its grid, from fine to coarse.
struct Followed {
    Followed(Project of, Dice& dice)
        : project(std::move(of))
        , steps(project.operation == Operation::traverse
                    ? traverseSteps(project, Zone::nz, nullptr, {})
                    : plungeSteps(project, nullptr, {}))
        , follower(*steps->follower()) {
        for (int i = 0; i < 4; ++i) {
            StepFeed step;
            step.axialFeed_mm_min = dice.uniform(300, 2500);
            step.infeed_mm = dice.uniform(0.0005, 0.015);
            if (project.operation->travels && i % 2 == 1) { // fed all the time instead
                step.infeed_mm = 0;
                step.continuousFeed_mm_min = dice.uniform(0.005, 0.2);
            }
            feeds.push_back(follower.feed(step));
        }
    }
    /// Behind a step, of a radius that lags so far before it.
    [[nodiscard]] double after(double lag_mm, double share, std::size_t zone, std::size_t feed,
                               bool byStrokes) const {
        FollowedRadii radii;
        radii.radii.fill({-lag_mm, share, zone});
        if (byStrokes) {
            follower.strokesAlone(radii, feeds[feed]);
        } else {
            follower.stepAlone(radii, feeds[feed]);
        }
        return radii.fed_mm - radii.radii[0].depth_mm;
    }
    Project project;
    std::unique_ptr<CycleSteps> steps;
    const RadiusFollower& follower;
    std::vector<FollowedFeed> feeds;
};

class TestSteadyLag : public QObject {
    Q_OBJECT

private slots:
    /// η = 0, plunge: γ·P_y(f), and before the revolution's end as much more as is fed till then.
    void ofASharpWheelItIsTheDeflectionUnderTheSteadyForce() {
        for (unsigned seed = 0; seed < 40; ++seed) {
            Project p = search_cases::plunged(seed);
            p.wheel->dullness = 0;
            Dice dice(seed);
            const Followed followed(p, dice);
            const std::vector<CompliantPoint> sections = compliantPoints(p, {});
            for (std::size_t zone = 0; zone < sections.size(); ++zone) {
                SteadyLags lags(followed.follower, followed.feeds, zone);
                const double gbks = sections[zone].gamma_mm_n * p.part->length_mm * forceLaw(p).ks;
                for (std::size_t s = 0; s < followed.feeds.size(); ++s) {
                    const double infeed_mm = followed.feeds[s].infeed_mm;
                    const double steady_mm = gbks * infeed_mm;
                    const double least_mm = lags.least_mm()[s];
                    const double most_mm = lags.most(zone)[s].lag_mm;
                    QVERIFY(least_mm <= steady_mm && steady_mm + infeed_mm <= most_mm);
                    QVERIFY(least_mm > 0.99 * steady_mm - 1e-5);
                    QVERIFY(most_mm < 1.01 * (steady_mm + infeed_mm) + 1e-5);
                    const double slope = lags.most(zone)[s].slope, exact = gbks / (1 + gbks);
                    QVERIFY(slope > exact - 1e-9);
                    QVERIFY(slope < exact + 1e-6 || most_mm < 1e-3); // there it reaches below 0
                }
            }
        }
    }

    void noLagFallsBelowNorRisesBeyond_data() {
        QTest::addColumn<bool>("travels");
        QTest::addRow("traverse") << true;
        QTest::addRow("plunge") << false;
    }

    /// Whatever it is at first, not reached yet or far behind, and wherever it is visited.
    void noLagFallsBelowNorRisesBeyond() {
        QFETCH(bool, travels);
        int fell = 0, rose = 0;
        for (unsigned seed = 0; seed < 100; ++seed) {
            Dice dice(seed);
            const Followed followed(
                travels ? search_cases::traversed(seed) : search_cases::plunged(seed), dice);
            const std::size_t gauged = travels ? 1 : 0;
            SteadyLags lags(followed.follower, followed.feeds, gauged);
            const std::size_t zone = travels ? static_cast<std::size_t>(dice.integer(0, 2)) : 0;
            for (std::size_t s = 0; s < followed.feeds.size(); ++s) {
                const double least_mm = lags.least_mm()[s];
                const SteadyLags::Most most = lags.most(zone)[s];
                const double first_mm = dice.uniform(-0.02, 0.2);
                const double share = dice.uniform(0, 1);
                double low_mm = first_mm, high_mm = first_mm, factor = 1;
                for (int step = 0; step < 60; ++step) {
                    low_mm = followed.after(low_mm, 1, gauged, s, true);
                    high_mm = followed.after(high_mm, share, zone, s, false);
                    factor *= most.slope;
                    QVERIFY(low_mm >= std::min(first_mm, least_mm) - rounding_mm);
                    QVERIFY(high_mm <= most.lag_mm + std::max(first_mm - most.lag_mm, 0.0) * factor
                                           + rounding_mm);
                }
                fell += low_mm < first_mm ? 1 : 0;
                rose += high_mm > first_mm ? 1 : 0;
            }
        }
        QVERIFY(fell > 40 && rose > 40);
    }

    /// Where all passes cut as the bounds have it they come to the steady lag.
    void aLagComesToTheBounds() {
        for (unsigned seed = 0; seed < 40; ++seed) {
            Dice dice(seed);
            const Followed followed(
                seed % 2 ? search_cases::traversed(seed) : search_cases::plunged(seed), dice);
            const std::size_t gauged = seed % 2;
            SteadyLags lags(followed.follower, followed.feeds, gauged);
            for (std::size_t s = 0; s < followed.feeds.size(); ++s) {
                double low_mm = 0.05, high_mm = 0.05;
                for (int step = 0; step < 4000; ++step) {
                    low_mm = followed.after(low_mm, 1, gauged, s, true);
                    high_mm = followed.after(high_mm, 0, gauged, s, false);
                }
                const double least_mm = lags.least_mm()[s];
                const double most_mm = lags.most(gauged)[s].lag_mm;
                QVERIFY(least_mm <= low_mm && low_mm < least_mm + 1e-4 + 0.01 * low_mm);
                QVERIFY(high_mm <= most_mm && most_mm < high_mm + 1e-4 + 0.01 * high_mm);
            }
        }
    }
};

} // namespace sparkout::test_steady_lag

SPARKOUT_TEST(test_steady_lag, TestSteadyLag)
#include "test_steady_lag.moc"
