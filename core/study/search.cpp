// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/search.h"

#include "core/batch/batch_run.h"
#include "core/deadline_stop.h"
#include "core/grace_stop.h"
#include "core/project/optimisation.h"
#include "core/project/validate.h"
#include "core/quality/roughness.h"
#include "core/quality/shop_numbers.h"
#include "core/quality/verdict.h"
#include "core/search/binding.h"
#include "core/search/judge.h"
#include "core/search/refine.h"
#include "core/search/robust.h"
#include "core/simulation/simulate.h"
#include "core/study/search_edits.h"

#include <algorithm>
#include <chrono>
#include <functional>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

/// Results of a robust search that a refinement of its answer needs.
struct RobustTrail {
    std::vector<Project> scenarios; ///< scenarios that it added
    int candidates = 0;             ///< number of cycles tried on fresh phases
    bool isCapable = true;          ///< FreshParts::isCapable of the answer
};

/// The answer of a search of a grid.
struct GridAnswer {
    const Project& asked; ///< the project that was searched
    const Project& best;  ///< the project with the machine settings of the answer
    const Cycle& cycle;
    std::optional<RobustTrail> robust; ///< only for a robust search
};

/// Refines an answer off the grid; the answer of a robust search in the scenarios that it added and
/// in fresh ones.
[[nodiscard]] RefineSummary refineAnswer(const GridAnswer& answer, const std::stop_token& stop);

RefineSummary refineAnswer(const GridAnswer& answer, const std::stop_token& stop) {
    RefineOptions options;
    options.stop = stop;
    if (answer.robust) {
        options.everyStageSteps = true;
        options.scenarios = answer.robust->scenarios;
        options.source = undecidedScenarios(answer.asked, stop);
        options.candidates = answer.robust->candidates;
        options.asksCapability = answer.robust->isCapable;
    }
    return refine(answer.best, answer.cycle, options);
}

/// The search of one grid, as the project specifies it.
struct SearchedGrid {
    SearchSummary search;
    std::optional<RobustSummary> robust{};
    std::optional<IntervalSummary> interval{};

    [[nodiscard]] bool hasBest() const { return search.best && (!robust || robust->holdsInSample); }
};

/// The faults that prevent a search, found before it begins.
std::shared_ptr<SearchOutcome> checked(const Project& project, const SearchWish& wish,
                                       const std::stop_token& stop) {
    auto outcome = std::make_shared<SearchOutcome>();
    outcome->project = withMeasuredRa(project);
    outcome->method = wish.method;
    outcome->wishesFront = wish.front;
    outcome->issues = validate(project);
    if (hasErrors(outcome->issues)) {
        std::erase_if(outcome->issues,
                      [](const Issue& issue) { return issue.severity != Severity::error; });
        return outcome;
    }
    outcome->issues.clear();
    outcome->marginWithin_us = marginWithinOf(project);
    outcome->isOtherOperation = isHeuristic(wish.method) && project.operation->axial();
    outcome->isOtherAim =
        (outcome->marginWithin_us || outcome->objective() != SearchObjective::time)
        && (isHeuristic(wish.method) || wish.refine);
    outcome->objectiveFault = objectiveFault(project, wish.phases);
    outcome->fault = Variants(project, stop).fault();
    if (outcome->ran() && areOfBatch(project.optimisation->scenarios)) {
        outcome->batchIssues = checkBatch(project);
    }
    return outcome;
}

GivenCycle givenCycle(const Project& project, const std::stop_token& stop) {
    GivenCycle given;
    const SimulationResult result = simulateUnchecked(project, nullptr, stop);
    given.isStopped = result.status == RunStatus::stopped;
    if (result.status == RunStatus::completed) {
        given.time_s = result.time_s;
        for (const ConstraintResult& each : worstByKind(evaluateConstraints(result))) {
            given.margin =
                std::min(given.margin.value_or(each.relativeMargin), each.relativeMargin);
            if (!each.holds) {
                given.fails.push_back(each.kind);
            }
        }
    }
    return given;
}

/// Searches the whole grid with each round of its levels, then computes the additional results.
class Search {
public:
    using Clock = std::chrono::steady_clock;

    Search(std::shared_ptr<SearchOutcome> outcome, const SearchWish& wish, std::stop_token stop,
           SearchEvents events)
        : m_outcome(std::move(outcome))
        , m_wish(wish)
        , m_levels(m_outcome->project)
        , m_now(m_outcome->project, stop)
        , m_robust(wish.phases
                   || m_outcome->project.optimisation->scenarios != OptimisationScenarios::nominal)
        , m_stop(std::move(stop))
        , m_events(std::move(events)) {
        if (m_outcome->objective() != SearchObjective::time) {
            m_outcome->wear = wish.wear.value_or(SurfaceWear(m_outcome->project));
        }
    }

    void run() {
        const auto began = Clock::now();
        searchLevels();
        const auto took = Clock::now() - began;
        listFound();
        weigh();
        if (m_wish.refine && m_outcome->best()) {
            refineBest();
        }
        remark();
        if (m_wish.front && m_outcome->best() && !m_outcome->stopped()
            && !isHeuristic(m_wish.method)) {
            showAnswer();
            const auto numbersBegan = Clock::now();
            searchOtherNumbers();
            if (m_outcome->objective() == SearchObjective::time && !m_stop.stop_requested()) {
                lookForMargins(took + (Clock::now() - numbersBegan));
            }
            listFound();
        }
    }

private:
    /// The status of a cycle of the grid in the list of found ones.
    struct Noted {
        FeasibleCycle cycle;
        FoundBy by = FoundBy::search;
        int candidate = 0; ///< among those tried on fresh phases
        FreshParts freshParts{};
        std::shared_ptr<const IntervalSummary> interval{};
        bool isAnswer = false, isBestOfItsNumber = false;
        bool isOtherSample = false; ///< it is fit in other scenarios than the answer
    };

    /// The results for the grid with the levels of a round.
    struct Round {
        Round(const Project& project, const std::stop_token& stop)
            : searched(project), variants(std::make_shared<Variants>(project, stop)) {}
        Project searched;
        std::shared_ptr<const Variants> variants;
        SearchedGrid grid{};
        std::vector<Noted> found{};
    };

    // --- the answer -----------------------------------------------------------------------------

    [[nodiscard]] SearchOptions optionsFor(int stages) {
        SearchOptions options;
        options.method = m_wish.method;
        options.threads = m_wish.threads;
        options.stop = m_stop;
        options.marginWithin_us = m_outcome->marginWithin_us;
        options.onProgress = [this, stages](const SearchProgress& progress) {
            if (progress.best && !m_robust && !m_outcome->wear) {
                note(*progress.best);
            }
            report({.stages = stages,
                    .best_s = progress.best ? std::optional(progress.best->time_s) : std::nullopt,
                    .share = progress.share,
                    .bound_s = progress.bound_s,
                    .evaluations = progress.evaluations});
        };
        return options;
    }

    [[nodiscard]] SearchedGrid searchGrid(const Project& project,
                                          const SearchOptions& options) const {
        SearchedGrid grid;
        if (m_outcome->wear) {
            grid.interval = searchInterval(project, *m_outcome->wear, {.search = options});
            grid.search = grid.interval->search;
        } else if (m_robust) {
            grid.robust =
                optimiseRobustly(project, undecidedScenarios(project, m_stop),
                                 {.search = options, .known = {startingCycleInSteps(project)}});
            grid.search = grid.robust->search;
        } else {
            grid.search = optimise(project, options);
        }
        return grid;
    }

    void searchRound() {
        SearchOptions options = optionsFor(0);
        options.journal = m_wish.journal;
        m_now.grid = searchGrid(m_now.searched, options);
        if (m_now.grid.hasBest()) {
            Noted& answer = noteBest(m_now.grid, 0);
            answer.isAnswer = true;
        }
    }

    /// Continues while further levels may improve the answer.
    void searchLevels() {
        searchRound();
        const auto isStopped = [this] { return m_now.grid.search.status == SearchStatus::stopped; };
        while (m_now.grid.hasBest() && !isStopped()
               && m_levels.beginNextRound(m_now.grid.search.cycle, *m_now.grid.search.best)) {
            m_best_s = best_s();
            Round before = std::exchange(m_now, Round(m_levels.searched(), m_stop));
            searchRound();
            if (isStopped()) {
                m_now = std::move(before); // keeps its answer
                m_outcome->areLevelsCutShort = true;
                break;
            }
            m_outcome->rounds = m_levels.round();
        }
        m_outcome->searched = m_now.searched;
        m_outcome->search = m_now.grid.search;
        m_outcome->robust = m_now.grid.robust;
        m_outcome->interval = m_now.grid.interval;
        if (m_now.grid.hasBest()) {
            m_outcome->edges = edgesReached(m_now.searched, m_outcome->search.cycle);
            m_outcome->settingEdges = settingEdgesReached(m_now.searched, m_outcome->search.cycle,
                                                          m_outcome->search.machine);
            // Counts stages as the search lists them: without the spark-out.
            addNumber(static_cast<int>(
                          std::ranges::count_if(m_outcome->search.cycle.stages, &Stage::feeds)),
                      m_now.grid);
        }
    }

    /// A cycle is noted once.
    Noted& note(const FeasibleCycle& cycle) {
        const auto known = std::ranges::find_if(m_now.found, [&cycle](const Noted& each) {
            return each.cycle.variant == cycle.variant && each.cycle.cycle == cycle.cycle;
        });
        return known == m_now.found.end() ? m_now.found.emplace_back(Noted{.cycle = cycle})
                                          : *known;
    }

    Noted& noteBest(const SearchedGrid& grid, int candidatesBefore) {
        Noted& best = note(*grid.search.best);
        best.cycle = *grid.search.best;
        best.isBestOfItsNumber = true;
        if (grid.robust && grid.robust->candidate > 0) {
            best.candidate = candidatesBefore + grid.robust->candidate;
            best.freshParts = grid.robust->freshParts;
        }
        if (grid.interval) {
            best.interval = std::make_shared<const IntervalSummary>(*grid.interval);
        }
        return best;
    }

    [[nodiscard]] const std::vector<Project>& scenariosAdded() const {
        static const std::vector<Project> none;
        return m_outcome->robust     ? m_outcome->robust->added
               : m_outcome->interval ? m_outcome->interval->parts
                                     : none;
    }

    /// Computes the results for the answer, and for the given cycle.
    void weigh() {
        {
            const GraceStop grace(m_stop);
            m_outcome->limit = steplessLimitBounds(m_now.searched, grace.token());
            SearchSummary& found = m_outcome->search;
            if (m_outcome->stopped() || isHeuristic(m_wish.method) || m_outcome->marginWithin_us) {
                found.bound_s = std::max(found.bound_s, m_outcome->limit.time_s);
            }
            if (found.best && m_outcome->marginWithin_us) {
                m_outcome->binding = leastMarginRequirements(withBest(m_now.searched, found),
                                                             m_robust, grace.token());
            } else if (found.best) {
                m_outcome->binding = bindingRequirements(m_now.searched, *found.best,
                                                         scenariosAdded(), grace.token());
            }
        }
        const GraceStop grace(m_stop);
        m_outcome->given = givenCycle(m_outcome->project, grace.token());
    }

    /// Where a margin is searched for, the binding requirements are those with the least one.
    void remarkNoMargin(const FoundCycle& answer, const std::stop_token& stop) {
        constexpr double least = 5e-4; // stated as 0.0 %
        if (m_outcome->marginWithin_us || m_outcome->wear || answer.leastRelativeMargin >= least) {
            return;
        }
        m_outcome->remarks.noMargin =
            requirementsBelowMargin(withFound(m_now.searched, answer), least, m_robust,
                                    scenariosAdded(), stop)
                .value_or(std::vector<ConstraintKind>());
    }

    /// Adds the remarks of a simulation of the answer.
    void remark() {
        const FoundCycle* const answer = m_outcome->answer();
        if (!answer) {
            return;
        }
        const GraceStop grace(m_stop);
        remarkNoMargin(*answer, grace.token());
        const SimulationResult result =
            simulateUnchecked(withFound(m_outcome->project, *answer), nullptr, grace.token());
        if (result.status != RunStatus::completed) {
            return;
        }
        m_outcome->remarks.notDecided = undecided(result.project, evaluateConstraints(result));
        m_outcome->remarks.issues = remarksOn(result);
        const ShopNumbers shop = shopNumbers(result);
        if (shop.ratioNearInteger()) {
            m_outcome->remarks.ratioNearInteger = shop.rotationRatio;
        }
    }

    void refineBest() {
        report({.looksFor = FoundBy::refinement});
        const Project best = withBest(m_now.searched, m_outcome->search);
        std::optional<RobustTrail> trail;
        if (m_outcome->robust) {
            const RobustSummary& robust = *m_outcome->robust;
            trail = {robust.added, robust.candidates, robust.freshParts.isCapable};
        }
        m_outcome->refinement = refineAnswer({.asked = m_now.searched,
                                              .best = best,
                                              .cycle = m_outcome->search.cycle,
                                              .robust = std::move(trail)},
                                             m_stop);
        if (m_outcome->refinement->isQuicker) {
            listFound();
            const GraceStop grace(m_stop);
            m_outcome->binding = bindingRequirements(best, m_outcome->refinement->cycle,
                                                     m_outcome->refinement->time_us,
                                                     scenariosAdded(), grace.token());
        }
    }

    // --- beyond the answer ----------------------------------------------------------------------

    /// Shows the results before the search for the front.
    void showAnswer() {
        if (m_events.answer) {
            auto answer = std::make_shared<SearchOutcome>(*m_outcome);
            answer->isFrontComing = true;
            m_events.answer(answer);
        }
    }

    void addNumber(int stages, const SearchedGrid& grid) {
        SearchedNumber number{
            .stages = stages, .status = grid.search.status, .bound_s = grid.search.bound_s};
        if (grid.hasBest()) {
            number.best_s = grid.search.best->time_s;
        }
        m_outcome->numbers.push_back(number);
    }

    /// Searches the numbers of stages other than the answer's.
    void searchOtherNumbers() {
        std::vector<SearchedNumber> answered = std::exchange(m_outcome->numbers, {});
        int candidates = m_outcome->robust ? m_outcome->robust->candidates : 0;
        const bool isSampled =
            !canDecidePhases(m_outcome->project)
            || m_outcome->project.optimisation->scenarios == OptimisationScenarios::batch;
        for (const double each : m_now.searched.optimisation->stages) {
            const int stages = static_cast<int>(each);
            if (stages == answered.front().stages) {
                m_outcome->numbers.push_back(answered.front());
                continue;
            }
            Project project = m_now.searched;
            project.optimisation->stages = {each};
            if (m_stop.stop_requested() || Variants(project, m_stop).fault() != GridFault::none) {
                continue; // otherwise the stock cannot be divided into this many stages
            }
            SearchOptions options = optionsFor(stages);
            if (options.method == SearchMethod::full) {
                options.method = SearchMethod::pruned; // it proves the same sooner
            }
            const SearchedGrid grid = searchGrid(project, options);
            if (grid.hasBest()) {
                noteBest(grid, candidates).isOtherSample = m_robust && isSampled;
            }
            candidates += grid.robust ? grid.robust->candidates : 0;
            addNumber(stages, grid);
        }
    }

    /// Searches time against margin, for about as long as the first search took.
    void lookForMargins(Clock::duration took) {
        constexpr std::size_t most = 40;
        constexpr std::chrono::seconds grace(2);
        const DeadlineStop deadline(m_stop, took + grace);
        SearchOptions options;
        options.stop = deadline.token();
        report({.looksFor = FoundBy::margin});
        options.onProgress = [this](const SearchProgress& progress) {
            report({.looksFor = FoundBy::margin, .evaluations = progress.evaluations});
        };
        const TradeOff front = frontOf(options, most);
        for (const SearchSummary& each : front.cycles) {
            const std::size_t before = m_now.found.size();
            Noted& noted = note(*each.best);
            noted.by = FoundBy::margin;
            noted.cycle.leastRelativeMargin = each.best->leastRelativeMargin;
            noted.isOtherSample = noted.isOtherSample || (m_robust && m_now.found.size() > before);
        }
        m_outcome->isFrontWhole = front.isComplete;
    }

    [[nodiscard]] TradeOff frontOf(const SearchOptions& options, std::size_t most) const {
        if (m_robust) {
            return tradeOffRobustly(
                m_now.searched, undecidedScenarios(m_now.searched, options.stop), options, most);
        }
        const SearchSummary from =
            m_outcome->marginWithin_us ? optimise(m_now.searched, options) : m_outcome->search;
        return from.best && from.status == SearchStatus::proved
                   ? tradeOff(m_now.searched, from, options, most)
                   : TradeOff{};
    }

    // --- reporting
    // --------------------------------------------------------------------------------

    [[nodiscard]] std::optional<double> best_s() const {
        std::optional<double> least_s = m_best_s;
        for (const Noted& each : m_now.found) {
            least_s = std::min(least_s.value_or(each.cycle.time_s), each.cycle.time_s);
        }
        return least_s;
    }

    void report(SearchState state) const {
        if (m_events.note) {
            state.round = m_levels.round();
            const std::optional<double> found_s = best_s();
            if (found_s && (!state.best_s || *found_s < *state.best_s)) {
                state.best_s = found_s;
            }
            m_events.note(state);
        }
    }

    /// Whether it takes no longer than the answer may; others belong only to the front.
    [[nodiscard]] bool mayAnswer(const Noted& each) const {
        return !each.isOtherSample
               && (!m_outcome->marginWithin_us
                   || each.cycle.time_us <= *m_outcome->marginWithin_us);
    }

    [[nodiscard]] bool isBefore(const Noted& a, const Noted& b) const {
        if (a.isAnswer != b.isAnswer || mayAnswer(a) != mayAnswer(b)) {
            return a.isAnswer || (!b.isAnswer && mayAnswer(a));
        }
        const auto value = [this](const Noted& each) {
            return each.interval ? each.interval->value(m_outcome->objective()) : 0.0;
        };
        return value(a) != value(b)
                   ? value(a) < value(b)
                   : isBetter(a.cycle, b.cycle, m_now.variants->grid(a.cycle.variant),
                              mayAnswer(a) ? m_outcome->aim() : SearchAim::leastTime);
    }

    /// The cycles found, the best first.
    void listFound() {
        m_outcome->found.clear();
        std::ranges::sort(m_now.found,
                          [this](const Noted& a, const Noted& b) { return isBefore(a, b); });
        for (const Noted& noted : m_now.found) {
            const FeasibleCycle& each = noted.cycle;
            const IntervalSummary* const interval = noted.interval.get();
            m_outcome->found.push_back(
                {.by = noted.by,
                 .cycle = m_now.variants->grid(each.variant).cycle(each.cycle),
                 .machine = machineSettings(m_now.variants->project(each.variant)),
                 .time_s = each.time_s,
                 .leastRelativeMargin = each.leastRelativeMargin,
                 .isBest = noted.isAnswer,
                 .isBestOfItsNumber = noted.isBestOfItsNumber,
                 .candidate = noted.candidate,
                 .freshParts = noted.freshParts,
                 .held = interval ? interval->held : std::nullopt,
                 .cost = interval ? interval->cost : std::nullopt});
        }
        if (m_outcome->refinement && m_outcome->refinement->isQuicker) {
            const RefineSummary& refined = *m_outcome->refinement;
            m_outcome->found.insert(m_outcome->found.begin(),
                                    {.by = FoundBy::refinement,
                                     .cycle = refined.cycle,
                                     .machine = m_outcome->search.machine,
                                     .time_s = refined.time_s,
                                     .leastRelativeMargin = refined.leastRelativeMargin,
                                     .candidate = refined.candidate,
                                     .freshParts = refined.freshParts});
        }
        for (FoundCycle& found : m_outcome->found) {
            const bool isDecided = found.isBest || found.by == FoundBy::refinement
                                       ? m_outcome->robust && m_outcome->robust->decided
                                       : m_robust
                                             && (found.candidate > 0 || found.by == FoundBy::margin)
                                             && canDecidePhases(m_outcome->project);
            if (isDecided) {
                found.decided = phaseCases(withFound(m_outcome->project, found));
            }
        }
    }

    std::shared_ptr<SearchOutcome> m_outcome;
    const SearchWish& m_wish;
    SearchLevels m_levels;
    Round m_now;
    bool m_robust;
    std::optional<double> m_best_s; ///< best time of the earlier rounds
    std::stop_token m_stop;
    SearchEvents m_events;
};

} // namespace

bool isResumable(const Project& project, SearchMethod method) {
    return method == SearchMethod::full && objectiveOf(project) == SearchObjective::time;
}

std::optional<SurfaceWear> searchWear(const Setup& setup, std::size_t surface) {
    return setup.wear.isGiven() ? std::optional(SurfaceWear(setup, surface)) : std::nullopt;
}

Project withFound(Project project, const FoundCycle& found) {
    setMachine(project, found.machine);
    *project.cycle = found.cycle;
    return project;
}

std::vector<const FoundCycle*> SearchOutcome::front() const {
    std::vector<const FoundCycle*> points;
    for (const FoundCycle& each : found) {
        if (each.by == FoundBy::margin) {
            points.push_back(&each);
        }
    }
    std::ranges::sort(points, {}, &FoundCycle::time_s);
    return points;
}

const FoundCycle* SearchOutcome::best() const {
    const auto at = std::ranges::find(found, true, &FoundCycle::isBest);
    return at == found.end() ? nullptr : &*at;
}

const FoundCycle* SearchOutcome::refined() const {
    const bool quicker = !found.empty() && found.front().by == FoundBy::refinement;
    return quicker ? &found.front() : nullptr;
}

const FoundCycle* SearchOutcome::answer() const {
    return refined() ? refined() : best();
}

bool SearchOutcome::unresolved() const {
    return search.best && robust && !robust->holdsInSample;
}

std::optional<double> SearchOutcome::mostStocksFailing() const {
    return robust && answer() && !answer()->decided
               ? std::optional(mostFailing(freshPhaseCount, std::max(answer()->candidate, 1)))
               : std::nullopt;
}

bool SearchOutcome::isByPpk() const {
    return robust && best() && robust->incapable > 0 && best()->freshParts.isCapable;
}

std::optional<double> SearchOutcome::mostPartsBad() const {
    return answer() && answer()->freshParts.tried > 0 ? std::optional(
               mostFailing(answer()->freshParts.tried, std::max(answer()->candidate, 1)))
                                                      : std::nullopt;
}

std::vector<std::pair<ConstraintKind, long long>> SearchOutcome::cuts() const {
    std::vector<std::pair<ConstraintKind, long long>> cuts;
    for (const Requirement& row : requirementRows) {
        if (const long long count = search.cuts[static_cast<std::size_t>(row.kind)]) {
            cuts.emplace_back(row.kind, count);
        }
    }
    std::ranges::stable_sort(cuts, std::greater(), [](const auto& cut) { return cut.second; });
    return cuts;
}

long long SearchOutcome::evaluations() const {
    return robust ? robust->evaluations : search.evaluations;
}

long long SearchOutcome::visits() const {
    return robust ? robust->visits : search.visits;
}

SearchOutcomePtr search(const Project& project, const SearchWish& wish, std::stop_token stop,
                        SearchEvents events) {
    std::shared_ptr<SearchOutcome> outcome = checked(project, wish, stop);
    if (outcome->ran()) {
        Search(outcome, wish, std::move(stop), std::move(events)).run();
    }
    return outcome;
}

} // namespace sparkout
