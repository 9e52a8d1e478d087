// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/whole_search.h"

#include "core/batch/batch_check.h"
#include "core/deadline_stop.h"
#include "core/grace_stop.h"
#include "core/optimisation/binding.h"
#include "core/optimisation/judge.h"
#include "core/optimisation/robust.h"
#include "core/optimisation/trade_off.h"
#include "core/optimisation/variants.h"
#include "core/project/optimisation.h"
#include "core/project/validate.h"
#include "core/study/refine_answer.h"
#include "core/study/search_levels.h"

#include <algorithm>
#include <chrono>
#include <cstddef>
#include <functional>
#include <iterator>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

/// Searches number of stages by number, and gathers what it comes upon.
class Search {
public:
    using Clock = std::chrono::steady_clock;
    using Note = std::function<void(const SearchState&)>;
    using Answer = std::function<void(const SearchOutcomePtr&)>;

    Search(const Project& project, const SearchWish& wish, std::stop_token stop, Note note,
           Answer answer)
        : m_outcome(std::make_shared<SearchOutcome>())
        , m_levels(project)
        , m_now(project, stop)
        , m_within_us(marginWithinOf(project))
        , m_objective(objectiveOf(project))
        , m_refine(wish.refine && !m_within_us && m_objective == SearchObjective::time)
        , m_stop(std::move(stop))
        , m_note(std::move(note))
        , m_answer(std::move(answer)) {
        m_outcome->project = project;
        m_outcome->marginWithin_us = m_within_us;
        m_outcome->fault = m_now.variants->fault();
        if (m_outcome->fault == GridFault::none) {
            const bool asked = project.optimisation->scenarios != OptimisationScenarios::nominal;
            m_outcome->robust = wish.phases || asked;
            if (asked) {
                m_outcome->batchIssues = checkBatch(project);
            }
            m_outcome->objectiveFault = objectiveFault(project, wish.phases);
        }
        if (m_outcome->ran() && m_objective != SearchObjective::time) {
            m_outcome->wear = wearOf(project, wish);
        }
    }

    SearchOutcomePtr run() {
        m_began = Clock::now();
        if (m_outcome->ran()) {
            searchNumbers();
            while (goOn()) {
            }
            takeRound();
            const bool mayLook =
                !m_outcome->stopped && !m_now.found.empty() && m_objective == SearchObjective::time;
            listFound();
            finish();
            if (mayLook) {
                showAnswer();
                lookForMargins();
                listFound();
            }
            if (m_refine && m_outcome->best()) {
                m_outcome->refines = true;
                refineBest();
            }
        }
        return m_outcome;
    }

private:
    struct Noted {
        FeasibleCycle cycle;
        FoundBy by = FoundBy::search;
        int candidate = 0; ///< on fresh phases
        std::shared_ptr<const IntervalSummary> interval{};
        bool isOfFront = false; ///< alone: of another sample of the scenarios than the answer
        double margin = 0;      ///< that it is compared by: equal ones are made the same
    };

    /// Of the surface; without a set-up the wheel does not wear.
    static SurfaceWear wearOf(const Project& project, const SearchWish& wish) {
        return wish.setup && wish.setup->wear.isGiven() ? SurfaceWear(*wish.setup, wish.surface)
                                                        : SurfaceWear(project);
    }

    /// What it is compared by before anything else.
    [[nodiscard]] double valueOf(const Noted& each) const {
        return each.interval ? each.interval->value(m_objective) : 0;
    }

    [[nodiscard]] bool isBefore(const Noted& a, const Noted& b, SearchAim aim) const {
        FeasibleCycle left = a.cycle, right = b.cycle;
        if (aim == SearchAim::greatestMargin) {
            left.leastRelativeMargin = a.margin;
            right.leastRelativeMargin = b.margin;
        }
        return valueOf(a) != valueOf(b) ? valueOf(a) < valueOf(b)
                                        : isBetter(left, right, gridOf(a), aim);
    }

    /// Each margin becomes the greatest of those not yet met that it is equal to, from the greatest
    /// of all on.
    void compareMargins() {
        std::vector<Noted*> all;
        for (Noted& each : m_now.found) {
            if (mayAnswer(each)) {
                all.push_back(&each);
            }
        }
        std::ranges::sort(all, std::ranges::greater{},
                          [](const Noted* each) { return each->cycle.leastRelativeMargin; });
        double greatest = std::numeric_limits<double>::infinity();
        for (Noted* each : all) {
            const double own = each->cycle.leastRelativeMargin;
            greatest = own < greatest - equalMargins ? own : greatest;
            each->margin = greatest;
        }
    }

    /// What is known of the grid with the levels of a round.
    struct Round {
        Round(const Project& project, const std::stop_token& stop)
            : searched(project), variants(std::make_shared<Variants>(project, stop)) {}
        Project searched;
        std::shared_ptr<const Variants> variants;
        std::vector<SearchedNumber> numbers;
        std::vector<Noted> found;
        std::vector<Project> scenarios; ///< that robust searches added
        int candidates = 0;             ///< tried on fresh phases
    };

    void searchNumbers() {
        for (const double stages : m_now.searched.optimisation->stages) {
            if (m_stop.stop_requested()) {
                m_outcome->stopped = true;
                return;
            }
            searchNumber(static_cast<int>(stages));
        }
    }

    /// Whether a grid with further levels was searched to its end.
    bool goOn() {
        const Noted* const best = first();
        if (m_outcome->stopped || !best) {
            return false;
        }
        const Cycle cycle = gridOf(*best).cycle(best->cycle.cycle);
        if (!m_levels.goOn(cycle, best->cycle)) {
            return false;
        }
        Round before = std::exchange(m_now, Round(m_levels.searched(), m_stop));
        m_best_s = best_s(before.found);
        searchNumbers();
        if (m_outcome->stopped) {
            m_now = std::move(before); // its answer stands
            m_outcome->stopped = false;
            m_outcome->areLevelsCutShort = true;
            return false;
        }
        m_outcome->rounds = m_levels.round();
        return true;
    }

    void takeRound() {
        m_outcome->searched = m_now.searched;
        m_outcome->numbers = m_now.numbers;
        if (const Noted* const best = first()) {
            m_outcome->edges = edgesReached(m_now.searched, gridOf(*best).cycle(best->cycle.cycle));
        }
    }

    [[nodiscard]] const Grid& gridOf(const Noted& each) const {
        return m_now.variants->grid(each.cycle.variant);
    }

    /// Null: nothing was found.
    [[nodiscard]] const Noted* first() {
        compareMargins();
        const auto best =
            std::ranges::min_element(m_now.found, [this](const Noted& a, const Noted& b) {
                return isBefore(a, b, m_outcome->aim());
            });
        return best == m_now.found.end() ? nullptr : &*best;
    }

    /// Whether it takes no longer than the answer may; others are of the front alone.
    [[nodiscard]] bool mayAnswer(const Noted& each) const {
        return !each.isOfFront && (!m_within_us || each.cycle.time_us <= *m_within_us);
    }

    [[nodiscard]] static std::optional<double> best_s(const std::vector<Noted>& found) {
        std::optional<double> least_s;
        for (const Noted& each : found) {
            least_s = std::min(least_s.value_or(each.cycle.time_s), each.cycle.time_s);
        }
        return least_s;
    }

    void searchNumber(int stages) {
        Project project = m_now.searched;
        project.optimisation->stages = {static_cast<double>(stages)};
        if (Variants(project, m_stop).fault() != GridFault::none) {
            return; // the stock cannot be divided so often
        }
        SearchOptions options;
        options.stop = m_stop;
        options.marginWithin_us = m_within_us;
        options.onProgress = [this, stages](const SearchProgress& progress) {
            if (progress.best && !m_outcome->robust && !m_outcome->wear) {
                addFound(*progress.best);
            }
            report(stages, progress.bound_s, progress.evaluations, FoundBy::search, progress.share);
        };
        SearchedNumber number{.stages = stages};
        int candidate = 0;
        std::shared_ptr<IntervalSummary> interval;
        if (m_outcome->wear) {
            interval = std::make_shared<IntervalSummary>(
                searchInterval(project, *m_outcome->wear, {.search = options}));
            number.search = interval->search;
        } else if (m_outcome->robust) {
            RobustSummary robust =
                optimiseRobustly(project, undecidedScenarios(project, m_stop), {.search = options});
            candidate = m_now.candidates + robust.candidate;
            m_now.candidates += robust.candidates;
            number.scenariosAdded = static_cast<int>(robust.added.size());
            number.holds = robust.holdsInSample;
            number.nominalTime_s = robust.nominalTime_s;
            std::ranges::move(robust.added, std::back_inserter(m_now.scenarios));
            number.search = std::move(robust.search);
        } else {
            number.search = optimise(project, options);
        }
        if (number.search.status == SearchStatus::stopped) {
            m_outcome->stopped = true;
        }
        if (number.search.best && number.holds) {
            addFound(*number.search.best, FoundBy::search, candidate);
            m_now.found.back().interval = std::move(interval);
        }
        m_now.numbers.push_back(std::move(number));
    }

    /// A cycle is noted once.
    void addFound(const FeasibleCycle& cycle, FoundBy by = FoundBy::search, int candidate = 0) {
        const auto known = std::ranges::find_if(m_now.found, [&cycle](const Noted& each) {
            return each.cycle.variant == cycle.variant && each.cycle.cycle == cycle.cycle;
        });
        if (known == m_now.found.end()) {
            m_now.found.push_back({cycle, by, candidate});
        } else if (by == FoundBy::margin) {
            known->by = by;
            known->cycle.leastRelativeMargin = cycle.leastRelativeMargin;
        }
    }

    void report(int stages, double bound_s, long long evaluations,
                FoundBy looksFor = FoundBy::search, double share = 0) const {
        SearchState state{.looksFor = looksFor,
                          .stages = stages,
                          .round = m_levels.round(),
                          .best_s = best_s(m_now.found),
                          .share = share,
                          .bound_s = bound_s,
                          .evaluations = evaluations};
        if (m_best_s && (!state.best_s || *m_best_s < *state.best_s)) {
            state.best_s = m_best_s;
        }
        m_note(state);
    }

    /// Of the searches for the least time; nothing: none has a best.
    [[nodiscard]] std::optional<SearchSummary> quickest() const {
        const SearchSummary* quickest = nullptr;
        for (const SearchedNumber& number : m_now.numbers) {
            if (number.search.best
                && (!quickest
                    || isBetter(*number.search.best, *quickest->best,
                                m_now.variants->grid(number.search.best->variant)))) {
                quickest = &number.search;
            }
        }
        return quickest ? std::optional(*quickest) : std::nullopt;
    }

    /// What stands before margins by time are looked for.
    void showAnswer() {
        if (m_answer) {
            auto answer = std::make_shared<SearchOutcome>(*m_outcome);
            answer->isFrontComing = true;
            m_answer(answer);
        }
    }

    /// Time against margin, about as long as the search took.
    void lookForMargins() {
        constexpr std::size_t most = 40;
        constexpr std::chrono::seconds grace(2);
        const DeadlineStop deadline(m_stop, Clock::now() - m_began + grace);
        SearchOptions options;
        options.stop = deadline.token();
        report(0, 0, 0, FoundBy::margin);
        options.onProgress = [this](const SearchProgress& progress) {
            report(0, 0, progress.evaluations, FoundBy::margin);
        };
        const TradeOff front = frontOf(options, most);
        for (const SearchSummary& each : front.cycles) {
            const std::size_t before = m_now.found.size();
            addFound(*each.best, FoundBy::margin);
            if (m_now.found.size() > before) {
                m_now.found.back().isOfFront = m_outcome->robust;
            }
        }
        m_outcome->isFrontWhole = front.isWhole;
    }

    [[nodiscard]] TradeOff frontOf(const SearchOptions& options, std::size_t most) const {
        if (m_outcome->robust) {
            return tradeOffRobustly(
                m_now.searched, undecidedScenarios(m_now.searched, options.stop), options, most);
        }
        const std::optional<SearchSummary> from =
            m_within_us ? optimise(m_now.searched, options) : quickest();
        return from && from->best && from->status == SearchStatus::proved
                   ? tradeOff(m_now.searched, *from, options, most)
                   : TradeOff{};
    }

    /// From the best of the grid, as it stands in the outcome.
    void refineBest() {
        report(0, 0, 0, FoundBy::refinement);
        const FoundCycle best = *m_outcome->best();
        Project project = m_now.searched;
        setMachine(project, best.machine);
        const RefineSummary refined = refineAnswer(
            {.asked = m_now.searched,
             .best = project,
             .cycle = best.cycle,
             .robust = m_outcome->robust
                           ? std::optional(RobustTrail{m_now.scenarios, m_now.candidates})
                           : std::nullopt},
            m_stop);
        if (refined.isQuicker) {
            m_outcome->found.insert(m_outcome->found.begin(),
                                    {.by = FoundBy::refinement,
                                     .cycle = refined.cycle,
                                     .machine = best.machine,
                                     .time_s = refined.time_s,
                                     .leastRelativeMargin = refined.leastRelativeMargin,
                                     .candidate = refined.candidate});
            const GraceStop grace(m_stop);
            m_outcome->binding = bindingRequirements(project, refined.cycle, refined.time_us,
                                                     m_now.scenarios, grace.token());
        }
    }

    /// The cycles found, the best first.
    void listFound() {
        m_outcome->found.clear();
        compareMargins();
        std::ranges::sort(m_now.found, [this](const Noted& a, const Noted& b) {
            if (mayAnswer(a) != mayAnswer(b)) {
                return mayAnswer(a);
            }
            return isBefore(a, b, mayAnswer(a) ? m_outcome->aim() : SearchAim::leastTime);
        });
        std::vector<std::size_t> numbers; // of stages, met already
        for (const Noted& noted : m_now.found) {
            const FeasibleCycle& each = noted.cycle;
            const IntervalSummary* const interval = noted.interval.get();
            const bool first =
                mayAnswer(noted) && std::ranges::find(numbers, each.cycle.size()) == numbers.end();
            m_outcome->found.push_back(
                {.by = noted.by,
                 .cycle = m_now.variants->grid(each.variant).cycle(each.cycle),
                 .machine = machineSettings(m_now.variants->project(each.variant)),
                 .time_s = each.time_s,
                 .leastRelativeMargin = each.leastRelativeMargin,
                 .isBest = first && numbers.empty(),
                 .isBestOfItsNumber = first,
                 .candidate = noted.candidate,
                 .held = interval ? interval->held : std::nullopt,
                 .cost = interval ? interval->cost : std::nullopt});
            if (first) {
                numbers.push_back(each.cycle.size());
            }
        }
        for (FoundCycle& found : m_outcome->found) {
            const bool isHeldByAll = found.candidate > 0 || found.by == FoundBy::margin;
            if (m_outcome->robust && isHeldByAll && canDecidePhases(m_outcome->project)) {
                found.decided = phaseCases(withFound(m_outcome->project, found));
            }
        }
    }

    /// What is to be known of the answer.
    void finish() {
        const GraceStop grace(m_stop); // for both
        const SteplessLimit limit = steplessLimitBounds(m_now.searched, grace.token());
        m_outcome->limit_s = limit.time_s;
        m_outcome->limitCycles = limit.cycles;
        m_outcome->bound_s = bound();
        if (!m_now.found.empty() && m_within_us) {
            m_outcome->binding =
                leastMarginRequirements(withFound(m_now.searched, m_outcome->found.front()),
                                        m_outcome->robust, grace.token());
        } else if (!m_now.found.empty()) {
            const Noted& best = m_now.found.front();
            m_outcome->binding = bindingRequirements(
                m_now.searched, best.cycle, best.interval ? best.interval->parts : m_now.scenarios,
                grace.token());
        }
    }

    /// Of the whole grid: the least of those of the numbers of stages, if all were searched.
    [[nodiscard]] double bound() const {
        if (m_outcome->numbers.empty()
            || m_outcome->numbers.size() < m_now.searched.optimisation->stages.size()) {
            return m_outcome->limit_s;
        }
        double least = std::numeric_limits<double>::infinity();
        for (const SearchedNumber& number : m_outcome->numbers) {
            const bool none = number.search.status == SearchStatus::infeasible;
            least = none ? least : std::min(least, number.search.bound_s);
        }
        return std::max(least, m_outcome->limit_s);
    }

    std::shared_ptr<SearchOutcome> m_outcome;
    SearchLevels m_levels;
    Round m_now;
    std::optional<double> m_best_s; ///< of the rounds before
    std::optional<std::int64_t> m_within_us;
    SearchObjective m_objective;
    bool m_refine;
    Clock::time_point m_began;
    std::stop_token m_stop;
    Note m_note;
    Answer m_answer;
};

} // namespace

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
    const auto ofTheGrid = [](const FoundCycle& each) { return each.by != FoundBy::refinement; };
    const auto at = std::ranges::find_if(found, ofTheGrid);
    return at == found.end() ? nullptr : &*at;
}

const FoundCycle* SearchOutcome::refined() const {
    const bool given = !found.empty() && found.front().by == FoundBy::refinement;
    return given ? &found.front() : nullptr;
}

std::array<long long, constraintKinds> SearchOutcome::cuts() const {
    std::array<long long, constraintKinds> sum{};
    for (const SearchedNumber& number : numbers) {
        for (std::size_t kind = 0; kind < sum.size(); ++kind) {
            sum[kind] += number.search.cuts[kind];
        }
    }
    return sum;
}

bool SearchOutcome::unresolved() const {
    return std::ranges::any_of(numbers, [this](const SearchedNumber& number) {
        return !number.holds && number.search.best
               && (!best() || number.search.best->time_s < best()->time_s);
    });
}

double SearchOutcome::nominal_s() const {
    double least_s = 0;
    for (const SearchedNumber& number : numbers) {
        if (number.nominalTime_s > 0 && (least_s == 0 || number.nominalTime_s < least_s)) {
            least_s = number.nominalTime_s;
        }
    }
    return least_s;
}

SearchOutcomePtr runWholeSearch(const Project& project, const SearchWish& wish,
                                std::stop_token stop, std::function<void(const SearchState&)> note,
                                std::function<void(const SearchOutcomePtr&)> answer) {
    Issues issues = validate(project);
    std::erase_if(issues, [](const Issue& issue) { return issue.severity != Severity::error; });
    if (!issues.empty()) {
        auto outcome = std::make_shared<SearchOutcome>();
        outcome->project = project;
        outcome->issues = std::move(issues);
        return outcome;
    }
    return Search(
               project, wish, std::move(stop), note ? std::move(note) : [](const SearchState&) {},
               std::move(answer))
        .run();
}

Project withFound(Project project, const FoundCycle& found) {
    setMachine(project, found.machine);
    *project.cycle = found.cycle;
    return project;
}

} // namespace sparkout
