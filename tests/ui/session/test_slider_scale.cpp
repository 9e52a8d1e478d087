// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/machine.h"
#include "ui/session/slider_scale.h"

#include "core/project/member.h"
#include "core/project/validate.h"
#include "core/study/new_project.h"

#include "tests/registry.h"

#include <algorithm>
#include <cmath>
#include <set>

namespace sparkout::test_slider_scale {

/// Every input with a slider, by the tables.
void collect(const Project& project, const StructInfo& table, const void* owner,
             const std::string& path, std::vector<std::pair<std::string, const Field*>>& into) {
    for (const Field& field : table.fields) {
        const std::string at = path + "/" + field.key;
        const bool relevant = !field.relevant || field.relevant(project, owner);
        if (field.slider && relevant && field.kind != Kind::compliance) {
            into.emplace_back(at, &field);
        }
        if (field.kind == Kind::object) {
            collect(project, *field.nested, field.objectIn(owner), at, into);
        }
        for (std::size_t i = 0; field.kind == Kind::objectList && i < field.size(owner); ++i) {
            collect(project, *field.nested, field.itemIn(owner, i), at + "/" + std::to_string(i),
                    into);
        }
    }
}

std::vector<std::pair<std::string, const Field*>> sliders(const Project& project) {
    std::vector<std::pair<std::string, const Field*>> list;
    collect(project, tableOf<Project>(), &project, {}, list);
    return list;
}

/// Whether a text of at most three significant digits stands for the number.
bool isRound(double value) {
    return value == 0 || QString::number(value, 'g', 3).toDouble() == value;
}

SliderScale scaleOf(const Project& project, const std::string& path) {
    const ConstMember member = findMember(project, path);
    return SliderScale(sliderSpec(project, path, *member.field),
                       numberIn(*member.field, member.owner));
}

class TestSliderScale : public QObject {
    Q_OBJECT

private slots:
    void everyNumberOneIsToPlayWithHasASlider() {
        const std::set<std::string> traverse = pathsOf(newProject(Operation::traverse));
        for (const char* path :
             {"/part/stock_mm", "/part/initial_runout_mm", "/wheel/dullness",
              "/machine/dwell_entry_s", "/machine/dwell_exit_s", "/cycle/stages/1/radial_feed_mm",
              "/cycle/stages/1/axial_feed_mm_min", "/cycle/stages/1/stock_mm"}) {
            QVERIFY2(traverse.contains(path), path);
        }
        QVERIFY(
            pathsOf(newProject(Operation::plunge)).contains("/cycle/stages/0/radial_feed_mm_min"));
        QVERIFY(tableOf<Machine>().find("compliance_mm_per_n")->slider);
    }

    void everyStopOfEverySliderIsARoundValueThatIsAllowed_data() { operations(); }
    void everyStopOfEverySliderIsARoundValueThatIsAllowed() {
        QFETCH(int, operation);
        const Project project = newProject(Operation::ofIndex(std::size_t(operation)));
        for (const auto& [path, field] : sliders(project)) {
            const SliderScale scale = scaleOf(project, path);
            double before = -1;
            for (int i = 0; i <= 1000; ++i) {
                const double value = scale.valueAt(i / 1000.0);
                QVERIFY2(field->hard.contains(value), path.c_str());
                QVERIFY2(isRound(value), qPrintable(QString::number(value, 'g', 17)));
                QVERIFY2(value >= before, "a slider goes one way");
                before = value;
            }
            QVERIFY2(scale.valueAt(0) == scale.low() || scale.low() == 0, path.c_str());
            QCOMPARE(scale.valueAt(1), scale.high());
        }
    }

    // A slider must not offer what the rules refuse, nor keep back what they take.
    void zeroIsReachedJustWhereTheRulesTakeIt_data() { operations(); }
    void zeroIsReachedJustWhereTheRulesTakeIt() {
        QFETCH(int, operation);
        Project project = newProject(Operation::ofIndex(std::size_t(operation)));
        for (const auto& [path, field] : sliders(project)) {
            Project zero = project;
            const Member member = findMember(zero, path);
            setNumberIn(*member.field, member.owner, 0);
            const Issues issues = validate(zero);
            const bool refused =
                std::any_of(issues.begin(), issues.end(), [&path = path](const Issue& issue) {
                    return issue.severity == Severity::error && issue.path == path;
                });
            QVERIFY2((scaleOf(project, path).low() == 0) == !refused, path.c_str());
        }
    }

    void theUsualRangeIsSpannedAndTheValueOutsideItToo() {
        Project project = newProject(Operation::traverse);
        SliderScale scale = scaleOf(project, "/machine/work_speed_rpm");
        QCOMPARE(scale.low(), 20.0);
        QCOMPARE(scale.high(), 1500.0);
        project.machine->work_speed_rpm = 2300;
        QCOMPARE(scaleOf(project, "/machine/work_speed_rpm").high(), 5000.0);
        project.machine->work_speed_rpm = 7;
        QCOMPARE(scaleOf(project, "/machine/work_speed_rpm").low(), 5.0);
        project.machine->work_speed_rpm = 9999;
        QCOMPARE(scaleOf(project, "/machine/work_speed_rpm").high(), 10000.0);
    }

    void theValueStandsWhereItsShareOfTheRangeIs() {
        Project project = newProject(Operation::traverse);
        project.machine->dwell_entry_s = 0;
        for (const auto& [path, field] : sliders(project)) {
            const SliderScale scale = scaleOf(project, path);
            for (const double share : {0.0, 0.2, 0.5, 0.8, 1.0}) {
                const double there = scale.shareOf(scale.valueAt(share));
                QVERIFY2(std::abs(there - share) < 0.03, path.c_str());
            }
        }
        // A hundredfold range is logarithmic: a decade is half of it.
        SliderSpec spec;
        spec.usual = {0.01, 1};
        spec.allowed = {0.001, 10};
        QCOMPARE(SliderScale(spec).shareOf(0.1), 0.5);
        spec.usual = {1, 5};
        QCOMPARE(SliderScale(spec).shareOf(3), 0.5);
    }

    void stepsUpAndDownAgainComeBack() {
        const Project project = newProject(Operation::traverse);
        for (const auto& [path, field] : sliders(project)) {
            const SliderScale scale = scaleOf(project, path);
            double value = scale.valueAt(0.1);
            for (int i = 0; i < 60 && value < scale.high(); ++i) {
                const double next = scale.stepped(value, 1);
                QVERIFY2(next > value, path.c_str());
                if (next < scale.high()) {
                    QVERIFY2(scale.stepped(next, -1) == value, path.c_str());
                }
                value = next;
            }
            QCOMPARE(scale.stepped(scale.high(), 1), scale.high());
        }
    }

    void greatStepsOfALogarithmicScaleGoOneTwoFiveTen() {
        const SliderScale scale =
            scaleOf(newProject(Operation::traverse), "/cycle/stages/0/radial_feed_mm");
        double value = 0.001;
        for (const double next : {0.002, 0.005, 0.01, 0.02}) {
            value = scale.leapt(value, 1);
            QCOMPARE(value, next);
        }
        QCOMPARE(scale.leapt(value, -2), 0.005);
    }

    void theMachinesOwnRangeAndStepAreKept() {
        Project project = newProject(Operation::traverse);
        project.machine->limits.radial_feed_mm = {{0.0005, 0.03, 0.0005}};
        const SliderScale scale = scaleOf(project, "/cycle/stages/0/radial_feed_mm");
        QCOMPARE(scale.low(), 0.0005);
        QCOMPARE(scale.high(), 0.03);
        for (int i = 0; i <= 500; ++i) {
            const double steps = (scale.valueAt(i / 500.0) - 0.0005) / 0.0005;
            QVERIFY(std::abs(steps - std::round(steps)) < 1e-6);
        }
        QCOMPARE(scale.stepped(0.001, 1), 0.0015);
        // The plunge-in feed at the reversal is another one.
        QCOMPARE(scaleOf(project, "/machine/plunge_feed_mm_min").low(), 0.05);
    }

    void wholeNumbersStayWhole() {
        SliderSpec spec;
        spec.usual = {4, 360};
        spec.allowed = {4, 360};
        spec.integer = true;
        const SliderScale scale(spec, 36);
        for (int i = 0; i <= 300; ++i) {
            const double value = scale.valueAt(i / 300.0);
            QCOMPARE(value, std::round(value));
        }
        QCOMPARE(scale.stepped(4, 1), 5.0);
    }

private:
    static void operations() {
        QTest::addColumn<int>("operation");
        QTest::newRow("traverse") << int(Operation::traverse.index());
        QTest::newRow("plunge") << int(Operation::plunge.index());
    }

    static std::set<std::string> pathsOf(const Project& project) {
        std::set<std::string> paths;
        for (const auto& [path, field] : sliders(project)) {
            paths.insert(path);
        }
        return paths;
    }
};

} // namespace sparkout::test_slider_scale

SPARKOUT_TEST(test_slider_scale, TestSliderScale)
#include "test_slider_scale.moc"
