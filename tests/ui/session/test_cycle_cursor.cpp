// SPDX-License-Identifier: GPL-3.0-or-later
// The cursor goes through the whole cycle in every unit, and keeps its place in a new run.
#include "core/study/outcome.h"
#include "tests/registry.h"
#include "tests/two_stage_projects.h"
#include "ui/session/cycle_cursor.h"

#include <QSignalSpy>

#include <cmath>
#include <set>

namespace sparkout::test_cycle_cursor {

Project traverse() {
    Project p = fixtures::traverseProject();
    p.part->radii_per_section = 12;
    p.machine->dwell_exit_s = 0.667;
    return p;
}

Project plunge() {
    Project p = fixtures::plungeProject(3);
    p.part->radii_per_section = 12;
    p.machine->compliance_mm_per_n = std::vector<double>{2e-5, 3e-5, 4e-5};
    return p;
}

OutcomePtr run(const Project& project) {
    return evaluate(project, {});
}

class TestCycleCursor : public QObject {
    Q_OBJECT

private slots:
    void aNewRunStandsAtItsEnd() {
        for (const Project& project : {traverse(), plunge()}) {
            CycleCursor cursor;
            const OutcomePtr outcome = run(project);
            cursor.setOutcome(outcome);
            QVERIFY(cursor.atEnd() && cursor.count() > 0);
            QCOMPARE(cursor.stroke(), outcome->result.cycleCount);
            QCOMPARE(cursor.radius(), project.part->radii_per_section - 1);
            QVERIFY(std::abs(cursor.time_s() - outcome->result.time_s)
                    <= 1e-9 * outcome->result.time_s);
            QCOMPARE(cursor.progress().end, outcome->trajectory.passes.size());
        }
    }

    /// Steps of a unit lead from the blank to the end and back over the same places, as many as
    /// the cycle has of it.
    void everyUnitGoesThroughTheWholeCycle() {
        for (const Project& project : {traverse(), plunge()}) {
            CycleCursor cursor;
            const OutcomePtr outcome = run(project);
            cursor.setOutcome(outcome);
            std::size_t coarser = 0;
            for (const CursorUnit unit : cursorUnits) {
                cursor.setPosition(0);
                std::vector<long long> there{0}, back;
                while (!cursor.atEnd()) {
                    cursor.step(unit, 1);
                    QVERIFY(cursor.position() > there.back());
                    there.push_back(cursor.position());
                }
                back.push_back(cursor.position());
                while (!cursor.atStart()) {
                    cursor.step(unit, -1);
                    back.push_back(cursor.position());
                }
                QVERIFY(std::equal(there.begin(), there.end(), back.rbegin(), back.rend()));
                QVERIFY(there.size() >= coarser);
                coarser = there.size();
                const std::size_t steps = there.size() - 1;
                if (unit == CursorUnit::stage) {
                    QCOMPARE(steps, project.cycle->stages.size());
                } else if (unit == CursorUnit::stroke) {
                    QCOMPARE(steps, static_cast<std::size_t>(outcome->result.cycleCount));
                } else if (unit == CursorUnit::radius) {
                    QCOMPARE(static_cast<long long>(steps), cursor.count());
                }
            }
        }
    }

    /// Radius by radius every visit is met once, in time, and what they cut adds up to the stock.
    void theRadiiAreAllVisitsOfTheCycle() {
        for (const Project& project : {traverse(), plunge()}) {
            CycleCursor cursor;
            const OutcomePtr outcome = run(project);
            cursor.setOutcome(outcome);
            cursor.setPosition(0);
            std::set<std::size_t> met;
            double time = 0, cut = 0;
            while (!cursor.atEnd()) {
                cursor.step(CursorUnit::radius, 1);
                QVERIFY(cursor.time_s() >= time);
                time = cursor.time_s();
                const Progress done = cursor.progress();
                for (std::size_t i = done.open; i < done.end; ++i) {
                    const Pass& pass = outcome->trajectory.passes[i];
                    const std::size_t visit =
                        pass.firstVisit + static_cast<std::size_t>(cursor.radius());
                    QVERIFY(met.insert(visit).second);
                    QCOMPARE(pass.place.cycleCount, cursor.stroke());
                    cut += outcome->trajectory.visits[visit].actual_mm;
                }
            }
            QCOMPARE(met.size(), outcome->trajectory.visits.size());
            double stock = 0;
            for (const LayerColumn& column : outcome->layers.columns) {
                stock +=
                    std::abs(column.blank_mm - column.final_mm) * project.part->radii_per_section;
            }
            QVERIFY(std::abs(cut - stock) < 1e-10);
        }
    }

    void fromWithinAStrokeTheNearestEndsAreNext() {
        CycleCursor cursor;
        cursor.setOutcome(run(traverse()));
        cursor.toStroke(5);
        const long long fifth = cursor.position();
        cursor.step(CursorUnit::radius, 1);
        QCOMPARE(cursor.stroke(), 6);
        cursor.step(CursorUnit::stroke, -1);
        QCOMPARE(cursor.position(), fifth);
        cursor.step(CursorUnit::radius, 3);
        cursor.step(CursorUnit::stroke, 1);
        QCOMPARE(cursor.stroke(), 6);
        const long long sixth = cursor.position();
        cursor.toStroke(6);
        QCOMPARE(cursor.position(), sixth);
        cursor.step(CursorUnit::stroke, -100000);
        QVERIFY(cursor.atStart());
        QVERIFY(!cursor.pass());
        cursor.step(CursorUnit::stroke, 100000);
        QVERIFY(cursor.atEnd());
    }

    /// Time leads to what was done by then, for every place of the cycle.
    void aTimeLeadsToItsPlace() {
        for (const Project& project : {traverse(), plunge()}) {
            CycleCursor cursor;
            const OutcomePtr outcome = run(project);
            cursor.setOutcome(outcome);
            for (const long long place : {1LL, 7LL, cursor.count() / 3, cursor.count() - 1}) {
                cursor.setPosition(place);
                const double time_s = cursor.time_s();
                cursor.setPosition(0);
                cursor.toTime(time_s);
                QCOMPARE(cursor.position(), place);
            }
            cursor.toTime(-1);
            QVERIFY(cursor.atStart());
            cursor.toTime(2 * outcome->result.time_s);
            QVERIFY(cursor.atEnd());
        }
    }

    void aNewRunKeepsThePlace() {
        CycleCursor cursor;
        Project project = traverse();
        cursor.setOutcome(run(project));
        cursor.toStroke(4);
        cursor.step(CursorUnit::radius, 7);
        const int radius = cursor.radius();
        project.material->flow_stress_mpa *= 1.1;
        QSignalSpy moved(&cursor, &CycleCursor::moved);
        cursor.setOutcome(run(project));
        QCOMPARE(moved.count(), 1);
        QCOMPARE(cursor.stroke(), 5);
        QCOMPARE(cursor.radius(), radius);
        cursor.setPosition(0);
        cursor.setOutcome(run(project));
        QVERIFY(cursor.atStart());
        cursor.setPosition(cursor.count());
        cursor.setOutcome(run(plunge()));
        QVERIFY(cursor.atEnd());
        cursor.toStroke(3);
        cursor.setOutcome(run(traverse())); // another operation: another cycle
        QVERIFY(cursor.atEnd());
    }

    void withoutARunThereIsNothingToStepThrough() {
        CycleCursor cursor;
        for (const bool refused : {false, true}) {
            if (refused) {
                Project project = traverse();
                project.wheel->width_mm = -1;
                cursor.setOutcome(run(project));
            }
            QVERIFY(!cursor.outcome());
            QVERIFY(cursor.atStart() && cursor.atEnd());
            cursor.step(CursorUnit::stroke, 1);
            cursor.toStroke(3);
            QCOMPARE(cursor.position(), 0);
            QCOMPARE(cursor.time_s(), 0.0);
        }
    }
};

} // namespace sparkout::test_cycle_cursor

SPARKOUT_TEST(test_cycle_cursor, TestCycleCursor)
#include "test_cycle_cursor.moc"
