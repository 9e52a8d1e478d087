// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/ready_made.h"
#include "tests/whole_project.h"
#include "ui/session/run_controller.h"

#include "core/study/new_project.h"

#include "tests/registry.h"

#include <QSignalSpy>

#include <atomic>
#include <thread>

namespace sparkout::test_run_controller {

using namespace std::chrono_literals;

Project numbered(int number) {
    Project project = newProject(Operation::traverse);
    project.part->diameter_mm = 30 + number;
    return project;
}

OutcomePtr outcomeOf(const Project& project) {
    auto outcome = std::make_shared<Outcome>();
    outcome->result.project = project;
    return outcome;
}

/// A run of ten seconds that heeds a stop request.
OutcomePtr slowRun(const Project& project, const std::stop_token& stop) {
    for (int i = 0; i < 2000 && !stop.stop_requested(); ++i) {
        std::this_thread::sleep_for(5ms);
    }
    return stop.stop_requested() ? nullptr : outcomeOf(project);
}

class TestRunController : public QObject {
    Q_OBJECT

private slots:
    void aRunGivesResultTrajectoryAndConstraints() {
        RunController runs;
        OutcomePtr got;
        connect(&runs, &RunController::finished, this,
                [&got](const OutcomePtr& outcome) { got = outcome; });
        runs.request(newProject(Operation::traverse));
        QVERIFY(runs.running());
        QTRY_VERIFY(got != nullptr);
        QVERIFY(!runs.running());
        QVERIFY(got->ran());
        QCOMPARE(got->result.status, RunStatus::completed);
        QVERIFY(!got->trajectory.passes.empty());
        QVERIFY(!got->constraints.empty());
        QVERIFY(runs.lastRun_ms() > 0);
    }

    void refusedInputsGiveTheirIssuesAndNoRun() {
        RunController runs;
        OutcomePtr got;
        connect(&runs, &RunController::finished, this,
                [&got](const OutcomePtr& outcome) { got = outcome; });
        Project project = newProject(Operation::traverse);
        project.cycle->stages.front().radial_feed_mm.reset();
        runs.request(project);
        QTRY_VERIFY(got != nullptr);
        QVERIFY(!got->ran());
        QVERIFY(hasErrors(got->issues));
        QVERIFY(got->trajectory.passes.empty());
    }

    void whatIsMissingIsTheOutcomeAndNothingIsRun() {
        int begun = 0;
        const RunController runs(nullptr, [&begun](const Project& project, const std::stop_token&) {
            ++begun;
            return outcomeOf(project);
        });
        const Project project = newProject(Operation::traverse);
        const Issues missing{{IssueCode::missingKey, Severity::error, "/part/diameter_mm", {}, {}}};
        const OutcomePtr outcome = runs.outcomeOf(plainSetup(project), missing);
        QVERIFY(!outcome->ran());
        QCOMPARE(outcome->issues.size(), std::size_t(1));
        QCOMPARE(begun, 0);
        QVERIFY(runs.outcomeOf(plainSetup(project), {})->ran());
        QCOMPARE(begun, 1);
    }

    void theNewestOfManyRequestsWinsAndTheOthersAreDropped() {
        std::atomic<int> begun = 0;
        RunController runs(nullptr, [&begun](const Project& project, const std::stop_token& stop) {
            ++begun;
            return project.part->diameter_mm < 129.5 ? slowRun(project, stop) : outcomeOf(project);
        });
        std::vector<double> shown;
        connect(&runs, &RunController::finished, this, [&shown](const OutcomePtr& outcome) {
            shown.push_back(outcome->result.project.part->diameter_mm);
        });
        RunningTimer clock;
        for (int i = 0; i < 100; ++i) {
            runs.request(numbered(i));
        }
        runs.request(numbered(100));
        QTRY_VERIFY(!shown.empty());
        QTest::qWait(50);
        QCOMPARE(shown, std::vector<double>{130.0});
        QVERIFY2(clock.elapsed() < 2000, "superseded runs must stop");
    }

    void aResultThatFinishedBeforeItWasSupersededIsDropped() {
        RunController runs(nullptr, [](const Project& project, const std::stop_token&) {
            return outcomeOf(project); // heeds no stop
        });
        std::vector<double> shown;
        connect(&runs, &RunController::finished, this, [&shown](const OutcomePtr& outcome) {
            shown.push_back(outcome->result.project.part->diameter_mm);
        });
        runs.request(numbered(0));
        std::this_thread::sleep_for(50ms); // done, its delivery is queued
        runs.request(numbered(1));
        QTRY_VERIFY(!shown.empty());
        QTest::qWait(30);
        QCOMPARE(shown, std::vector<double>{31.0});
    }

    void closingDuringARunWaitsLessThanATenthOfASecond() {
        auto runs = std::make_unique<RunController>(nullptr, slowRun);
        QSignalSpy finished(runs.get(), &RunController::finished);
        runs->request(numbered(0));
        std::this_thread::sleep_for(30ms);
        RunningTimer clock;
        runs.reset();
        QVERIFY2(clock.elapsed() < 100, qPrintable(QString::number(clock.elapsed())));
        QTest::qWait(20);
        QCOMPARE(finished.count(), 0);
    }
};

} // namespace sparkout::test_run_controller

SPARKOUT_TEST(test_run_controller, TestRunController)
#include "test_run_controller.moc"
