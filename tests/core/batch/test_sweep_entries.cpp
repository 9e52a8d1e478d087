// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// What a sweep can be read by: its quantities by name and place, and the worst of them at a point.
#include "core/batch/sweep_run.h"
#include "core/project/sweep.h"

#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <set>

namespace sparkout::test_sweep_entries {

SweepQuantity quantity(const std::string& name, int section = -1) {
    return {name, "µm", section < 0 ? Zone::section : static_cast<Zone>(section), section};
}

SweepPoint pointOf(std::vector<SweepValue> values) {
    SweepPoint point;
    point.status = SweepStatus::done;
    point.values = std::move(values);
    return point;
}

SweepValue limited(double value, double margin) {
    SweepValue of;
    of.value = value;
    of.margin = margin;
    return of;
}

SweepValue unlimited(double value) {
    SweepValue of;
    of.value = value;
    return of;
}

SweepResult ran(const std::string& input) {
    Project project = samples::project("smallest-traverse");
    project.sweep.emplace();
    SweepAxis axis;
    axis.input = input;
    axis.from = 0.015;
    axis.to = 0.03;
    axis.points = 3;
    project.sweep->inputs = {axis};
    return runSweep(project);
}

class TestSweepEntries : public QObject {
    Q_OBJECT

private slots:
    void quantitiesOfOneNameAreOneEntry() {
        SweepResult sweep;
        sweep.quantities = {quantity("time"), quantity("roundness", 0), quantity("diameter", 0),
                            quantity("roundness", 1)};
        const std::vector<SweepEntry> entries = sweepEntries(sweep, false);
        QCOMPARE(entries.size(), 3u);
        QCOMPARE(entries[1].key, std::string("roundness"));
        QVERIFY((entries[1].quantities == std::vector<std::size_t>{1, 3}));
        const std::vector<SweepEntry> each = sweepEntries(sweep, true);
        QCOMPARE(each.size(), 5u); // the two places of the roundness, too
        QCOMPARE(each[2].key, std::string("roundness 0"));
        QVERIFY(each[3].quantities == std::vector<std::size_t>{3});
        std::set<std::string> keys;
        for (const SweepEntry& entry : each) {
            keys.insert(entry.key);
        }
        QCOMPARE(keys.size(), each.size());
    }

    void everyQuantityOfARunIsInOneEntry() {
        const SweepResult sweep = ran("/wheel/dullness");
        QVERIFY(sweep.ran() && !sweep.quantities.empty());
        std::size_t all = 0;
        for (const SweepEntry& entry : sweepEntries(sweep, false)) {
            all += entry.quantities.size();
            for (const std::size_t q : entry.quantities) {
                QCOMPARE(sweep.quantities.at(q).name, entry.key);
            }
        }
        QCOMPARE(all, sweep.quantities.size());
    }

    void theWorstHasTheLeastMarginElseTheGreatestValue() {
        const SweepEntry both{"any", {0, 1, 2}};
        QCOMPARE(worstAt(pointOf({limited(5, 2), limited(1, 0.5), limited(9, 3)}), both).value(),
                 1u);
        QCOMPARE(worstAt(pointOf({unlimited(5), unlimited(1), unlimited(9)}), both).value(), 2u);
        QCOMPARE(worstAt(pointOf({SweepValue{}, unlimited(1), SweepValue{}}), both).value(), 1u);
        QVERIFY(!worstAt(pointOf({SweepValue{}, SweepValue{}, SweepValue{}}), both));
        QVERIFY(!worstAt(SweepPoint{}, both));
    }

    void anInputThatIsReadChangesSomething() {
        QVERIFY(!changesNothing(ran("/wheel/dullness")));
        SweepResult same = ran("/wheel/dullness");
        for (SweepPoint& point : same.points) {
            point.values = same.points.front().values;
        }
        QVERIFY(changesNothing(same));
        same.points.back().status = SweepStatus::refused;
        QVERIFY(!changesNothing(same)); // it is not known
        QVERIFY(!changesNothing(SweepResult{}));
    }
};

} // namespace sparkout::test_sweep_entries

SPARKOUT_TEST(test_sweep_entries, TestSweepEntries)
#include "test_sweep_entries.moc"
