// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/case_refuter.h"

#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/search/last_stage_bound.h"
#include "core/search/stage_runs.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <utility>

namespace sparkout {

namespace {

constexpr double mostFormChange_mm = 2e-5;
constexpr double roundings_mm = 2e-9; ///< rounding of depths and written stocks, generously
constexpr double nearest_mm = 1e-5;   ///< tolerance of the deviation of a diameter

double largestInfeed_mm(const Project& project, const Grid& grid) {
    double most_mm = 0;
    for (const StageSetting& setting : grid.settings()) {
        most_mm = std::max(most_mm, setting.sparkOut == 0 ? infeedOf(project, setting) : 0);
    }
    return most_mm;
}

Project withStock(Project project, double stock_mm) {
    project.part->stock_mm = stock_mm;
    return project;
}

} // namespace

CaseRefuter::CaseRefuter(const PhaseCase& of, const Grid& grid, std::size_t memory_bytes,
                         const std::stop_token& stop)
    : m_grid(grid)
    , m_corner(of.corner)
    , m_stocks(of.stocks)
    , m_part(withStock(of.part, widened(of.stocks, largestInfeed_mm(of.part, grid)).from_mm))
    , m_runner(m_part, grid, stop)
    , m_blank(m_runner.begin(grid.stageCounts().front()))
    , m_mostKept_bytes(memory_bytes) {
    const double most_mm = widened(of.stocks, largestInfeed_mm(of.part, grid)).to_mm;
    const double form_mm = formChange_mm(m_part, most_mm - m_part.part->stock_mm);
    const RadiusFollower* const follower = m_blank->follower();
    const bool isChangeLate = m_part.machine->feed_change_delay_s.value_or(0) > 0;
    if (!follower || isChangeLate || form_mm > mostFormChange_mm) {
        return;
    }
    m_tolerance_mm = form_mm + roundings_mm;
    for (const StageSetting& setting : grid.settings()) {
        m_infeeds_mm.push_back(infeedOf(m_part, setting));
        m_feeds.push_back(follower->feed(stepFeedOf(m_part, setting, 0)));
    }
    m_blankState = stateOf(*m_blank, GaugeSignal(m_part, false));
    m_lags.emplace(*follower, m_feeds, m_blank->gaugePoint());
    const Run& run = m_blank->run();
    m_leastDepth_mm = run.sizeDepth_mm() - stageSlack_mm - 8 * m_tolerance_mm;
    m_excess_mm = (m_runner.cuts().left_mm(run.diameterDeviation(m_leastDepth_mm, m_leastDepth_mm))
                   + larger_mm(0))
                  / 2;
}

bool CaseRefuter::refutes(const GridCycle& cycle) {
    if (m_feeds.empty()) {
        return false;
    }
    const StockRange range = stocksOf(cycle);
    if (cycle.size() == 1) {
        return endsTooDeep(m_blankState, cycle, range);
    }
    return visitLast(
        first(cycle.size(), cycle.front().setting), std::span(cycle).first(cycle.size() - 1), 0, 0,
        range,
        [&](const State& state, StockRange stocks) { return endsTooDeep(state, cycle, stocks); });
}

void CaseRefuter::keepRefuted(const GridCycle& beforeLast, std::vector<std::size_t>& settings) {
    m_ends.clear();
    if (!m_feeds.empty() && !beforeLast.empty()) {
        visitLast(first(beforeLast.size() + 1, beforeLast.front().setting), beforeLast, 0, 0,
                  stocksOf(beforeLast), [&](const State& state, StockRange stocks) {
                      m_ends.push_back(endOf(state.critical, stocks));
                      return false;
                  });
    }
    if (std::ranges::any_of(m_ends, &End::isTooDeep)) {
        return;
    }
    std::ranges::sort(m_ends, std::greater(), &End::stocks_mm); // the longest refutes most
    std::erase_if(settings, [&](std::size_t setting) {
        return m_grid.settings()[setting].sparkOut > 0
               || std::ranges::none_of(m_ends,
                                       [&](const End& end) { return isFedTooFar(end, setting); });
    });
}

/// Range of the stocks for which a cycle of these stages must be fit, counted from the least stock
/// of all [mm].
StockRange CaseRefuter::stocksOf(const GridCycle& cycle) const {
    double infeed_mm = 0;
    for (const GridStage& stage : cycle) {
        const bool feeds = m_grid.settings()[stage.setting].sparkOut == 0;
        infeed_mm = std::max(infeed_mm, feeds ? m_infeeds_mm[stage.setting] : 0);
    }
    StockRange range = widened(m_stocks, infeed_mm);
    range.from_mm -= m_part.part->stock_mm;
    range.to_mm -= m_part.part->stock_mm;
    return range;
}

CaseRefuter::Stage& CaseRefuter::first(std::size_t stages, std::size_t setting) {
    if (m_kept_bytes > m_mostKept_bytes) {
        m_first.clear();
        m_kept_bytes = 0;
    }
    const std::pair key(stages, setting);
    const auto found = m_first.find(key);
    return found != m_first.end()
               ? found->second
               : m_first.emplace(key, begin(m_runner.begin(stages), GaugeSignal(m_part, false)))
                     .first->second;
}

/// Visits the steps at which stocks of the range end a stage before the last.
bool CaseRefuter::visitLast(Stage& stage, std::span<const GridStage> before, std::size_t place,
                            int taken, StockRange range, const AtLast& atLast) {
    const int behind = taken + before[place].steps;
    const double later_mm = m_grid.remainder(behind) + stageSlack_mm;
    const auto isBefore = [&](const State& each) { // no stock of the range ends it there
        return later_mm - each.known_mm - range.from_mm <= 4 * m_tolerance_mm;
    };
    const auto first = std::ranges::partition_point(stage.states, isBefore);
    const auto known = static_cast<std::size_t>(first - stage.states.begin());
    for (std::size_t count = std::max<std::size_t>(known, place == 0 ? 1 : 0);
         range.to_mm - range.from_mm > 4 * m_tolerance_mm; ++count) {
        const State* const state = stateAt(stage, count, place, before[place].setting);
        if (!state) {
            return false;
        }
        const double end_mm = later_mm - state->known_mm;
        const StockRange ending{range.from_mm, std::min(range.to_mm, end_mm)};
        if (ending.to_mm - ending.from_mm <= 4 * m_tolerance_mm) {
            continue;
        }
        if (place + 1 == before.size()) {
            if (atLast(*state, ending)) {
                return true;
            }
        } else if (Stage* const next = follower(stage, count, before, place);
                   next && visitLast(*next, before, place + 1, behind, ending, atLast)) {
            return true;
        }
        range.from_mm = ending.to_mm;
    }
    return false;
}

CaseRefuter::Stage CaseRefuter::begin(std::shared_ptr<const CycleSteps> from,
                                      const GaugeSignal& before) {
    Stage stage{before, before, {}, from->copy(), {}, {}};
    stage.steps->run().keepRadiiAlone();
    stage.states.push_back(stateOf(*from, before));
    stage.kept.emplace(0, std::move(from));
    m_kept_bytes += prefixBytes(m_part);
    return stage;
}

CaseRefuter::State CaseRefuter::stateOf(const CycleSteps& steps, const GaugeSignal& signal) const {
    return {criticalRadii(steps), steps.run().time_s(), steps.remaining(), signal.known_mm()};
}

const CaseRefuter::State* CaseRefuter::stateAt(Stage& stage, std::size_t count, std::size_t place,
                                               std::size_t setting) {
    while (stage.states.size() <= count) {
        if (!stage.steps || stage.steps->run().mustEnd()
            || !stage.steps->step(stepFeedOf(m_part, m_grid.settings()[setting], place))) {
            stage.steps.reset();
            return nullptr;
        }
        stage.signal.read(stage.steps->run().time_s(), stage.steps->remaining());
        stage.states.push_back(stateOf(*stage.steps, stage.signal));
        m_kept_bytes += sizeof(State);
    }
    return &stage.states[count];
}

/// The next stage of the cycle after so many steps; null after a stop.
CaseRefuter::Stage* CaseRefuter::follower(Stage& stage, std::size_t count,
                                          std::span<const GridStage> before, std::size_t place) {
    const std::size_t setting = before[place].setting;
    const std::pair key(count, before[place + 1].setting);
    if (const auto found = stage.next.find(key); found != stage.next.end()) {
        return &found->second;
    }
    const auto& [made, there] = *std::prev(stage.kept.upper_bound(count));
    std::shared_ptr<const CycleSteps> from = there;
    if (made < count) {
        std::unique_ptr<CycleSteps> steps = there->copy();
        steps->run().keepRadiiAlone();
        for (std::size_t i = made; i < count; ++i) {
            if (steps->run().mustEnd()
                || !steps->step(
                    {m_infeeds_mm[setting], place, m_grid.settings()[setting].axialFeed_mm_min})) {
                return nullptr;
            }
        }
        from = std::move(steps);
        stage.kept.emplace(count, from);
        m_kept_bytes += prefixBytes(m_part);
    }
    GaugeSignal signal = stage.before;
    for (std::size_t i = 1; i <= count; ++i) {
        signal.read(stage.states[i].time_s, stage.states[i].remaining_mm);
    }
    return &stage.next.emplace(key, begin(from, signal)).first->second;
}

bool CaseRefuter::endsTooDeep(const State& state, const GridCycle& cycle, StockRange range) {
    const std::size_t setting = cycle.back().setting;
    const int sparkOut = m_grid.settings()[setting].sparkOut;
    const RadiusFollower& follower = *m_blank->follower();
    const Run& run = m_blank->run();
    const double size_mm = run.sizeDepth_mm() - stageSlack_mm - roundings_mm;
    const long long mostPasses = maxVisits / run.radii();
    const double most_mm = range.to_mm - m_tolerance_mm;
    FollowedRadii strokes = state.critical;
    m_least_mm.assign(1, range.from_mm + m_tolerance_mm);
    for (int made = 0; m_least_mm.back() < most_mm; ++made) {
        if (isTooDeep(strokes, m_least_mm.back())) {
            return true;
        }
        if (sparkOut > 0 ? made >= sparkOut : strokes.passes > mostPasses) {
            break;
        }
        const bool mayEnd = sparkOut == 0 && (cycle.size() > 1 || made > 0);
        const double ended_mm = strokes.radii[0].depth_mm - size_mm + m_tolerance_mm;
        m_least_mm.push_back(mayEnd ? std::max(m_least_mm.back(), ended_mm) : m_least_mm.back());
        follower.strokesAlone(strokes, m_feeds[setting]);
    }
    FollowedRadii all = state.critical;
    for (std::size_t made = 1;
         !follower.hasStrokesAlone() && made < m_least_mm.size() && m_least_mm[made] < most_mm;
         ++made) {
        follower.stepAlone(all, m_feeds[setting]);
        if (isTooDeep(all, m_least_mm[made])) {
            return true;
        }
    }
    return false;
}

CaseRefuter::End CaseRefuter::endOf(const FollowedRadii& critical, StockRange stocks) {
    const auto& [gauged, one, other] = critical.radii;
    const bool isLater = m_blank->follower()->hasStrokesAlone();
    const auto deep = [&](const FollowedRadius& radius) {
        return Deep{.lag_mm = critical.fed_mm - radius.depth_mm,
                    .share = isLater ? radius.share : 0,
                    .most = m_lags->most(radius.zone).data()};
    };
    return {.infeed_mm = m_leastDepth_mm + stocks.from_mm - critical.fed_mm,
            .stocks_mm = stocks.to_mm - stocks.from_mm,
            .gauged_mm = critical.fed_mm - gauged.depth_mm,
            .least_mm = m_lags->least_mm().data(),
            .deep = {deep(one), deep(other)},
            .isTooDeep = isTooDeep(critical, stocks.from_mm + m_tolerance_mm)};
}

bool CaseRefuter::isFedTooFar(const End& end, std::size_t setting) const {
    const double infeed_mm = m_infeeds_mm[setting];
    const double least_mm = std::min(end.gauged_mm, end.least_mm[setting]);
    const double beyond_mm = std::min(infeed_mm, end.stocks_mm) + least_mm - m_excess_mm;
    double steady_mm = 0, more_mm = 0, slope = 0; // for both radii
    for (const Deep& each : end.deep) {
        const SteadyLags::Most& most = each.most[setting];
        const double lag_mm = most.lag_mm - infeed_mm * each.share;
        steady_mm += lag_mm;
        more_mm += std::max(each.lag_mm - lag_mm, 0.0);
        slope = std::max(slope, most.slope);
    }
    if (steady_mm + more_mm < 2 * beyond_mm || steady_mm >= 2 * beyond_mm) {
        return steady_mm + more_mm < 2 * beyond_mm;
    }
    const double steps = (end.infeed_mm + least_mm) / infeed_mm; // lower bound, up to the end
    return steps > 0 && steady_mm + more_mm * std::pow(slope, std::ceil(steps)) < 2 * beyond_mm;
}

/// The greatest increase of a diameter for a stock greater by `more_mm` than that of the shared
/// run.
double CaseRefuter::larger_mm(double more_mm) const {
    return 2 * more_mm + nearest_mm + 4 * m_tolerance_mm;
}

/// Decides for a stock greater by `more_mm` than that of the shared run.
bool CaseRefuter::isTooDeep(const FollowedRadii& radii, double more_mm) const {
    const double deviation_mm =
        m_blank->run().diameterDeviation(radii.radii[1].depth_mm, radii.radii[2].depth_mm);
    return m_runner.cuts().left_mm(deviation_mm) + larger_mm(more_mm) < 0;
}

} // namespace sparkout
