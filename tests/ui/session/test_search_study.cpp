// SPDX-License-Identifier: GPL-3.0-or-later
// Searches beside the window: the answer is the engine's, a stop keeps the best and its bound, the
// newest wins.
#include "core/batch/scenario_source.h"
#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/constraints.h"
#include "core/search/limit.h"
#include "core/simulation/simulate.h"
#include "core/study/search_edits.h"
#include "core/study/search_outputs.h"
#include "tests/core/support/batch_fixtures.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"
#include "tests/tries.h"
#include "tests/ui/support/search_fixtures.h"
#include "ui/session/studies.h"
#include "words/search_words.h"

#include <nlohmann/json.hpp>

#include <QElapsedTimer>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

namespace sparkout::test_search_study {

constexpr int patience_ms = 120'000;

/// A study of searches, and what it reports.
struct Heard {
    Heard() {
        QObject::connect(&study().job(), &Job::answered, &study().job(), [this] {
            const SearchOutcomePtr& outcome =
                study().refusal() ? study().refusal() : study().result();
            (study().running() ? answers : outcomes).push_back(outcome);
        });
        QObject::connect(&study().job(), &Job::progressed, &study().job(),
                         [this] { states.push_back(study().state()); });
    }
    SearchStudy& study() { return studies.search; }
    std::vector<SearchOutcomePtr> outcomes, answers;
    std::vector<SearchState> states;
    Studies studies; ///< last: ended before what it reports to is gone
};

SearchOutcomePtr searched(const Project& project, SearchWish wish = {}) {
    wish.front = true;
    Heard heard;
    heard.study().start(project, wish);
    const bool done = QTest::qWaitFor([&] { return !heard.outcomes.empty(); }, patience_ms);
    return done ? heard.outcomes.front() : nullptr;
}

bool holdsAll(const Project& project) {
    const SimulationResult result = simulate(project);
    const auto all = evaluateConstraints(result);
    return result.status == RunStatus::completed
           && std::ranges::all_of(all, [](const ConstraintResult& each) { return each.holds; });
}

bool sameCycle(const Cycle& a, const Cycle& b) {
    return std::ranges::equal(a.stages, b.stages, [](const Stage& x, const Stage& y) {
        return x.radial_feed_mm == y.radial_feed_mm && x.axial_feed_mm_min == y.axial_feed_mm_min
               && x.radial_feed_mm_min == y.radial_feed_mm_min && x.stock_mm == y.stock_mm;
    });
}

class TestSearchStudy : public QObject {
    Q_OBJECT

private slots:
    void theAnswerIsThatOfTheEngine() {
        const Project project = fixtures::searchedShaft();
        const SearchOutcomePtr outcome = searched(project);
        QVERIFY(outcome && outcome->ran() && outcome->proved());
        const SearchSummary engine = optimise(project);
        QVERIFY(engine.best.has_value());
        QCOMPARE(outcome->best()->time_s, engine.best->time_s);
        QCOMPARE(outcome->best()->leastRelativeMargin, engine.best->leastRelativeMargin);
        QVERIFY(sameCycle(outcome->best()->cycle, engine.cycle));
        QCOMPARE(outcome->limit.time_s, steplessLimit_s(project));
        QCOMPARE(outcome->search.bound_s, outcome->best()->time_s);
        QCOMPARE(outcome->numbers.size(), std::size_t{2});
        for (const SearchedNumber& number : outcome->numbers) {
            Project alone = project;
            alone.optimisation->stages = {double(number.stages)};
            const SearchSummary own = optimise(alone);
            QVERIFY(own.best.has_value() == number.best_s.has_value());
            QVERIFY(!own.best || own.best->time_s == *number.best_s);
        }
    }

    /// Answer, front and sentences of every example are those that the command line prints; of a
    /// front that takes longer than its time, as far as both came.
    void everyExampleHasTheAnswerOfTheCommandLine() {
        int searches = 0;
        for (const auto& file :
             std::filesystem::directory_iterator(samples::sourcePath("resources/examples"))) {
            const auto read = file.is_regular_file()
                                  ? readProject(samples::readText(file.path())).project
                                  : std::nullopt;
            const bool isLong = std::getenv("SPARKOUT_LONG") != nullptr;
            if (!read || !read->optimisation
                || (!isLong && file.path().stem() != "shaft-30h6-factory"
                    && file.path().stem() != "shaft-38-74h6")) {
                continue;
            }
            const SearchOutcomePtr outcome = searched(*read);
            const SearchOutcomePtr line = sparkout::search(*read, {.front = true});
            QVERIFY(outcome && outcome->proved() && line->proved());
            const SearchWording words;
            QVERIFY(words.answer(*outcome, outcome->given.time_s)
                    == words.answer(*line, line->given.time_s));
            nlohmann::json one = nlohmann::json::parse(searchJson(*outcome)),
                           other = nlohmann::json::parse(searchJson(*line));
            const nlohmann::json oneFront = one.at("front"), otherFront = other.at("front");
            for (std::size_t i = 0; i < std::min(oneFront.size(), otherFront.size()); ++i) {
                QVERIFY(oneFront[i] == otherFront[i]);
            }
            if (outcome->isFrontWhole && line->isFrontWhole) {
                QVERIFY(words.front(*outcome) == words.front(*line));
            } else {
                for (const char* key : {"front", "front_is_whole"}) {
                    one.erase(key);
                    other.erase(key);
                }
            }
            QVERIFY(one == other);
            ++searches;
        }
        QVERIFY(searches >= 2);
    }

    /// The spark-out that is searched besides is no stage of those that are listed.
    void aSparkOutIsNoStageOfThoseListed() {
        Project project = fixtures::searchedShaft();
        project.optimisation->unfed_steps = std::vector<double>{2};
        const SearchOutcomePtr outcome = searched(project);
        QVERIFY(outcome && outcome->proved());
        QVERIFY(!outcome->best()->cycle.stages.back().feeds());
        QCOMPARE(outcome->numbers.size(), std::size_t{2});
        for (std::size_t i = 0; i < 2; ++i) {
            const SearchedNumber& number = outcome->numbers[i];
            QCOMPARE(number.stages, static_cast<int>(i) + 1);
            Project alone = project;
            alone.optimisation->stages = {double(number.stages)};
            const SearchSummary own = optimise(alone);
            QVERIFY(own.best.has_value() == number.best_s.has_value());
            QVERIFY(!own.best || own.best->time_s == *number.best_s);
        }
    }

    void theMachineFoundGoesWithTheCycle() {
        Project project = fixtures::searchedShaft();
        const SearchOutcomePtr usual = searched(project);
        project.optimisation->work_speed_rpm =
            std::vector<double>{project.machine->work_speed_rpm, 260};
        project.optimisation->unfed_steps = std::vector<double>{0, 1};
        const SearchOutcomePtr outcome = searched(project);
        QVERIFY(usual && outcome && outcome->proved());
        QVERIFY(outcome->best()->time_s <= usual->best()->time_s);
        QCOMPARE(outcome->best()->machine.work_speed_rpm, optimise(project).machine.work_speed_rpm);
        for (const FoundCycle& found : outcome->found) {
            Project part = project;
            *part.cycle = found.cycle;
            setMachine(part, found.machine);
            QVERIFY(holdsAll(part));
            QVERIFY(std::abs(simulate(part).time_s - found.time_s) <= 1e-6);
            QVERIFY(sameSearch(part, project)); // taken, the search is not out of date
        }
    }

    // Every cycle of the list is one of the grid that holds, none is quicker than the first, and
    // the best of each number of stages is marked.
    void whatWasFoundHoldsAndTheQuickestIsFirst() {
        const Project project = fixtures::searchedShaft();
        const SearchOutcomePtr outcome = searched(project);
        QVERIFY(outcome && outcome->found.size() > 1);
        double before = 0;
        for (const FoundCycle& found : outcome->found) {
            Project part = project;
            *part.cycle = found.cycle;
            QVERIFY(holdsAll(part));
            QVERIFY(std::abs(simulate(part).time_s - found.time_s) <= 1e-6);
            QVERIFY(found.time_s >= before);
            before = found.time_s;
            const auto stages = static_cast<int>(found.cycle.stages.size());
            const auto number =
                std::ranges::find(outcome->numbers, stages, &SearchedNumber::stages);
            QVERIFY(number != outcome->numbers.end());
            QVERIFY(!found.isBestOfItsNumber || found.time_s == *number->best_s);
        }
        QCOMPARE(std::ranges::count_if(outcome->found, &FoundCycle::isBest), 1);
    }

    void slowerCyclesFartherFromTheirLimitsAreListed() {
        const SearchOutcomePtr outcome = searched(fixtures::searchedShaft());
        QVERIFY(outcome && outcome->proved());
        QVERIFY(outcome->best()->by == FoundBy::margin); // the first of them
        int offered = 0;
        for (const FoundCycle& one : outcome->found) {
            const auto beats = [&one](const FoundCycle& other) {
                return other.time_s <= one.time_s
                       && other.leastRelativeMargin > one.leastRelativeMargin;
            };
            if (one.by == FoundBy::margin) {
                QVERIFY(std::ranges::none_of(outcome->found, beats));
                ++offered;
            }
        }
        QVERIFY(offered > 1);
    }

    // Margins by time may take as long as the search did: the answer is shown before.
    void theProvedAnswerComesBeforeTheMarginsByTime() {
        const Project project = fixtures::searchedShaft();
        Heard heard;
        heard.study().start(project, {.front = true});
        QTRY_VERIFY_WITH_TIMEOUT(!heard.outcomes.empty(), patience_ms);
        QCOMPARE(heard.answers.size(), std::size_t{1});
        const SearchOutcome &answer = *heard.answers.front(), &whole = *heard.outcomes.front();
        QVERIFY(answer.proved() && answer.isFrontComing && answer.front().empty());
        QVERIFY(answer.binding.has_value());
        QCOMPARE(answer.limit.time_s, whole.limit.time_s);
        QCOMPARE(answer.best()->time_s, whole.best()->time_s);
        QVERIFY(sameCycle(answer.best()->cycle, whole.best()->cycle));
        QVERIFY(!whole.isFrontComing && !whole.front().empty());
    }

    void aRefinedCycleStandsBeforeTheBestOfTheGrid() {
        const Project project = fixtures::searchedShaft();
        const SearchOutcomePtr plain = searched(project);
        const SearchOutcomePtr outcome = searched(project, {.refine = true});
        QVERIFY(plain && outcome && !plain->refined() && outcome->proved());
        QCOMPARE(outcome->best()->time_s, plain->best()->time_s);
        const FoundCycle* refined = outcome->refined();
        QVERIFY(refined && refined->time_s < outcome->best()->time_s);
        Project part = project;
        *part.cycle = refined->cycle;
        QVERIFY(holdsAll(part));
        QVERIFY(std::abs(simulate(part).time_s - refined->time_s) <= 1e-6);
    }

    void aStopKeepsTheBestAndAProvenBound() {
        Heard heard;
        const double stop_ms = leastOfTries_ms(4 * 100, [&] {
            heard.states.clear();
            heard.outcomes.clear();
            heard.study().start(fixtures::endlessSearch(), {});
            const bool found = QTest::qWaitFor(
                [&] { return !heard.states.empty() && heard.states.back().best_s; }, patience_ms);
            heard.study().job().stop();
            QElapsedTimer took;
            took.start();
            const bool told = QTest::qWaitFor([&] { return !heard.outcomes.empty(); }, patience_ms);
            return found && told ? double(took.elapsed()) : std::numeric_limits<double>::infinity();
        });
        qInfo("stopped after %g ms", stop_ms);
        QVERIFY2(stop_ms <= 4 * 100, qPrintable(QString::number(stop_ms)));
        QVERIFY(!heard.outcomes.empty());
        const SearchOutcome& outcome = *heard.outcomes.front();
        QVERIFY(outcome.stopped() && !outcome.proved() && outcome.best());
        QVERIFY(outcome.search.bound_s > 0 && outcome.search.bound_s <= outcome.best()->time_s);
        QVERIFY(outcome.search.bound_s >= outcome.limit.time_s);
        QVERIFY(!heard.study().running());
    }

    /// Stopped and started again it has the answer of one in a piece; a pruned one begins anew.
    void aFullSearchThatWasStoppedIsContinued() {
        Project project = fixtures::searchedShaft();
        project.part->radii_per_section = 360; // long enough to be stopped
        const SearchWish wish{.method = SearchMethod::full, .front = true};
        const SearchOutcomePtr whole = searched(project, wish);
        QVERIFY(whole && whole->proved());
        Heard heard;
        SearchStudy& study = heard.study();
        int continued = 0;
        for (int piece = 0; piece < 4; ++piece) { // the last to its end
            heard.outcomes.clear();
            study.start(project, wish);
            QVERIFY(!study.isContinued(project, wish)); // while it runs
            if (piece < 3) {
                QVERIFY(QTest::qWaitFor(
                    [&] { return study.state().evaluations > 0 || !study.running(); },
                    patience_ms));
                study.job().stop();
            }
            QTRY_VERIFY_WITH_TIMEOUT(!study.running(), patience_ms);
            continued += study.isContinued(project, wish) ? 1 : 0;
        }
        QVERIFY2(continued > 0, qPrintable(QString::number(continued)));
        QVERIFY(!study.isContinued(project, wish));
        const SearchOutcome& again = *study.result();
        QVERIFY(again.proved() && again.method == SearchMethod::full);
        QCOMPARE(again.search.evaluations, whole->search.evaluations);
        QCOMPARE(again.search.gridSize, whole->search.gridSize);
        QCOMPARE(again.best()->time_s, whole->best()->time_s);
        QCOMPARE(again.best()->leastRelativeMargin, whole->best()->leastRelativeMargin);
        QVERIFY(sameCycle(again.best()->cycle, whole->best()->cycle));
        QVERIFY(again.binding == whole->binding);
        QVERIFY(std::ranges::equal(again.numbers, whole->numbers, [](const auto& a, const auto& b) {
            return a.stages == b.stages && a.status == b.status && a.best_s == b.best_s
                   && a.bound_s == b.bound_s;
        }));
    }

    void onlyWhatWasAskedIsContinued() {
        const Project project = fixtures::endlessSearch();
        const SearchWish wish{.method = SearchMethod::full};
        Heard heard;
        SearchStudy& study = heard.study();
        const auto stopped = [&](const SearchWish& asked) {
            study.start(project, asked);
            const bool begun = QTest::qWaitFor(
                [&] { return study.state().evaluations > 0 || study.state().best_s; }, patience_ms);
            study.job().stop();
            return begun && QTest::qWaitFor([&] { return !study.running(); }, patience_ms);
        };
        QVERIFY(stopped({}));
        QVERIFY(!study.isContinued(project, {}));
        QVERIFY(stopped(wish));
        QVERIFY(study.isContinued(project, wish));
        QVERIFY(study.isContinued(project, {.method = SearchMethod::full, .refine = true}));
        QVERIFY(!study.isContinued(project, {}));
        QVERIFY(!study.isContinued(project, {.method = SearchMethod::full, .phases = true}));
        Project other = project;
        other.cycle->stages.pop_back();
        QVERIFY(study.isContinued(other, wish)); // its own cycle is no part of the grid
        other.wheel->dullness *= 1.01;
        QVERIFY(!study.isContinued(other, wish));
        const long long before = study.result()->search.evaluations;
        QVERIFY(stopped(wish));
        QVERIFY(study.result()->search.evaluations >= before);
        study.forget();
        QVERIFY(!study.isContinued(project, wish));
    }

    void theNewestSearchWinsAndADroppedOneSaysNothing() {
        Heard heard;
        heard.study().start(fixtures::endlessSearch(), {});
        QTest::qWait(50);
        const Project newest = fixtures::searchedShaft();
        heard.study().start(newest, {});
        QTRY_VERIFY_WITH_TIMEOUT(!heard.outcomes.empty(), patience_ms);
        QVERIFY(sameSearch(heard.outcomes.front()->project, newest));
        heard.study().start(fixtures::endlessSearch(), {});
        QTest::qWait(50);
        heard.study().job().drop();
        QTest::qWait(300);
        QCOMPARE(heard.outcomes.size(), std::size_t{1});
    }

    void whatCannotBeSearchedIsTold() {
        Project project = fixtures::searchedShaft();
        project.optimisation->axial_feed_mm_min = {};
        QVERIFY(searched(project)->fault == GridFault::noLevels);
        project = fixtures::searchedShaft();
        project.cycle->stages.clear();
        const SearchOutcomePtr refused = searched(project);
        QVERIFY(!refused->ran() && !refused->best() && hasErrors(refused->issues));
        project = fixtures::searchedShaft();
        project.optimisation->scenarios = OptimisationScenarios::corners;
        project.batch = Batch{};
        project.batch->factors.dullness = fixtures::uniform(0.03, 0.01);
        const SearchOutcomePtr outcome = searched(project);
        QVERIFY(outcome->fault == GridFault::none && !outcome->batchIssues.empty());
        QVERIFY(!outcome->ran() && !outcome->best());
    }

    // The cycle that holds in all corners holds in each of them, and is no quicker than that of the
    // part alone.
    void aCycleForAllCornersHoldsInEachOfThem() {
        Project project = fixtures::searchedShaft();
        const SearchOutcomePtr alone = searched(project);
        project.batch = Batch{};
        project.batch->factors.dullness = fixtures::uniform(0.01, 0.05);
        project.batch->factors.initial_runout_mm = fixtures::uniform(0.01, 0.04);
        project.optimisation->scenarios = OptimisationScenarios::corners;
        const SearchOutcomePtr outcome = searched(project);
        QVERIFY(outcome && outcome->robust && outcome->best());
        QVERIFY(outcome->best()->time_s >= alone->best()->time_s);
        QCOMPARE(outcome->robust->nominalTime_s, alone->best()->time_s);
        QVERIFY(!alone->robust);
        Project corners = project;
        *corners.cycle = outcome->best()->cycle;
        corners.batch->scenarios = Scenarios::corners;
        const ScenarioSource source(corners);
        QCOMPARE(source.parts(), std::int64_t{4});
        for (std::int64_t part = 0; part < source.parts(); ++part) {
            QVERIFY(holdsAll(source.project(part)));
        }
    }

    void aUsualSearchCanBeSearchedWhateverTheProject() {
        for (Project project : {fixtures::traverse(), fixtures::plunge()}) {
            for (const double scale : {0.03, 1.0, 7.0}) {
                Project scaled = project;
                scaled.part->stock_mm *= scale;
                for (Stage& stage : scaled.cycle->stages) {
                    stage.stock_mm *= scale;
                }
                const Project usual = withUsualSearch(scaled);
                QVERIFY(usual.optimisation.has_value());
                QVERIFY(!hasErrors(validate(usual)));
                QVERIFY(Grid(usual).fault() == GridFault::none);
                QVERIFY(Grid(usual).size() > 50);
            }
        }
    }

    /// Also at the end of what a feed may be, and where the machine's range begins beyond it.
    void aUsualSearchHasLevelsThatAFileMayHold() {
        Project project = fixtures::plunge();
        for (const auto& range :
             {std::vector<double>{}, {50.0, 1000.0, 1.0}, {900.0, 1000.0, 1.0}}) {
            for (const double feed : {0.5, 80.0, 100.0}) {
                for (Stage& stage : project.cycle->stages) {
                    stage.radial_feed_mm_min = feed;
                }
                project.machine->limits.plunge_feed_mm_min.reset();
                if (!range.empty()) {
                    project.machine->limits.plunge_feed_mm_min = range;
                }
                for (const Issue& issue : validate(withUsualSearch(project))) {
                    QVERIFY2(issue.severity != Severity::error
                                 || issue.path.find("/optimisation/radial_feed_mm_min/") != 0,
                             issue.path.c_str());
                }
            }
        }
    }

    void onlyWhatTheAnswerRestsOnMakesAnotherSearch() {
        const Project project = fixtures::searchedShaft();
        Project other = project;
        other.title = "Another name";
        other.cycle->stages.pop_back();
        other.batch = Batch{};
        QVERIFY(sameSearch(project, other));
        other.optimisation->scenarios = OptimisationScenarios::batch;
        QVERIFY(!sameSearch(project, other));
        other = project;
        other.wheel->dullness *= 1.01;
        QVERIFY(!sameSearch(project, other));
    }
};

} // namespace sparkout::test_search_study

SPARKOUT_TEST(test_search_study, TestSearchStudy)
#include "test_search_study.moc"
