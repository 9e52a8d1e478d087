// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/pruned_search.h"

#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/quality/ranges.h"
#include "core/search/judge.h"
#include "core/search/stage_runs.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

/// A prefix and the settings of its next stage. Where memory is short its steps are dropped, and
/// repeated when it is extended.
struct Prefix {
    CyclePrefix done;
    int merged = 0;     ///< further ends of its last stage on the same step
    double least_s = 0; ///< bound of all its extensions
    std::vector<std::pair<double, std::size_t>> next; ///< bound [s] and setting, by bound
    [[nodiscard]] bool keepsSteps() const { return done.steps != nullptr; }
};
using PrefixPtr = std::shared_ptr<Prefix>;

struct Branch {
    static constexpr std::size_t closed = SIZE_MAX;
    double bound_s = 0;
    long long order = 0; ///< among equal bounds the newest first: deeper
    PrefixPtr prefix{};
    std::size_t index = closed;   ///< in the prefix's next settings; closed: these are to be found
    std::size_t setting = closed; ///< that one; closed: the first of them
    friend bool operator<(const Branch& a, const Branch& b) {
        return a.bound_s != b.bound_s ? a.bound_s > b.bound_s : a.order < b.order;
    }
};

/// The requirement that the overlap of a setting breaks in a stage before the last, and in the
/// last.
struct TooWide {
    std::optional<ConstraintKind> before, last;
};

/// The least relative margin of any cycle to its machine's ranges with this setting.
double rangeMargin(const Project& project, const StageSetting& setting) {
    double least = std::numeric_limits<double>::infinity();
    for (const StageFeed* feed : project.operation->searchedFeeds()) {
        const auto& range = project.machine->limits.*feed->range;
        const double value = feed == project.operation->axial()      ? setting.axialFeed_mm_min
                             : feed == project.operation->continuous ? setting.continuousFeed_mm_min
                                                                     : setting.radial;
        if (range && range->size() == 3 && (*range)[1] > (*range)[0] && value > 0) { // 0: not set
            least = std::min(least, std::min(value - (*range)[0], (*range)[1] - value)
                                        / ((*range)[1] - (*range)[0]));
        }
    }
    return least;
}

std::optional<ConstraintKind> tooWide(const Project& project, const StageSetting& setting,
                                      bool last) {
    if (!project.operation->axial()) {
        return std::nullopt;
    }
    const OverlapCheck check = checkOverlap(project, setting.axialFeed_mm_min, last);
    return check.holds() ? std::nullopt : std::optional(check.kind);
}

class PrunedSearch {
public:
    PrunedSearch(const Project& project, const Grid& grid, const SearchOptions& options)
        : m_grid(grid)
        , m_options(options)
        , m_judge(grid, options)
        , m_runner(project, grid, options.stop)
        , m_runs(project, grid, m_runner, StageRuns::Bounds::yes)
        , m_freeLast(!project.optimisation || !project.optimisation->last_stock_mm)
        , m_mayMerge(options.scenarios.empty() && !options.challenge && !options.wholeMargin
                     && !(project.optimisation && project.optimisation->stage_stock_mm))
        , m_leastSteps(project.least_steps.value_or(0))
        , m_mostSince(m_runs.canBoundLastStage() ? 8 : 0)
        , m_mostWithSteps(options.memory_bytes / 3 * 2 / wholeBytes(project, grid))
        , m_most(std::min(m_mostWithSteps + options.memory_bytes / 3 / leftOutBytes,
                          mostPerWhole * m_mostWithSteps)) {
        for (const StageSetting& setting : grid.settings()) {
            m_tooWide.push_back(
                {tooWide(project, setting, false), tooWide(project, setting, true)});
            m_rangeMargins.push_back(rangeMargin(project, setting));
        }
        demandMargin();
    }

    SearchSummary run() {
        begin();
        SearchSummary summary;
        for (auto branch = take(); branch; branch = take()) {
            challengeWaitingBefore(branch->bound_s);
            if (m_options.stop.stop_requested() || m_judge.isStale()) {
                break;
            }
            if (isSlower(branch->bound_s)) {
                continue;
            }
            if (branch->index == Branch::closed && !open(*branch)) {
                continue;
            }
            push(branch->prefix, branch->index + 1);
            explore(*branch->prefix, branch->setting, branch->bound_s);
            demandMargin();
            if (m_options.onProgress) {
                m_options.onProgress(progress());
            }
        }
        m_judge.challengeWaiting(std::numeric_limits<double>::infinity());
        if (m_options.stop.stop_requested() || m_judge.isStale()) {
            summary.status = SearchStatus::stopped;
        }
        summary.bound_s = std::min(m_least_s, m_judge.leastWaiting_s());
        summary.best = m_judge.best();
        if (summary.status != SearchStatus::stopped && summary.best) {
            summary.status = SearchStatus::proved;
            summary.bound_s = summary.best->time_s;
        }
        if (m_options.marginWithin_us) {
            summary.bound_s = 0; // quicker ones may be feasible with a smaller margin
        }
        summary.evaluations = m_judge.counts.evaluations;
        summary.visits = m_judge.counts.visits;
        summary.cuts = m_judge.counts.cuts;
        summary.added = m_judge.added();
        summary.addedCases = m_judge.addedCases();
        summary.isStale = m_judge.isStale();
        return summary;
    }

private:
    /// Approximate size of a branch whose prefix has neither steps nor settings.
    static constexpr std::size_t leftOutBytes = sizeof(Branch) + sizeof(Prefix) + 192;
    /// Beyond this ratio, most of the time would be spent on repeating steps.
    static constexpr std::size_t mostPerWhole = 5;
    static std::size_t wholeBytes(const Project& project, const Grid& grid) {
        return prefixBytes(project)
               + grid.settings().size() * sizeof(std::pair<double, std::size_t>);
    }

    [[nodiscard]] bool isSlower(double least_s) const {
        return std::floor(least_s * (1 - 1e-12) * 1e6 - 1)
               > static_cast<double>(m_judge.mostTime_us());
    }

    /// The search for a margin goes through the times up to the greatest.
    [[nodiscard]] SearchProgress progress() const {
        SearchProgress now{m_judge.best(), m_least_s, m_judge.counts.evaluations, 0};
        if (m_options.marginWithin_us) {
            const double most_s = seconds(*m_options.marginWithin_us);
            now.bound_s = 0;
            now.share = most_s > 0 ? std::clamp(m_least_s / most_s, 0.0, 1.0) : 0;
        }
        return now;
    }

    /// Only cycles that may still be better are run to their end.
    void demandMargin() {
        if (const double demanded = m_judge.demandedMargin(); demanded > m_demanded) {
            m_demanded = demanded;
            m_runner.demandMargin(demanded);
        }
    }

    /// Whether no cycle with the setting has the margin that is demanded.
    [[nodiscard]] bool isTooNear(std::size_t setting) const {
        constexpr double lastBits = 1e-9;
        return m_demanded > 0 && m_rangeMargins[setting] < m_demanded - lastBits;
    }

    /// A challenge is expensive, so cycles wait until no branch can be quicker, or until some work
    /// has been done, in which a better one is often found. The first waits are short, as a part
    /// added by a challenge refutes many later cycles. When there is no memory for more branches, a
    /// best cycle is needed to drop some.
    void challengeWaitingBefore(double bound_s) {
        constexpr long long mostPatience = 1 << 12; // branches: some challenges' worth of work
        const bool isFull = !m_newest.empty();
        if (isFull && m_options.challenge && !std::exchange(m_seeded, true)) {
            seed();
        }
        const bool isDue = ++m_waited >= m_patience;
        if (isDue) {
            m_waited = 0;
            m_patience = std::min(2 * m_patience, mostPatience);
        }
        m_judge.challengeWaiting(isFull || isDue ? std::numeric_limits<double>::infinity()
                                                 : bound_s);
    }

    void begin() {
        if (!m_options.challenge) {
            seed();
        }
        for (const std::size_t stages : m_grid.stageCounts()) {
            const auto steps = m_runner.begin(stages);
            Prefix root;
            root.done.stages = stages;
            root.done.keep(steps);
            Branch branch{.prefix = std::make_shared<Prefix>(std::move(root))};
            if (open(branch)) {
                push(std::move(branch));
            }
        }
    }

    void seed() {
        for (const std::size_t stages : m_grid.stageCounts()) {
            seed(stages);
        }
    }

    /// A first answer for pruning: the quickest feasible cycle with the same feeds in all stages.
    void seed(std::size_t stages) {
        std::vector<std::pair<double, std::size_t>> order;
        for (std::size_t s = 0; s < m_grid.settings().size(); ++s) {
            if (m_grid.settings()[s].sparkOut == 0 && !m_tooWide[s].before && !isTooNear(s)
                && (m_grid.sparkOut() > 0 || !m_tooWide[s].last)) {
                order.emplace_back(
                    m_runs.bound().rest_s(s, 0, m_grid.mostLast_mm(), m_grid.sparkOut() == 0), s);
            }
        }
        std::sort(order.begin(), order.end());
        for (const auto& [bound_s, setting] : order) {
            if (isSlower(bound_s) || m_options.stop.stop_requested() || m_judge.isStale()) {
                return;
            }
            const GridCycle cycle = m_grid.uniform(stages, setting);
            if (!cycle.empty() && m_judge.decide(cycle, m_runner)) {
                demandMargin();
                return;
            }
        }
    }

    /// The setting that, as the next one, would make the passes of a shorter cycle of the grid:
    /// point 5 of the header. Empty if there is none.
    [[nodiscard]] std::optional<std::size_t> shorterEquivalent(const CyclePrefix& prefix) const {
        const std::vector<std::size_t>& counts = m_grid.stageCounts();
        const auto own = std::find(counts.begin(), counts.end(), prefix.stages);
        const bool known = m_runs.isGauged() && !m_grid.hasStageBounds() && !prefix.cycle.empty()
                           && (m_freeLast || !prefix.isBeforeLast())
                           && std::find(counts.begin(), own, prefix.stages - 1) != own;
        return known ? std::optional(prefix.cycle.back().setting) : std::nullopt;
    }

    /// Finds the settings of a branch's next stage, from its first one on; those before the first
    /// of a reopened branch are done. Returns false if other branches come first, no setting is
    /// left or the search was stopped.
    bool open(Branch& branch) {
        Prefix& prefix = *branch.prefix;
        CyclePrefix& done = prefix.done;
        if (!prefix.keepsSteps() && !makeSteps(done)) {
            return false;
        }
        const bool isFirst = branch.setting == Branch::closed;
        const std::pair now(branch.bound_s, branch.setting);
        const int taken = m_runs.leastTaken(done);
        const auto cut = [&](ConstraintKind kind) {
            if (isFirst) {
                m_judge.cut(kind);
            }
        };
        findSettings(done, cut);
        findRefuted(prefix);
        prefix.next.reserve(m_settings.size() - m_refuted.size());
        auto refuted = m_refuted.begin();
        for (const std::size_t s : m_settings) {
            if (refuted != m_refuted.end() && *refuted == s) {
                ++refuted;
                cut(m_runner.cuts().tooDeep());
                continue;
            }
            const std::pair next(std::max(prefix.least_s, m_runs.bound_s(done, s, taken)), s);
            if (!isSlower(next.first) && (isFirst || next >= now)) {
                prefix.next.push_back(next);
            }
        }
        std::sort(prefix.next.begin(), prefix.next.end());
        if (prefix.next.empty() || prefix.next.front().first > branch.bound_s) {
            push(branch.prefix, 0);
            return false;
        }
        branch.index = 0;
        branch.setting = prefix.next.front().second;
        return true;
    }

    /// Repeats those steps of a prefix that were not kept. Returns false after a stop.
    bool makeSteps(CyclePrefix& done) {
        if (done.steps && done.since == 0) {
            return true;
        }
        const auto& from = done.steps ? done.steps : m_runner.begin(done.stages);
        const int count = done.steps ? done.since : done.stepCount();
        std::unique_ptr<CycleSteps> steps = from->copy();
        const bool isThere = m_runs.repeatSteps(done, *steps, count);
        m_judge.counts.visits += steps->run().visits() - from->run().visits();
        if (isThere) {
            done.keep(std::move(steps));
        }
        return isThere;
    }

    /// Finds the settings allowed for the next stage, without those that are cut.
    template <class Cut>
    void findSettings(const CyclePrefix& done, const Cut& cut) {
        const std::optional<std::size_t> shorter = shorterEquivalent(done);
        m_settings.clear();
        for (const std::size_t s : followers(done)) {
            if (s == shorter || isTooNear(s)) {
                continue;
            }
            if (const auto& broken =
                    done.isBeforeLast() ? m_tooWide[s].last : m_tooWide[s].before) {
                cut(*broken);
            } else {
                m_settings.push_back(s);
            }
        }
    }

    /// Settings that the grid allows for the next stage.
    const std::vector<std::size_t>& followers(const CyclePrefix& done) {
        const std::size_t before =
            done.cycle.empty() ? m_grid.settings().size() : done.cycle.back().setting;
        const auto [place, isNew] =
            m_followers.try_emplace({done.stages, done.cycle.size(), before});
        for (std::size_t s = 0; isNew && s < m_grid.settings().size(); ++s) {
            if (m_grid.mayExtend(done.cycle, done.stages, s)) {
                place->second.push_back(s);
            }
        }
        return place->second;
    }

    /// Finds the settings that are refuted as a last stage: point 4 of the header.
    void findRefuted(const Prefix& prefix) {
        const CyclePrefix& done = prefix.done;
        m_refuted.clear();
        if (done.isBeforeLast() && done.hasSteps()) {
            m_refuted = m_settings;
        }
        if (!m_refuted.empty() && !m_runs.isTooDeep(done)) {
            m_judge.keepRefuted(done.cycle, prefix.merged, m_refuted);
        }
    }

    // Each kept prefix has one branch. When there are too many with steps, those that will be
    // extended last lose their steps, which can be repeated. When there are too many branches the
    // newest is taken first, depth first, which keeps few; its bound is not below that of the
    // branch it came from.
    void push(const PrefixPtr& prefix, std::size_t index) {
        if (index < prefix->next.size() && !isSlower(prefix->next[index].first)) {
            const auto& [bound_s, setting] = prefix->next[index];
            push({bound_s, ++m_order, prefix, index, setting});
        }
    }

    void push(Branch branch) {
        if (m_isFirstTaken) {
            putFirst(std::move(branch));
        } else if (m_branches.size() < m_most) {
            m_branches.push_back(std::move(branch));
            std::push_heap(m_branches.begin(), m_branches.end());
        } else {
            m_newest.push_back(std::move(branch));
            return;
        }
        if (++m_withSteps > m_mostWithSteps) {
            leaveOut();
        }
    }

    /// Removes steps of the branches that are last in order, until half of the allowed number have
    /// steps.
    void leaveOut() {
        std::size_t from = m_branches.size();
        while (m_withSteps > m_mostWithSteps / 2 && from > 0) {
            const std::size_t half = from / 2;
            const auto begin = m_branches.begin();
            std::nth_element(begin, begin + static_cast<std::ptrdiff_t>(half),
                             begin + static_cast<std::ptrdiff_t>(from),
                             [](const Branch& a, const Branch& b) { return b < a; });
            for (std::size_t i = half; i < from; ++i) {
                Branch& branch = m_branches[i];
                if (branch.prefix->keepsSteps()) {
                    const Prefix& whole = *branch.prefix;
                    Prefix left{whole.done, whole.merged, whole.least_s, {}};
                    left.done.steps.reset();
                    branch.prefix = std::make_shared<Prefix>(std::move(left));
                    branch.index = Branch::closed;
                    --m_withSteps;
                }
            }
            from = half;
        }
        std::make_heap(m_branches.begin(), m_branches.end());
    }

    /// Replaces the first branch of the heap, which was taken: its successor is mostly the next
    /// setting of the same prefix, with a similar bound.
    void putFirst(Branch branch) {
        m_isFirstTaken = false;
        std::size_t at = 0;
        for (std::size_t child = 1; child < m_branches.size(); child = 2 * at + 1) {
            if (child + 1 < m_branches.size() && m_branches[child] < m_branches[child + 1]) {
                ++child;
            }
            if (!(branch < m_branches[child])) {
                break;
            }
            m_branches[at] = std::move(m_branches[child]);
            at = child;
        }
        m_branches[at] = std::move(branch);
    }

    std::optional<Branch> take() {
        if (std::exchange(m_isFirstTaken, false)) {
            std::pop_heap(m_branches.begin(), m_branches.end());
            m_branches.pop_back();
        }
        while (!m_newest.empty()) {
            Branch branch = std::move(m_newest.back());
            m_newest.pop_back();
            if (!isSlower(branch.bound_s)) {
                return branch;
            }
        }
        if (m_branches.empty() || isSlower(m_branches.front().bound_s)) {
            return std::nullopt;
        }
        m_isFirstTaken = true;
        m_least_s = std::max(m_least_s, m_branches.front().bound_s);
        m_withSteps -= m_branches.front().prefix->keepsSteps() ? 1 : 0;
        return std::move(m_branches.front());
    }

    void explore(Prefix& from, std::size_t setting, double least_s) {
        CyclePrefix& done = from.done;
        if (isTooNear(setting)) {
            return; // since a better one was found
        }
        if ((done.isBeforeLast() && isRefuted(done, setting, from.merged)) || !makeSteps(done)) {
            return;
        }
        std::shared_ptr<const CycleSteps> kept = done.steps; // for a stage that is run once
        int keptAt = 0;
        const bool single = !m_mayMerge && done.cycle.size() + 2 != done.stages;
        m_runs.run(
            done, setting,
            [&](const Run& run, int taken) {
                return m_options.stop.stop_requested()
                       || isSlower(m_runs.bound_s(done, run, setting, taken));
            },
            [&](const StageRuns::End& end) {
                if (done.isBeforeLast()) {
                    m_judge.decideDone(m_runs.after(done, setting, end, 0), end.steps, m_runner,
                                       from.merged);
                    return;
                }
                if (end.count < m_leastSteps) {
                    m_judge.cut(ConstraintKind::leastSteps);
                    return;
                }
                for (int taken = end.first; taken <= (single ? end.last : end.first); ++taken) {
                    const double bound_s =
                        std::max(least_s, m_runs.bound_s(done, end.steps.run(), setting, taken));
                    if (!isSlower(bound_s)) {
                        Prefix prefix{m_runs.after(done, setting, end, taken),
                                      single ? 0 : end.last - taken,
                                      bound_s,
                                      {}};
                        if (!m_runs.isGauged() || end.count - keptAt > m_mostSince) {
                            kept = end.steps.copy();
                            keptAt = end.count;
                        }
                        prefix.done.steps = kept;
                        prefix.done.since = end.count - keptAt;
                        prefix.done.recordState(end.steps);
                        push({bound_s, ++m_order, std::make_shared<Prefix>(std::move(prefix))});
                    }
                }
            },
            m_judge.counts);
    }

    /// Returns whether a last stage is shown to take too long or to end too deep before it is run.
    [[nodiscard]] bool isRefuted(const CyclePrefix& done, std::size_t setting, int merged) {
        if (!m_runs.canBoundLastStage()) {
            return false;
        }
        const double step_s = m_runs.bound().step_s(setting);
        const double begin_s = done.time_s;
        int mostSteps = std::numeric_limits<int>::max();
        if (m_judge.mostTime_us() != noTime_us) {
            const double left_s = seconds(m_judge.mostTime_us()) - begin_s;
            mostSteps = static_cast<int>(std::min(left_s / step_s, 1e9)) + 2;
        }
        const LastStageBound bound = m_runs.lastStageBound(done, setting, mostSteps);
        if (isSlower(begin_s + bound.leastSteps * step_s * (1 - 1e-9))) {
            return true;
        }
        if (bound.cutsTooDeep) {
            m_judge.cut(m_runner.cuts().tooDeep());
            return true;
        }
        GridCycle cycle = done.cycle;
        cycle.push_back({setting, 0});
        return m_judge.isRefuted(std::move(cycle), merged);
    }

    const Grid& m_grid;
    const SearchOptions& m_options;
    Judge m_judge;
    CycleRunner m_runner;
    StageRuns m_runs;
    std::vector<TooWide> m_tooWide;     ///< for the settings, independent of the cycle
    std::vector<double> m_rangeMargins; ///< for the settings, independent of the cycle
    double m_demanded = 0;              ///< margin to reach
    bool m_freeLast;                    ///< the last stage's stock has no bounds
    bool m_mayMerge;                    ///< ends of stages before the one before the last
    int m_leastSteps;                   ///< for each stage; all before the last have stock and feed
    int m_mostSince; ///< steps up to which repeating is no slower than keeping another copy
    /// Next settings by the number of stages, the number of finished ones and the last setting.
    std::map<std::array<std::size_t, 3>, std::vector<std::size_t>> m_followers;
    std::vector<std::size_t> m_settings, m_refuted; ///< for the branch being opened
    std::vector<Branch> m_branches;                 ///< a heap
    bool m_isFirstTaken = false;                    ///< the first of the heap has to be replaced
    std::vector<Branch> m_newest;                   ///< branches that the heap has no room for
    std::size_t m_mostWithSteps, m_most;            ///< in order
    std::size_t m_withSteps = 0;                    ///< branches in order whose prefix is whole
    long long m_order = 0;
    long long m_patience = 1 << 8, m_waited = 0; ///< branches
    bool m_seeded = false;
    double m_least_s = 0; ///< no remaining cycle is quicker
};

} // namespace

SearchSummary prunedSearch(const Project& project, const Grid& grid, const SearchOptions& options) {
    return PrunedSearch(project, grid, options).run();
}

} // namespace sparkout
