// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// A usual search about a project's cycle, and what its answer is good for.
#include "core/study/search_edits.h"

#include "core/batch/batch_run.h"
#include "core/batch/scenario_source.h"
#include "core/batch/usual_batch.h"
#include "core/deadline_stop.h"
#include "core/phases/sampled_phases.h"
#include "core/project/batch.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/operation.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/search/grid.h"
#include "core/search/variants.h"
#include "core/setup/setup_file.h"
#include "core/setup/worn_project.h"
#include "core/simulation/simulate.h"
#include "core/study/new_project.h"
#include "core/study/search.h"
#include "core/study/starting_project.h"
#include "tests/core/support/project_samples.h"
#include "tests/registry.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <random>
#include <stop_token>
#include <string>
#include <vector>

namespace sparkout::test_usual_search {

Project example(const std::string& name) {
    return samples::projectIn("resources/examples/" + name + ".sparkout");
}

/// A plunge of three stages as a starting cycle has them.
Project journal() {
    Project p = example("plunge-shaft-two-stage");
    auto& stages = p.cycle->stages;
    Stage finish = stages.front(), sparkOut;
    stages.front().radial_feed_mm_min = 0.8;
    finish.radial_feed_mm_min = 0.1;
    finish.stock_mm = 0.04;
    sparkOut.stock_mm = 0.004;
    sparkOut.sparkOutFor(10);
    stages.front().stock_mm = p.part->stock_mm - finish.stock_mm - sparkOut.stock_mm;
    stages = {stages.front(), finish, sparkOut};
    p.optimisation.reset();
    return p;
}

OptimisationScenarios scenariosOf(const Project& project) {
    return project.optimisation->scenarios;
}

/// Of the surfaces of a trial, each about its starting cycle.
Project surfaceOfTrial(std::size_t surface) {
    const auto file = samples::sourcePath("tests/data/trials/val.sparkout");
    const Setup setup = readSetup(samples::readText(file)).setup.value();
    return withStartingCycle(withUsualBatch(wornProject(setup, surface).project));
}

int badFresh(const Project& project, int draw) {
    const ScenarioSource source(withFreshParts(project, draw));
    int bad = 0;
    for (std::int64_t part = 0; part < source.parts(); ++part) {
        bad += tried(source.project(part), {}).value().holds ? 0 : 1;
    }
    return bad;
}

/// A shaft of a random drawing with this roughness, with the usual cycle and search; empty where no
/// cycle can grind it.
std::optional<Project> drawnShaft(std::mt19937_64& bits, Operation operation, double ra_um) {
    const auto between = [&bits](double low, double high) {
        return std::round(low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53);
    };
    StartingDrawing drawing;
    drawing.operation = operation;
    drawing.diameter_mm = between(15, 100);
    drawing.lower_deviation_um = -between(10, 70);
    drawing.length_mm = operation->travels ? between(80, 200) : between(15, 45);
    drawing.stock_mm = between(10, 30) / 100;
    drawing.tolerance.roughness_ra_um = ra_um;
    Issues issues;
    const auto entries = startingEntries({}, drawing, issues);
    const StartingAnswer answer = entries ? drawnProject(drawing, *entries) : StartingAnswer();
    return answer.start ? std::optional(answer.start->project) : std::nullopt;
}

/// The levels that the second stage may have.
std::vector<double> finishLevels(const Project& project, const StageFeed& feed) {
    const Optimisation& search = *project.optimisation;
    std::vector<double> levels = levelValues(search.*feed.levels);
    if (const NumberRows& rows = search.*feed.byStage) {
        const std::vector<double>& bounds = rows->at(1);
        std::erase_if(levels, [&](double level) { return level < bounds[0] || level > bounds[1]; });
    }
    return levels;
}

/// Whether a feed of finishing has levels, all between these limits to half a step of the machine.
bool isFinishWithin(const Project& project, const StageFeed& feed, double low, double high) {
    const auto& range = project.machine->limits.*feed.range;
    const double slack = (range ? range->back() / 2 : 0) + 1e-9;
    const std::vector<double> levels = finishLevels(project, feed);
    return !levels.empty() && levels.front() >= low - slack && levels.back() <= high + slack;
}

/// Whether finishing is as slow as the roughness of the class, from 0, is usually ground with.
bool finishesSlowly(const Project& project, std::size_t roughness) {
    constexpr std::array plungeMost{0.08, 0.125, 0.16}, axialMost{0.2, 0.25, 0.35};
    const auto feedOf = [&project](const StageFeed& feed) {
        return *(project.cycle->stages.at(1).*feed.value);
    };
    const StageFeed& radial = project.operation->radial();
    if (!project.operation->travels) {
        const double least = std::min(0.05, feedOf(radial));
        return isFinishWithin(project, radial, least, plungeMost[roughness]);
    }
    constexpr double most_mm = 0.005;
    const StageFeed& axial = *project.operation->axial();
    const double turn = project.wheel->width_mm * project.machine->work_speed_rpm;
    return isFinishWithin(project, radial, std::min(0.6 * feedOf(radial), most_mm),
                          std::min(2 * feedOf(radial), most_mm))
           && isFinishWithin(project, axial, std::min(0.15 * turn, feedOf(axial)),
                             axialMost[roughness] * turn);
}

class TestUsualSearch : public QObject {
    Q_OBJECT

private slots:
    void itsGridIsAboutTheCycle() {
        Project p = journal();
        p.machine->limits.plunge_feed_mm_min = std::vector<double>{0.02, 5, 0.01};
        p.part->tolerance.roughness_ra_um = 0.8;
        p.batch.reset();
        const Project with = usualSearch(p);
        QVERIFY(!hasErrors(validate(with)));
        const Optimisation& search = *with.optimisation;
        QCOMPARE(search.scenarios, OptimisationScenarios::stocks);
        QVERIFY(search.non_increasing && !search.adaptive);
        QCOMPARE(search.stages, std::vector<double>{2});
        QCOMPARE(search.stock_step_mm, 0.001);
        const std::vector<double> levels = levelValues(search.radial_feed_mm_min);
        QVERIFY(std::ranges::is_sorted(levels));
        for (const double level : levels) {
            QVERIFY(std::abs(level * 100 - std::round(level * 100)) < 1e-6); // the machine's step
        }
        const auto& bounds = *search.stage_radial_feed_mm_min;
        QCOMPARE(bounds.size(), std::size_t(2));
        QCOMPARE(bounds[0][0], 0.4); // half of the roughing
        QCOMPARE(bounds[1][0], 0.05);
        QVERIFY(std::abs(bounds[1][1] - 0.125) < 0.0051); // in the machine's steps
        const auto& stocks = *search.stage_stock_mm;
        QCOMPARE(stocks.size(), std::size_t(3));
        QCOMPARE(stocks[1][0], 0.03); // the floor: three quarters
        QCOMPARE(stocks[1][1], std::min(0.08, std::round(p.part->stock_mm * 500) / 1000));
        QCOMPARE(stocks[2][1], 0.006);
        const std::vector<double> counts = levelValues(search.unfed_steps);
        QVERIFY(std::ranges::count(counts, 10) == 1 && std::ranges::count(counts, 15) == 1);
        QVERIFY(with.least_steps && with.least_overlap);
        QVERIFY(search.work_speed_rpm == Levels());
    }

    // What finishing feeds until the command of a late gauge is left to the spark-out.
    void aLateGaugeIsGivenMoreStockOfSparkOut() {
        Project p = journal();
        p.machine->gauge_delay_s = 0.1; // a revolution
        QVERIFY(p.machine->work_speed_rpm < 600);
        p.part->tolerance.roughness_ra_um = 0.8;
        const double fed_mm = 0.125 / p.machine->work_speed_rpm;
        const Project with = usualSearch(p);
        const double most_mm = with.optimisation->stage_stock_mm->at(2)[1];
        QVERIFY(std::abs(most_mm - 0.006 - fed_mm) <= 0.0005001);
    }

    // A machine with numerical control can be fed while it travels.
    void aNewProjectOnACncMachineSearchesTheContinuousInfeed() {
        auto drawing = drawingOf(parseSizeDesignation("40h6").value()).value();
        drawing.length_mm = 200;
        drawing.stock_mm = 0.15;
        drawing.tolerance.roughness_ra_um = 0.8;
        for (const char* machine : {"3М151Ф2", "3М151"}) {
            Issues issues;
            const auto entries = startingEntries({machine, {}, {}}, drawing, issues);
            const StartingAnswer answer = drawnProject(drawing, *entries);
            QVERIFY(answer.start && answer.start->project.operation->travels);
            const Project& project = answer.start->project;
            QVERIFY(gaugeDelay_s(project) > 0);
            QVERIFY(!hasErrors(validate(project)));
            QVERIFY(Variants(project).fault() == GridFault::none);
            const double levels = levelCount(project.optimisation->continuous_feed_mm_min);
            QCOMPARE(levels > 2, project.machine->name == "3М151Ф2");
        }
    }

    void itsLevelsHaveTheFeedsOfTheCycle() {
        for (const Project& p : {journal(), surfaceOfTrial(0), example("shaft-30h6-factory")}) {
            const Project with = usualSearch(p);
            const Optimisation& search = *with.optimisation;
            for (const Stage& stage : p.cycle->stages) {
                for (const StageFeed& feed : p.operation->feeds) {
                    const std::vector<double> levels = levelValues(search.*feed.levels);
                    QVERIFY(!stage.feeds() || std::ranges::count(levels, *(stage.*feed.value)) > 0);
                }
            }
        }
    }

    // An estimated Ra forbids no feed: the levels keep finishing slow, also about a cycle that
    // finishes as fast as it roughs.
    void finishingIsSlowWhereTheRoughnessIsOnlyEstimated() {
        constexpr std::array roughnesses{0.4, 0.8, 1.6};
        std::mt19937_64 bits(1);
        int drawn = 0;
        for (std::size_t i = 0; i < 50; ++i) {
            const std::size_t roughness = i % roughnesses.size();
            std::optional<Project> project = drawnShaft(
                bits, i % 2 == 0 ? Operation::plunge : Operation::traverse, roughnesses[roughness]);
            if (!project) {
                continue;
            }
            ++drawn;
            QVERIFY2(finishesSlowly(*project, roughness), QByteArray::number(qulonglong(i)));
            QVERIFY(project->optimisation->non_increasing);
            auto& stages = project->cycle->stages;
            for (const StageFeed& feed : project->operation->feeds) {
                stages[1].*feed.value = stages[0].*feed.value;
            }
            QVERIFY2(finishesSlowly(usualSearch(*project), roughness),
                     QByteArray::number(qulonglong(i)));
            project->wheel->roughness_factor = 2; // calibrated: Ra itself decides
            const Project calibrated = usualSearch(*project);
            QVERIFY(!calibrated.optimisation->stage_axial_feed_mm_min);
        }
        QVERIFY(drawn > 40);
    }

    // The answer, once it is the project's cycle, is the one to beat when it is searched again.
    void stoppedBeforeItHasAnotherItAnswersWithTheCycle() {
        const auto before = search(usualSearch(example("shaft-38-74h6")), {});
        const Project p = withFound(before->project, *before->answer());
        const Variants variants(p);
        bool has = false;
        for (std::size_t v = 0; v < variants.count(); ++v) {
            const Grid& grid = variants.grid(v);
            const auto found = grid.find(*p.cycle);
            has = has || found;
            QVERIFY(!found || grid.contains(*found));
            Cycle other = *p.cycle;
            other.stages.front().stock_mm += 0.0004; // between two steps of the grid
            QVERIFY(!grid.find(other));
        }
        QVERIFY(has);
        std::stop_source stop;
        SearchEvents events;
        const double own_s = simulate(p).time_s;
        events.note = [&](const SearchState& state) {
            if (state.best_s && std::abs(*state.best_s - own_s) < 1e-6) {
                stop.request_stop();
            }
        };
        const auto outcome = search(p, {}, stop.get_token(), events);
        QVERIFY(outcome->stopped() && outcome->answer());
        QVERIFY(std::abs(outcome->answer()->time_s - own_s) < 1e-6);
        QVERIFY(!outcome->proved());
    }

    // A cycle without spark-out that fails for some stocks is replaced as the middle of the grid by
    // a starting cycle on the machine as it is set; one that is fit stays.
    void aCycleThatIsUnfitIsNotSearchedAbout() {
        const auto has = [](const Project& p, const Cycle& cycle) {
            const Variants variants(p);
            bool found = false;
            for (std::size_t v = 0; v < variants.count(); ++v) {
                found |= variants.grid(v).find(cycle).has_value();
            }
            return found;
        };
        for (const char* name : {"slender-shaft", "shaft-30h6-calibrated", "shaft-30h6-slender",
                                 "plunge-accuracy-limit"}) {
            const Project p = usualSearch(withUsualBatch(example(name)));
            QVERIFY2(!hasErrors(validate(p)), name);
            const Cycle start = startingCycleInSteps(p);
            QCOMPARE(start.stages.size(), std::size_t{3});
            QVERIFY(start.stages.back().sparkOutSteps().value_or(0) > 0);
            double sum_mm = 0;
            for (const Stage& stage : start.stages) {
                sum_mm += stage.stock_mm;
            }
            QVERIFY(std::abs(sum_mm - p.part->stock_mm) < 1e-9);
            QVERIFY2(has(p, start) && !has(p, *p.cycle), name);
            Project started = p;
            *started.cycle = start;
            const std::optional<CycleTrial> trial = tried(started, {});
            QVERIFY2(trial && trial->holds, name);
        }
        for (const char* name : {"shaft-30h6-factory", "plunge-shaft-two-stage"}) {
            const Project p = usualSearch(example(name));
            QVERIFY2(has(p, *p.cycle), name);
            QVERIFY(p.optimisation->unfed_steps == Levels());
        }
    }

    // The starting cycle is fit for the batch, and the answer of a search that is stopped before it
    // has a quicker one.
    void aSearchAboutAStartingCycleHasAnAnswerEarly() {
        for (const char* name : {"slender-shaft", "shaft-30h6-calibrated"}) {
            Project p = example(name);
            p = usualSearch(p.batch ? p : withUsualBatch(p));
            Project started = p;
            *started.cycle = startingCycleInSteps(p);
            const double start_s = simulate(started).time_s;
            std::stop_source stop;
            SearchEvents events;
            events.note = [&stop, start_s](const SearchState& state) {
                if (state.best_s && std::abs(*state.best_s - start_s) < 1e-6) {
                    stop.request_stop();
                }
            };
            const auto outcome = search(p, {}, stop.get_token(), events);
            QVERIFY2(outcome->answer(), name);
            constexpr int otherDraw = 1000; // than any that a search tries its answers on
            const Project answer = withFound(p, *outcome->answer());
            QVERIFY2(badFresh(answer, otherDraw) <= mostFailing(freshPartCount, 1) * freshPartCount,
                     name);
        }
    }

    // Half the removal rate in a bore, more in soft steel.
    void roughingGoesToTheUsualRemovalRate() {
        Project p = journal();
        p.cycle->stages.front().radial_feed_mm_min = 0.2;
        const auto most = [](const Project& project) {
            const Project with = usualSearch(project);
            return with.optimisation->stage_radial_feed_mm_min->front()[1];
        };
        p.material->hardness_hrc = 60;
        const double hard = std::min(2 * 60 / (3.14159265 * p.part->diameter_mm), 1.2);
        QVERIFY(std::abs(most(p) - hard) < 0.011);
        p.material->hardness_hrc = 20;
        QVERIFY(most(p) > hard);
    }

    void aProjectWithABatchIsSearchedForItsCorners() {
        Project p = journal();
        QVERIFY(p.batch.has_value());
        QCOMPARE(scenariosOf(usualSearch(p)), OptimisationScenarios::corners);
        p.batch->factors.stock_mm = Factor{};
        p.batch->factors.stock_mm->uniform = std::vector<double>{-1, 5}; // cannot be run
        QCOMPARE(scenariosOf(usualSearch(p)), OptimisationScenarios::stocks);
    }

    // A stock of a micrometre cannot be shared by two stages: the grid is that which is offered.
    void withoutACycleInItsGridItIsStillForMoreThanTheNominalPart() {
        Project p = journal();
        p.cycle->stages = {p.cycle->stages.front()};
        p.part->stock_mm = p.cycle->stages.front().stock_mm = 0.001;
        const Project forBatch = usualSearch(p);
        QVERIFY(forBatch.optimisation->adaptive);
        QCOMPARE(scenariosOf(forBatch), checkBatch(p).empty() ? OptimisationScenarios::corners
                                                              : OptimisationScenarios::stocks);
        p.batch.reset();
        const Project forStocks = usualSearch(p);
        QVERIFY(forStocks.optimisation->adaptive);
        QCOMPARE(scenariosOf(forStocks), OptimisationScenarios::stocks);
    }

    void everyExampleHasOne() {
        for (const char* name : {"internal-plunge", "plunge-shaft-two-stage", "shaft-30h6-factory",
                                 "slender-shaft", "through-bore", "wheel-dull"}) {
            const Project with = usualSearch(example(name));
            QVERIFY2(!hasErrors(validate(with)), name);
            QVERIFY2(Variants(with).fault() == GridFault::none, name);
        }
    }

    // Between the corners a part may be bad: the answer is tried on parts drawn afresh. The long
    // run searches every example, and stops what takes too long.
    void itsAnswerIsGoodForFreshParts_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"plunge-shaft-two-stage", "shaft-30h6-factory"}) {
            QTest::newRow(name) << QString::fromLatin1(name);
        }
        if (qEnvironmentVariableIsSet("SPARKOUT_LONG")) {
            for (const auto& file :
                 std::filesystem::directory_iterator(samples::sourcePath("resources/examples"))) {
                const QString name = QString::fromStdString(file.path().stem().string());
                if (file.path().extension() == ".sparkout") {
                    QTest::addRow("long %s", qPrintable(name)) << name;
                }
            }
            for (int surface = 0; surface < 5; ++surface) {
                QTest::addRow("long %d", surface) << QString::number(surface);
            }
        }
    }
    void itsAnswerIsGoodForFreshParts() {
        QFETCH(QString, name);
        constexpr int otherDraw = 1000; // than any that a search tries its answers on
        constexpr double most_s = 20;   // of the long run
        const bool isLong = QByteArray(QTest::currentDataTag()).startsWith("long ");
        bool isOfTrial = false;
        const auto surface = static_cast<std::size_t>(name.toUInt(&isOfTrial));
        Project project = isOfTrial ? surfaceOfTrial(surface) : example(name.toStdString());
        if (!project.batch || !checkBatch(project).empty()) {
            project = withUsualBatch(project);
        }
        const Project with = usualSearch(project);
        const DeadlineStop deadline({}, isLong ? std::optional(DeadlineStop::Duration(most_s))
                                               : std::nullopt);
        const SearchOutcomePtr found = search(with, {}, deadline.token());
        QVERIFY(found->ran());
        const bool isStopped = found->search.status == SearchStatus::stopped;
        if (!found->best()) { // what is good itself has an answer
            QVERIFY(isStopped || badFresh(project, otherDraw) > 0
                    || !tried(project, {}).value().holds);
            return;
        }
        const int candidate = std::max(found->answer()->candidate, 1);
        const Project answer = withFound(with, *found->answer());
        QVERIFY(badFresh(answer, otherDraw)
                <= mostFailing(freshPartCount, candidate) * freshPartCount);
        if (!isLong) {
            QCOMPARE(found->answer()->freshParts.tried, freshPartCount);
            QCOMPARE(badFresh(answer, freshDraw(found->search.best->time_us)), 0);
        }
    }

    // A cycle with all parts good is rejected where its Ppk is below that required; where no cycle
    // has it, the answer is the one without that requirement, and says so.
    void itsAnswerHasThePpkThatIsRequired() {
        Project project = usualSearch(withUsualBatch(example("plunge-shaft-two-stage")));
        const auto answer = [&project](double leastPpk) {
            project.batch->least_ppk = leastPpk;
            return search(project, {});
        };
        constexpr double unreachable = 90;
        const SearchOutcomePtr usual = answer(0);
        const double more = *usual->answer()->freshParts.ppk + 0.02;
        const SearchOutcomePtr capable = answer(more), none = answer(unreachable);
        QVERIFY(usual->best() && capable->best() && none->best());
        const FreshParts without = usual->answer()->freshParts,
                         with = capable->answer()->freshParts;
        QVERIFY(without.isCapable && with.isCapable && *with.ppk >= more);
        QVERIFY(capable->robust->incapable > 0);
        QVERIFY(capable->answer()->time_s > usual->answer()->time_s);
        QVERIFY(!none->answer()->freshParts.isCapable);
        QVERIFY(none->robust->incapable > 0 && none->answer()->time_s >= usual->answer()->time_s);
    }

    // The same as the search of the nominal part with every stock wished.
    void everyStockIsASearchOfItsOwn() {
        Project p = usualSearch(journal());
        p.batch.reset();
        p.optimisation->scenarios = OptimisationScenarios::stocks;
        const SearchOutcomePtr stocks = search(p, {});
        p.optimisation->scenarios = OptimisationScenarios::nominal;
        const SearchOutcomePtr wished = search(p, {.phases = true});
        QVERIFY(stocks->ran() && stocks->robust.has_value());
        QCOMPARE(stocks->best() != nullptr, wished->best() != nullptr);
        if (stocks->best()) {
            QCOMPARE(stocks->answer()->time_s, wished->answer()->time_s);
        }
    }

    // Of a machine with a range for it, in its steps; about a cycle that has one, too.
    void aContinuousInfeedIsSearchedWhereTheMachineHasARange() {
        Project p = example("shaft-38-74h6");
        p.batch.reset();
        p.optimisation.reset();
        const Project without = usualSearch(p);
        QVERIFY(without.optimisation->continuous_feed_mm_min == Levels());
        p.machine->limits.continuous_feed_mm_min = std::vector<double>{0.005, 1, 0.005};
        const Project with = usualSearch(p);
        QVERIFY(!hasErrors(validate(with)));
        const Optimisation& search = *with.optimisation;
        const std::vector<double> levels = levelValues(search.continuous_feed_mm_min);
        QVERIFY(levels.size() > 4 && std::ranges::is_sorted(levels));
        for (const double level : levels) {
            QVERIFY(std::abs(level * 200 - std::round(level * 200)) < 1e-6);
        }
        QCOMPARE(search.stage_continuous_feed_mm_min->size(), std::size_t(2));
        QVERIFY(search.radial_feed_mm == without.optimisation->radial_feed_mm);
        const SearchOutcomePtr slower = sparkout::search(without, {});
        const SearchOutcomePtr found = sparkout::search(with, {});
        QVERIFY(found->ran() && slower->ran());
        QVERIFY(!slower->best()
                || (found->best() && found->answer()->time_s <= slower->answer()->time_s));
        if (found->best()) {
            qInfo("38.74h6 for every stock: %.3f min, at the reversals alone %.3f min",
                  found->answer()->time_s / 60, slower->best() ? slower->answer()->time_s / 60 : 0);
        }
        Project fed = samples::projectIn("tests/data/trials/limit-continuous.sparkout");
        fed.machine->limits.continuous_feed_mm_min = std::vector<double>{0.005, 1, 0.005};
        fed.batch.reset();
        const Project about = usualSearch(fed);
        QVERIFY(about.optimisation->stage_continuous_feed_mm_min.has_value());
    }

    // A trial found 1.03 min for the stated stock, by hand; the search has that cycle in its grid.
    void withAContinuousInfeedTheShaftTakesNoMoreThanATrialFound() {
        Project p = samples::projectIn("tests/data/trials/limit-continuous.sparkout");
        constexpr double trial_s = 1.03 * 60;
        const std::optional<CycleTrial> byHand = tried(p, {});
        QVERIFY(byHand->holds);
        p.machine->limits.continuous_feed_mm_min = std::vector<double>{0.005, 1, 0.005};
        p.optimisation->stages = {2};
        p.optimisation->axial_feed_mm_min = std::vector<double>{2000, 3000, 4000, 5000};
        p.optimisation->continuous_feed_mm_min =
            std::vector<double>{0.005, 0.01, 0.02, 0.05, 0.1, 0.2, 0.3};
        const SearchOutcomePtr found = search(p, {});
        QVERIFY(found->ran() && found->proved());
        QVERIFY2(found->answer()->time_s <= trial_s,
                 QByteArray::number(found->answer()->time_s / 60));
        QVERIFY(found->answer()->cycle.stages.front().continuousFeed_mm_min() > 0);
        QCOMPARE(found->limit.cycles.continuousFeed_mm_min, 1.0); // the machine's range
        QVERIFY(!isKnownLimit(found->limit.time_s)
                || found->limit.time_s <= found->answer()->time_s);
        qInfo("38.74h6 as stated, continuous infeed free: %.3f min, limit %.3f min",
              found->answer()->time_s / 60, found->limit.time_s / 60);
    }

    void anAnswerAtAnEndOfSettingsIsSaid() {
        Project p = example("shaft-30h6-factory");
        p.optimisation->work_speed_rpm = std::vector<double>{150, 200};
        p.optimisation->unfed_steps = std::vector<double>{0, 2, 4};
        p.machine->limits.work_speed_rpm = std::vector<double>{50, 200, 1};
        Cycle cycle = *p.cycle;
        while (!cycle.stages.back().feeds()) {
            cycle.stages.pop_back();
        }
        MachineSettings machine = machineSettings(p);
        machine.work_speed_rpm = 200;
        std::vector<SettingEdge> edges = settingEdgesReached(p, cycle, machine);
        QCOMPARE(edges.size(), std::size_t(2));
        QCOMPARE(std::string(edges[0].key), std::string("work_speed_rpm"));
        QVERIFY(edges[0].isMost && edges[0].isLimit);
        QCOMPARE(std::string(edges[1].key), std::string("spark_out"));
        QVERIFY(!edges[1].isMost && edges[1].isLimit); // none: no grid goes beyond
        machine.work_speed_rpm = 150;
        edges = settingEdgesReached(p, cycle, machine);
        QVERIFY(!edges[0].isMost && !edges[0].isLimit);
        QCOMPARE(edges[0].limit, std::optional(50.0));
        p.optimisation->work_speed_rpm = std::vector<double>{150}; // not searched
        QCOMPARE(settingEdgesReached(p, cycle, machine).size(), std::size_t(1));
    }

    // The wheel makes 1000 revolutions a minute: 200 and 250 are ruled out by 5 and 4 of the
    // work's.
    void anEndOfTheWorkSpeedsIsThatOfThoseAllowed() {
        Project p = example("shaft-30h6-factory");
        p.machine->wheel_speed_m_s = 3.14159265358979 * p.wheel->diameter_mm / 60;
        p.machine->limits.work_speed_rpm = std::vector<double>{50, 250, 1};
        p.optimisation->least_ratio_distance = 0.2;
        p.optimisation->work_speed_rpm = std::vector<double>{150, 180, 200, 250};
        const auto edgeAt = [&p](double work_rpm) -> std::optional<SettingEdge> {
            MachineSettings machine = machineSettings(p);
            machine.work_speed_rpm = work_rpm;
            for (const SettingEdge& edge : settingEdgesReached(p, *p.cycle, machine)) {
                if (std::string(edge.key) == "work_speed_rpm") {
                    return edge;
                }
            }
            return std::nullopt;
        };
        const auto isAllowed = [](double work_rpm) {
            const double ratio = 1000 / work_rpm;
            return std::abs(ratio - std::round(ratio)) >= 0.2;
        };
        const std::optional<SettingEdge> most = edgeAt(180); // 150 is 6.67, 180 is 5.56
        QVERIFY(most && most->isMost && !most->isLimit && most->level == 180);
        QCOMPARE(*most->limit, 238.0); // 1000 / 4.2 = 238.1
        QVERIFY(isAllowed(238) && !isAllowed(239));
        const std::optional<SettingEdge> least = edgeAt(150);
        QVERIFY(least && !least->isMost && !least->isLimit);
        for (double each = 50; each < *least->limit; ++each) {
            QVERIFY(!isAllowed(each));
        }
        QVERIFY(isAllowed(*least->limit) && *least->limit < 150);
        p.optimisation->least_ratio_distance.reset();
        p.wheel->runout.emplace(); // no default distance: 200 and 250 are levels beyond
        QVERIFY(!edgeAt(180));
        QVERIFY(edgeAt(250)->isLimit);
        p.optimisation->least_ratio_distance = 0.4; // 179…185 between 5 and 6 revolutions
        p.machine->limits.work_speed_rpm = std::vector<double>{50, 190, 1};
        p.optimisation->work_speed_rpm = std::vector<double>{180, 183, 190};
        QVERIFY(edgeAt(183) && edgeAt(183)->isMost && !edgeAt(183)->isLimit);
        QCOMPARE(*edgeAt(183)->limit, 185.0); // not 190, the end of the machine's range
        p.optimisation->work_speed_rpm = std::vector<double>{180, 185, 190};
        QVERIFY(edgeAt(185)->isLimit);
        p.optimisation->work_speed_rpm = std::vector<double>{150, 200}; // one is left: not searched
        QVERIFY(!edgeAt(150));
    }

    // By the definition: every speed of the machine beyond the level is tried.
    void theFarthestSpeedIsThatOfTryingAll() {
        std::mt19937_64 bits(5);
        const auto between = [&bits](double low, double high) {
            return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
        };
        Project p = example("shaft-30h6-factory");
        int none = 0;
        for (int i = 0; i < 200; ++i) {
            const double step = i % 3 == 0 ? 5 : 1, low = std::round(between(20, 100));
            const double high = low + step * std::round(between(5, 200));
            p.machine->limits.work_speed_rpm = std::vector<double>{low, high, step};
            p.machine->wheel_speed_m_s = between(5, 40);
            const double least = *(p.optimisation->least_ratio_distance = between(0.05, 0.45));
            const double wheel_rpm =
                p.machine->wheel_speed_m_s * 60000 / (3.14159265358979 * p.wheel->diameter_mm);
            const double level = low + step * std::floor(between(0, (high - low) / step + 1));
            for (const bool isMost : {false, true}) {
                double expected = level;
                for (double n = isMost ? high : low; isMost ? n > level : n < level;
                     n += isMost ? -step : step) {
                    const double ratio = wheel_rpm / n;
                    if (std::abs(ratio - std::max(std::round(ratio), 1.0)) >= least) {
                        expected = n;
                        break;
                    }
                }
                none += expected == level ? 1 : 0;
                QCOMPARE(farthestSpeed_rpm(p, level, isMost ? high : low), expected);
            }
        }
        QVERIFY(none > 5 && none < 200);
    }
};

} // namespace sparkout::test_usual_search

SPARKOUT_TEST(test_usual_search, TestUsualSearch)
#include "test_usual_search.moc"
