// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/stage_edits.h"
#include "tests/whole_project.h"

#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/simulation/simulate.h"
#include "core/study/new_project.h"
#include "tests/registry.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace sparkout::test_stock_edits {

double sum(const Project& project) {
    double sum = 0;
    for (const Stage& stage : project.cycle->stages) {
        sum += stage.stock_mm;
    }
    return sum;
}

bool remarked(const Project& project) {
    const Issues issues = validate(project);
    return std::any_of(issues.begin(), issues.end(), [](const Issue& issue) {
        return issue.code == IssueCode::stocksDoNotSumUp;
    });
}

class TestStockEdits : public QObject {
    Q_OBJECT

private slots:
    void theFirstStageTakesWhatTheLaterOnesLeave_data() {
        addColumns<bool, double>("plunge", "stock");
        for (const bool plunge : {false, true}) {
            for (const double stock : {0.07, 0.2, 0.3}) {
                QTest::addRow("%s %g", plunge ? "plunge" : "traverse", stock) << plunge << stock;
            }
        }
    }
    void theFirstStageTakesWhatTheLaterOnesLeave() {
        QFETCH(bool, plunge);
        QFETCH(double, stock);
        Project project = newProject(plunge ? Operation::plunge : Operation::traverse);
        QVERIFY(stocksAddUp(project));
        project.part->stock_mm = stock;
        QVERIFY(!stocksAddUp(project) && remarked(project));
        const Project fitted = withFittedStocks(project);
        QVERIFY(stocksAddUp(fitted) && !remarked(fitted));
        for (std::size_t i = 1; i < project.cycle->stages.size(); ++i) {
            QCOMPARE(fitted.cycle->stages[i].stock_mm, project.cycle->stages[i].stock_mm);
        }
        // The cycle itself is the one that ran before.
        const SimulationResult before = simulate(project), after = simulate(fitted);
        QCOMPARE(after.time_s, before.time_s);
        QCOMPARE(after.timeByStage_s, before.timeByStage_s);
    }

    void whereTheLaterOnesLeaveNothingAllKeepTheirShare() {
        Project project = newProject(Operation::traverse);
        const std::vector<Stage> before = project.cycle->stages;
        project.part->stock_mm = before[1].stock_mm / 2;
        const double scale = project.part->stock_mm / (before[0].stock_mm + before[1].stock_mm);
        const Project fitted = withFittedStocks(project);
        QVERIFY(stocksAddUp(fitted));
        QVERIFY(std::abs(sum(fitted) - project.part->stock_mm) < 1e-12);
        for (std::size_t i = 0; i < before.size(); ++i) {
            QVERIFY(fitted.cycle->stages[i].stock_mm > 0);
            QVERIFY(std::abs(fitted.cycle->stages[i].stock_mm - before[i].stock_mm * scale) < 2e-9);
        }
    }

    void roundingTakesNoStageBelowNothing() {
        Project project = newProject(Operation::traverse);
        project.cycle->stages.assign(4, project.cycle->stages.front());
        for (Stage& stage : project.cycle->stages) {
            stage.stock_mm = 0.1;
        }
        project.cycle->stages.front().stock_mm = 0;
        project.part->stock_mm = 0.2;
        const Project fitted = withFittedStocks(project);
        QVERIFY(stocksAddUp(fitted) && !hasErrors(validate(fitted)));
        QCOMPARE(fitted.cycle->stages.front().stock_mm, 0.0);
        QVERIFY(std::abs(sum(fitted) - 0.2) < 1e-12);
    }

    /// A stage more takes half the stock, in whole micrometres where there are some.
    void aStageMoreLeavesTheOneBeforeIt() {
        for (const auto& [stock_mm, half_mm] : {std::pair{0.001, 0.0005},
                                                {0.0012, 0.0006},
                                                {0.003, 0.001},
                                                {0.004, 0.002},
                                                {0.05, 0.025}}) {
            Project project = newProject(Operation::traverse);
            project.cycle->stages.front().stock_mm = stock_mm;
            const Project more = withStageAfter(project, 0);
            QCOMPARE(more.cycle->stages[1].stock_mm, half_mm);
            QCOMPARE(more.cycle->stages[0].stock_mm, tidyStock(stock_mm - half_mm));
        }
    }

    /// By hand: 0.3 of a wheel of 50 mm at 180 rev/min is 15 mm/rev or 2700 mm/min; a step of the
    /// machine is taken where it has one.
    void feedsAreReadInOtherForms() {
        Project project = newProject(Operation::traverse);
        project.wheel->width_mm = 50;
        project.machine->work_speed_rpm = 180;
        project.machine->limits.axial_feed_mm_min.reset();
        const Field& axial = *tableOf<Stage>().find("axial_feed_mm_min");
        const Field& plunge = *tableOf<Stage>().find("radial_feed_mm_min");
        const Field& step = *tableOf<Stage>().find("radial_feed_mm");
        for (const char* text : {"0.3B", "0,3 B", "0.3 b", "0.3В", "15 mm/rev", "15 мм/об",
                                 " 15/rev ", "15\u00a0mm/rev"}) {
            const auto feed = feedFromForm(project, axial, text);
            QVERIFY2(feed && std::abs(*feed - 2700) < 1e-9, text);
        }
        for (const char* text : {"", "B", "0.3", "mm/rev", "0.3 C", "1 2B", "0.3B2", "x B"}) {
            QVERIFY2(!feedFromForm(project, axial, text), text);
        }
        const auto forms = feedForms(project, axial, 2700);
        QVERIFY(forms && forms->ofWidth);
        QVERIFY(std::abs(forms->perRevolution_mm - 15) < 1e-12);
        QVERIFY(std::abs(*forms->ofWidth - 0.3) < 1e-12);
        project.machine->limits.axial_feed_mm_min = {20, 5000, 50};
        QVERIFY(std::abs(*feedFromForm(project, axial, "0.301B") - 2720) < 1e-9); // of 2709
        QVERIFY(!feedForms(project, step, 0.004)); // a feed of a step is one already
        QVERIFY(!feedFromForm(project, step, "12 mm/rev"));
        project = newProject(Operation::plunge);
        project.machine->work_speed_rpm = 200;
        project.machine->limits.plunge_feed_mm_min.reset();
        QVERIFY(std::abs(*feedFromForm(project, plunge, "0.004 mm/rev") - 0.8) < 1e-9);
        QVERIFY(!feedFromForm(project, plunge, "0.3B")); // the wheel is not fed along the work
        const auto radial = feedForms(project, plunge, 0.8);
        QVERIFY(radial && !radial->ofWidth);
        QVERIFY(std::abs(radial->perRevolution_mm - 0.004) < 1e-12);
    }

    void stocksThatAddUpStay() {
        const Project project = newProject(Operation::plunge);
        const Project fitted = withFittedStocks(project);
        for (std::size_t i = 0; i < project.cycle->stages.size(); ++i) {
            QCOMPARE(fitted.cycle->stages[i].stock_mm, project.cycle->stages[i].stock_mm);
        }
        Project none;
        none.cycle->stages.clear();
        none = withFittedStocks(none);
        QVERIFY(none.cycle->stages.empty());
    }
};

} // namespace sparkout::test_stock_edits

SPARKOUT_TEST(test_stock_edits, TestStockEdits)
#include "test_stock_edits.moc"
