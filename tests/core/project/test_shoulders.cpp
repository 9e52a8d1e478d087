// SPDX-License-Identifier: GPL-3.0-or-later
// The room that a shaft's shoulders leave the wheel beside the ground length.
#include "core/project/validate.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"
#include "tests/whole_project.h"

namespace sparkout::test_shoulders {

using samples::holds;

constexpr double blank_mm = 30 + 2 * (0.15 + 0.02);

/// 92 mm of 30 mm diameter, ground from 60 mm on; 12 mm overrun at each end, a blank of 30.34 mm.
Project shaftOf(std::vector<ShaftSegment> segments) {
    Project project = samples::project("stiffness-traverse");
    project.part->shaft.segments = std::move(segments);
    project.part->shaft.steady_rests.clear();
    return project;
}

bool warns(const Project& project, const char* path) {
    return holds(validate(project), IssueCode::shoulderInTheWay, path);
}
bool atEntry(const Project& project) {
    return warns(project, "/machine/overrun_entry_mm");
}
bool atExit(const Project& project) {
    return warns(project, "/machine/overrun_exit_mm");
}

class TestShoulders : public QObject {
    Q_OBJECT

private slots:
    void theOverrunEndsAtTheShoulder() {
        const auto headstock = [](double free_mm) {
            return shaftOf({{60 - free_mm, 50}, {92 + free_mm, 30}, {40, 25}});
        };
        QVERIFY(!atEntry(headstock(12)));
        QVERIFY(atEntry(headstock(11.999)));
        const auto tailstock = [](double free_mm) {
            return shaftOf({{60, 25}, {92 + free_mm, 30}, {40, 50}});
        };
        QVERIFY(!atExit(tailstock(12)));
        QVERIFY(atExit(tailstock(11.999)));
        QVERIFY(!atEntry(tailstock(0)));
    }

    void theEntryMayBeAtTheTailstock() {
        Project project = shaftOf({{60, 50}, {92, 30}, {40, 25}});
        QVERIFY(atEntry(project) && !atExit(project));
        project.machine->entry_side = EntrySide::tailstock;
        QVERIFY(!atEntry(project) && atExit(project));
        project.machine->overrun_exit_mm = 0;
        QVERIFY(!atExit(project));
    }

    void theNearestOfSeveralShouldersCounts() {
        // 10 mm beyond each end, farther ones behind lower steps
        const Project project = shaftOf(
            {{20, 60}, {10, 25}, {20, 50}, {10, 28}, {92, 30}, {10, 28}, {20, 50}, {9, 60}});
        const Issues issues = validate(project);
        int told = 0;
        for (const Issue& issue : issues) {
            if (issue.code == IssueCode::shoulderInTheWay) {
                QCOMPARE(issue.severity, Severity::warning);
                QCOMPARE(std::get<Bounds>(issue.limit).range.high, 10.0);
                ++told;
            }
        }
        QCOMPARE(told, 2);
    }

    void whatIsNoHigherThanTheBlankIsNone() {
        QVERIFY(!atEntry(shaftOf({{60, blank_mm}, {92, 30}, {40, 25}})));
        QVERIFY(atEntry(shaftOf({{60, blank_mm + 0.001}, {92, 30}, {40, 25}})));
    }

    void aPlungingWheelFitsBetweenThem() {
        Project project = samples::project("smallest-plunge"); // 40 mm by a wheel of 50 mm
        project.machine->compliance_mm_per_n = std::monostate{};
        project.machine->stiffness_n_um = Stiffness{60, 40, 50};
        const auto tooNear = [&](double left_mm, double right_mm) {
            project.part->shaft.segments = {{30, 40}, {left_mm + 40 + right_mm, 30}, {30, 40}};
            project.part->shaft.ground_from_mm = 30 + left_mm;
            return holds(validate(project), IssueCode::shouldersTooNear, "/wheel/width_mm");
        };
        QVERIFY(tooNear(4, 5.999));
        QVERIFY(!tooNear(4, 6));
        QVERIFY(!tooNear(10, 0));
        project.part->shaft.segments = {{30, 40}, {40, 30}}; // beside the end there is room
        project.part->shaft.ground_from_mm = 30;
        QVERIFY(!holds(validate(project), IssueCode::shouldersTooNear, "/wheel/width_mm"));
    }
};

} // namespace sparkout::test_shoulders

SPARKOUT_TEST(test_shoulders, TestShoulders)
#include "test_shoulders.moc"
