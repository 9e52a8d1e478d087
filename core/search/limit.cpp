// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/limit.h"

#include "core/process/contact_compliance.h"
#include "core/process/coupled_sections.h"
#include "core/process/force.h"
#include "core/process/printed_form.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/process/wheel_wave.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/accuracy_limit.h"
#include "core/quality/constraints.h"
#include "core/search/variants.h"
#include "core/simulation/cycle_loop.h"
#include "core/simulation/stage_control.h"
#include "core/simulation/traverse.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr int stockCells = 100, feedCells = 120;
constexpr double slowestShare = 1e-3; ///< share of the fastest axial feed at which the cells begin

/// The greatest possible feed: of the machine's range, or of the project and the search.
double greatest(const Project& project, const StageFeed& feed) {
    const auto& range = project.machine->limits.*feed.range;
    if (range && range->size() == 3) {
        return (*range)[1];
    }
    double most = 0;
    if (project.optimisation) {
        for (const double level : levelValues((*project.optimisation).*feed.levels)) {
            most = std::max(most, level);
        }
    }
    for (const Stage& stage : project.cycle->stages) {
        most = std::max(most, (stage.*feed.value).value_or(0));
    }
    return most;
}

/// The greatest continuous infeed [mm/min]; 0 if there is none.
double greatestContinuous(const Project& project) {
    const StageFeed* const feed = project.operation->continuous;
    return feed ? greatest(project, *feed) : 0;
}

/// The greatest cut and its bound.
struct BoundCut {
    double depth_mm = 0;
    LimitBound bound = LimitBound::stock;
    ConstraintKind kind = ConstraintKind::burn;
    [[nodiscard]] bool isSame(const LimitPiece& piece) const {
        return bound == piece.bound && (bound != LimitBound::requirement || kind == piece.kind);
    }
};

/// Least of the depths allowed at every pass [mm], at most the stock.
BoundCut leastLimit(const Project& project, double b, double stock_mm) {
    BoundCut least{project.part->stock_mm};
    for (const DepthLimit& limit : depthLimits(project, b, stock_mm)) {
        if (requirementOf(limit.kind).bindsEveryPass() && limit.depth_mm < least.depth_mm) {
            least = {limit.depth_mm, LimitBound::requirement, limit.kind};
        }
    }
    return least;
}

/// Collects the pieces, from the deepest stock on.
class Pieces {
public:
    void add(double from_mm, double to_mm, const BoundCut& cut, double time_s) {
        if (m_pieces.empty() || !cut.isSame(m_pieces.back())) {
            m_pieces.push_back({from_mm, to_mm, cut.bound, cut.kind});
        }
        LimitPiece& piece = m_pieces.back();
        piece.to_mm = to_mm;
        piece.cut_mm = std::max(piece.cut_mm, cut.depth_mm);
        piece.time_s += time_s;
    }
    [[nodiscard]] const std::vector<LimitPiece>& all() const { return m_pieces; }

private:
    std::vector<LimitPiece> m_pieces;
};

/// The times of a cycle's steps.
class StepTimes {
public:
    StepTimes(const Project& project, double continuousFeed_mm_min)
        : m_project(project)
        , m_continuous_mm_s(continuousFeed_mm_min / units::secondsPerMinute)
        , m_revolution_s(units::secondsPerMinute / project.machine->work_speed_rpm) {
        const Machine& machine = *project.machine;
        infeed_mm = project.operation.infeed_mm(greatest(project, project.operation->radial()),
                                                machine.work_speed_rpm);
        if (const StageFeed* const axial = project.operation->axial()) {
            m_fastest = greatest(project, *axial);
        }
        m_dwells_s = m_revolution_s
                     * (2 * dwellRevolutions(machine.dwell_entry_s, machine.work_speed_rpm)
                        + dwellRevolutions(machine.dwell_exit_s, machine.work_speed_rpm));
        m_travel_mm = project.part->length_mm - project.wheel->width_mm + machine.overrun_entry_mm
                      + machine.overrun_exit_mm;
    }

    double infeed_mm = 0; ///< the greatest of a step

    /// Least time of a step, without plunging in [s].
    [[nodiscard]] double least_s() const { return travels() ? step_s(m_fastest) : m_revolution_s; }

    /// Least time of this infeed by steps alone, and of `further` steps without infeed [s].
    [[nodiscard]] double feeding_s(double fed_mm, int further) const {
        const double steps_s = least_s(), rest_s = further * steps_s;
        if (!(m_continuous_mm_s > 0)) {
            const double steps = std::max(std::ceil(fed_mm / infeed_mm - 1e-9), 1.0);
            return withPlungeIn_s(steps * steps_s, fed_mm) + rest_s;
        }
        // the least over N: more steps take longer and leave less to the continuous infeed
        const auto by = [&](double steps) { return withPlungeIn_s(steps * steps_s, fed_mm); };
        const auto continuous_s = [&](double steps) {
            return (fed_mm - steps * infeed_mm) / m_continuous_mm_s;
        };
        double low = 0, high = infeed_mm > 0 ? std::ceil(std::max(fed_mm / infeed_mm, 1.0)) : 1;
        while (high - low > 1) { // by(high) ≥ continuous_s(high), but by(low) < continuous_s(low)
            const double middle = std::floor((low + high) / 2);
            (by(middle) >= continuous_s(middle) ? high : low) = middle;
        }
        const double there_s = std::max(by(high), continuous_s(high));
        return (low > 0 ? std::min(there_s, continuous_s(low)) : there_s) + rest_s;
    }

    /// Adds all plunging in to the least time of strokes and dwells.
    [[nodiscard]] double withPlungeIn_s(double passes_s, double fed_mm) const {
        if (!travels()) {
            return passes_s;
        }
        const Machine& machine = *m_project.machine;
        if (m_continuous_mm_s > 0) {
            const double plunge_mm_s = machine.plunge_feed_mm_min / units::secondsPerMinute;
            return std::max(passes_s,
                            (fed_mm + plunge_mm_s * passes_s) / (m_continuous_mm_s + plunge_mm_s));
        }
        // each may be rounded down by 1e-9 of a revolution; no run has a million of them
        constexpr double rounding = 1e-3;
        const double turns = machine.work_speed_rpm * fed_mm / machine.plunge_feed_mm_min;
        return passes_s + std::max(std::ceil(turns - rounding), 0.0) * m_revolution_s;
    }

    /// Upper bound of ρ(s) [mm/s], with its cut.
    [[nodiscard]] std::pair<double, BoundCut> rate(double stock_mm) const {
        if (!travels()) {
            const double slices = isCoupled(m_project) ? m_project.sections : 1;
            const BoundCut cut =
                leastLimit(m_project, m_project.part->length_mm / slices, stock_mm);
            return {cut.depth_mm / m_revolution_s, cut};
        }
        std::pair<double, BoundCut> most{-1, {}};
        double low = 0; // the first cell extends to standstill, where no drive is needed
        for (int i = 0; i <= feedCells; ++i) {
            const double high =
                m_fastest * std::pow(slowestShare, 1 - static_cast<double>(i) / feedCells);
            const double width =
                std::min(std::max(low, m_fastest * 1e-9) / m_project.machine->work_speed_rpm,
                         m_project.wheel->width_mm);
            const BoundCut cut = leastLimit(m_project, width, stock_mm);
            if (const double rate = cut.depth_mm / (step_s(high) / 2); rate > most.first) {
                most = {rate, cut};
            }
            low = high;
        }
        return most;
    }

private:
    [[nodiscard]] bool travels() const { return m_project.operation->travels; }
    [[nodiscard]] double step_s(double axialFeed_mm_min) const {
        return m_dwells_s + 2 * m_travel_mm / axialFeed_mm_min * units::secondsPerMinute;
    }

    const Project& m_project;
    double m_continuous_mm_s; ///< S_c
    double m_revolution_s, m_dwells_s = 0, m_travel_mm = 0;
    double m_fastest = 0; ///< S_ax [mm/min]
};

/// The greatest stock left that the drawing allows [mm per side].
double leftByField_mm(const Part& part) {
    const double shaft = part.surface == Surface::external ? 1 : -1;
    const double edge_um = shaft > 0 ? part.upper_deviation_um : part.lower_deviation_um;
    const double edge_mm = (part.diameter_mm + edge_um / units::umPerMm) / 2;
    return std::max(shaft * (edge_mm - targetRadius(part)), 0.0) + diameterSlack_mm;
}

/// A radius of a section that certainly loses this stock, and may end this far above the target.
struct Loss {
    double stock_mm = 0, left_mm = 0;
    std::size_t section = 0;
    SpreadOf spread = SpreadOf::eachRadius; ///< relative to other sections
};

/// The radii of a section: the deepest of the blank, and of the complete diameters the one whose
/// deeper end is the shallowest.
struct BlankOfSection {
    double deepest_mm = 0, shallowPair_mm = std::numeric_limits<double>::infinity();
    BlankOfSection(const Blank& blank, std::size_t section) {
        const std::vector<double>& depth = blank.depthAt(section);
        const std::size_t half = depth.size() / 2;
        for (std::size_t k = 0; k < depth.size(); ++k) {
            if (blank.isGap(k)) {
                continue;
            }
            deepest_mm = std::max(deepest_mm, depth[k]);
            if (k < half && !blank.isGap(k + half)) {
                shallowPair_mm = std::min(shallowPair_mm, std::max(depth[k], depth[k + half]));
            }
        }
    }
};

/// Points (1) to (4) of the header, for a cycle that leaves at most `left_mm` at the gauge, or in
/// the mean of two opposite radii.
std::vector<Loss> lossesOf(const Project& project, const Blank& blank, double left_mm) {
    const double all_mm = blank.totalInfeed_mm;
    const auto gauged = static_cast<std::size_t>(gaugeSection(project));
    const BlankOfSection there(blank, gauged);
    const double byField_mm =
        leftByField_mm(*project.part) + 2 * stageSlack_mm + mostOfDiameters_mm(project);
    std::vector<Loss> losses{{all_mm - left_mm - there.deepest_mm, left_mm, gauged},
                             {all_mm - byField_mm - there.shallowPair_mm, byField_mm, gauged}};
    const std::vector<CompliantPoint> points = compliantPoints(project);
    const auto softest = static_cast<std::size_t>(
        std::ranges::max_element(points, {}, &CompliantPoint::gamma_mm_n) - points.begin());
    const BlankOfSection soft(blank, softest);
    losses.push_back({all_mm - byField_mm - soft.shallowPair_mm, byField_mm, softest});
    if (const auto& runout_um = project.part->tolerance.radial_runout_um) {
        const double apart_mm =
            std::max(*runout_um - addedRunout_um(*project.machine), 0.0) / units::umPerMm
            + mostPrinted_mm(project) + diameterSlack_mm;
        const double ofAny_mm = left_mm + apart_mm, ofTwo_mm = byField_mm + apart_mm / 2;
        losses.push_back(
            {all_mm - ofAny_mm - there.shallowPair_mm, ofAny_mm, gauged, SpreadOf::oneOfTwo});
        losses.push_back(
            {all_mm - ofTwo_mm - soft.shallowPair_mm, ofTwo_mm, softest, SpreadOf::oneOfTwo});
    }
    return losses;
}

/// The least number of passes in which a radius of a plunge loses its stock.
class LeastPasses {
public:
    LeastPasses(const Project& project, double infeed_mm, bool mayDrawBack, const Loss& loss,
                const std::stop_token& stop)
        : m_law(forceLaw(project))
        , m_b(project.part->length_mm)
        , m_infeed_mm(infeed_mm)
        , m_left_mm(loss.left_mm)
        , m_cell_mm(loss.stock_mm / cells) {
        const std::vector<CompliantPoint> points = compliantPoints(project);
        m_gamma = points[loss.section].gamma_mm_n;
        const double lastCut_mm = provedLastCut_mm(project, m_b, m_gamma, loss.spread);
        LimitPoints release;
        if (std::isfinite(lastCut_mm) && !mayDrawBack) {
            release = releaseCurve(m_law, m_b, m_gamma, lastCut_mm, loss.stock_mm);
        }
        auto next = release.begin();
        for (int i = 1; i <= cells && !stop.stop_requested(); ++i) {
            const double upper_mm = i * m_cell_mm;
            while (next != release.end() && next->stock_mm < upper_mm) {
                ++next;
            }
            const bool known = next != release.end(); // it rises: later values are no less
            BoundCut most = leastLimit(project, m_b, m_left_mm + upper_mm);
            if (known && next->depth_mm < most.depth_mm) {
                most = {next->depth_mm, LimitBound::accuracy};
            }
            m_most.push_back(most);
        }
        const double stiffest =
            std::ranges::min_element(points, {}, &CompliantPoint::gamma_mm_n)->gamma_mm_n;
        const double spread_mm = provedSpread_mm(project, loss.spread) + 2 * diameterSlack_mm;
        if (!mayDrawBack && stiffest > 0 && m_gamma > stiffest && std::isfinite(spread_mm)) {
            boundLastCuts(stiffest, spread_mm, stop);
        }
    }

    /// Empty if it cannot be lost in this many passes. Adds the bound of each pass with its time;
    /// the last ones that count together are one piece.
    [[nodiscard]] std::optional<int> count(const std::stop_token& stop, double pass_s,
                                           Pieces& pieces, int& together) const {
        const std::vector<Pass> passes = allPasses(stop);
        if (passes.empty() || passes.back().to_mm > 0) {
            return std::nullopt;
        }
        std::size_t before = passes.size(), last = 0;
        for (std::size_t m = 0; m < m_lastCuts_mm.size(); ++m) {
            std::size_t n = 0; // the last ones take at most the stock left here
            while (n < passes.size() && passes[n].from_mm > m_lastCuts_mm[m]) {
                ++n;
            }
            if (n > 0 && n + fewestTogether + m > before + last) {
                before = n;
                last = fewestTogether + m;
            }
        }
        const std::size_t all = before + last;
        if (last > 0 && before == passes.size()) {
            --before; // the pass that may remove the whole rest counts among the last ones together
        }
        for (std::size_t n = 0; n < before; ++n) {
            pieces.add(m_left_mm + passes[n].from_mm, m_left_mm + passes[n].to_mm, passes[n].cut,
                       pass_s);
        }
        together = last > 0 ? static_cast<int>(all - before) : 0;
        if (together > 0) {
            pieces.add(m_left_mm + passes[before].from_mm, m_left_mm,
                       {passes[before].cut.depth_mm, LimitBound::accuracy}, together * pass_s);
        }
        return static_cast<int>(all);
    }

private:
    struct Pass {
        double from_mm = 0, to_mm = 0; ///< least stock still to lose before and after it
        BoundCut cut;
    };

    /// The greatest cuts pass by pass, until all is lost or no cut is possible.
    [[nodiscard]] std::vector<Pass> allPasses(const std::stop_token& stop) const {
        constexpr std::size_t most = 1'000'000;
        constexpr double lastBits = 1e-9;
        std::vector<Pass> passes;
        double left_mm = cells * m_cell_mm * (1 - lastBits), reached_mm = 0;
        std::size_t cell = cells - 1;
        while (left_mm > 0 && passes.size() < most && !stop.stop_requested()) {
            reached_mm = depthAfter(m_law, m_b, m_gamma, reached_mm, m_infeed_mm);
            const auto lowest = [&](std::size_t i) { // stock left after a pass that ends in i
                return left_mm - std::min(reached_mm, m_most[i].depth_mm) * (1 + lastBits);
            };
            while (cell > 0 && lowest(cell - 1) <= static_cast<double>(cell) * m_cell_mm) {
                --cell;
            }
            const double after_mm = std::max(lowest(cell), static_cast<double>(cell) * m_cell_mm);
            if (after_mm >= left_mm) {
                break;
            }
            // at the lower end of its cell it allows no cut into the next
            const bool isEnd = cell > 0 && after_mm > lowest(cell);
            const BoundCut& allowed = m_most[isEnd ? cell - 1 : cell];
            const BoundCut feed{reached_mm, LimitBound::feed};
            passes.push_back({left_mm, std::max(after_mm, 0.0),
                              reached_mm <= allowed.depth_mm ? feed : allowed});
            left_mm = after_mm;
        }
        return passes;
    }

    /// Bounds the sums of the last two and three cuts, where the radii of the stiffest section may
    /// be this far apart.
    void boundLastCuts(double stiffest, double spread_mm, const std::stop_token& stop) {
        constexpr double lastBits = 1e-9;
        const auto most = [&](double after_mm) {
            const auto cell = static_cast<std::size_t>(after_mm / m_cell_mm);
            return std::min(m_most[std::min(cell, m_most.size() - 1)].depth_mm, m_infeed_mm);
        };
        for (std::size_t m = 0; m < mostTogether - fewestTogether + 1; ++m) {
            if (m_most.size() < cells || stop.stop_requested()) {
                return;
            }
            m_lastCuts_mm.push_back(lastCutsOfSpread(m_law, m_b, stiffest, m_gamma, spread_mm,
                                                     static_cast<int>(fewestTogether + m), most)
                                    * (1 + lastBits));
        }
    }

    static constexpr int cells = 200;
    static constexpr std::size_t fewestTogether = 2, mostTogether = 3;
    ForceLaw m_law;
    double m_b, m_gamma = 0, m_infeed_mm, m_left_mm, m_cell_mm;
    std::vector<BoundCut> m_most;      ///< cuts of a pass that leaves up to a cell's upper end
    std::vector<double> m_lastCuts_mm; ///< greatest sums of the last two, three … cuts
};

/// Whether passes of a radius follow one another as the release and the build-up suppose.
bool countsPasses(const Project& project) {
    return !project.operation->travels && !isCoupled(project) && !wheelContact(project)
           && !hasThreshold(project) && !project.wheel->runout;
}

/// Replaces a smaller bound.
void takeGreater(SteplessLimit& limit, double time_s, LimitBy by, const Pieces& pieces,
                 const CountedRadius& counted = {}) {
    if (time_s > limit.time_s) {
        limit = {time_s, by, counted, pieces.all()};
    }
}

/// The limit of one variant, whose cycles end with a counted spark-out or do not.
SteplessLimit limitOf(const Project& project, const LimitedCycles& cycles, bool sparksOut,
                      const std::stop_token& stop) {
    const Blank blank = makeBlank(*project.part);
    const StepTimes times(project, cycles.continuousFeed_mm_min);
    SteplessLimit limit;
    if (times.infeed_mm <= 0 && cycles.continuousFeed_mm_min <= 0) {
        return limit;
    }
    // where the gauge ends the cycle and reads too small, more stock is left
    const double all_mm = blank.totalInfeed_mm;
    const double short_mm = std::max(all_mm - depthAtEnd_mm(project, all_mm), 0.0);
    const double left = sparksOut ? leftByField_mm(*project.part) : short_mm;
    const double end = left + 2 * stageSlack_mm + mostOfDiameters_mm(project)
                       + wheelAmplitude_mm(project); ///< stock left
    const double all = blank.totalInfeed_mm - end;
    // a datum of the position control may be nearer than the first touch; wear of the wheel shifts
    // the beginning and the end of the feed alike
    const double datum = firstFeed(project, blank.totalInfeed_mm) + standsBack_mm(project);
    const double fed = all - std::max(datum, 0.0);
    // a shortened last step takes its full dwells and strokes
    const double steps_s = times.feeding_s(fed, sparksOut ? 1 : 0);
    const double most_mm =
        times.infeed_mm + cycles.continuousFeed_mm_min / units::secondsPerMinute * times.least_s();
    Pieces bySteps;
    bySteps.add(end + all, end, {most_mm, LimitBound::feed}, steps_s);
    takeGreater(limit, steps_s, LimitBy::steps, bySteps);
    if (project.gauge->control == Control::gauge && !project.gauge->position_mm) {
        const std::vector<Loss> losses = lossesOf(project, blank, end);
        const double stock = losses.front().stock_mm;
        const double cell = stock / stockCells;
        double sum_s = 0;
        std::vector<std::pair<double, BoundCut>> rates; ///< from the size on
        for (int i = 1; i <= stockCells && cell > 0 && !stop.stop_requested(); ++i) {
            rates.push_back(times.rate(end + i * cell));
            sum_s += cell / rates.back().first; // contribution of each cell
        }
        const double rates_s = times.withPlungeIn_s(sum_s, fed);
        Pieces byRates;
        for (std::size_t i = rates.size(); i > 0; --i) {
            const auto& [rate, cut] = rates[i - 1];
            const auto above = static_cast<double>(i);
            byRates.add(end + above * cell, end + (above - 1) * cell, cut,
                        cell / rate + (rates_s - sum_s) / stockCells);
        }
        takeGreater(limit, rates_s, LimitBy::rates, byRates);
        for (const Loss& loss : losses) {
            if (!(loss.stock_mm > 0) || !countsPasses(project)) {
                continue;
            }
            Pieces byPasses;
            const LeastPasses passes(project, times.infeed_mm, cycles.drawBack, loss, stop);
            CountedRadius counted{loss.section, loss.spread};
            const int count =
                passes.count(stop, times.least_s(), byPasses, counted.together).value_or(0);
            takeGreater(limit, count * times.least_s(), LimitBy::passes, byPasses, counted);
        }
    }
    constexpr double lastBits = 1e-9;
    limit.time_s *= 1 - lastBits;
    for (LimitPiece& piece : limit.pieces) {
        piece.time_s *= 1 - lastBits;
    }
    if (stop.stop_requested()) {
        limit.pieces.clear();
    }
    return limit;
}

} // namespace

SteplessLimit steplessLimitBounds(const Project& project, const std::stop_token& stop) {
    Project plain = project;
    plain.runs.clear();
    plain.batch.reset();
    const Variants variants(plain, stop);
    if (variants.isCutShort()) {
        return {};
    }
    LimitedCycles cycles{greatestContinuous(plain), drawsBack(plain), false};
    std::vector<std::pair<MachineSettings, bool>> met; // the counts of spark-outs do not matter
    SteplessLimit least{std::numeric_limits<double>::infinity(), LimitBy::steps, {}, {}};
    const auto take = [&](const Project& variant, bool sparksOut) {
        const std::pair each(machineSettings(variant), sparksOut);
        if (std::ranges::find(met, each) == met.end()) {
            met.push_back(each);
            SteplessLimit limit = limitOf(variant, cycles, sparksOut, stop);
            if (limit.time_s < least.time_s || met.size() == 1) {
                least = std::move(limit);
            }
        }
    };
    for (std::size_t v = 0; v < variants.count(); ++v) {
        if (variants.grid(v).fault() == GridFault::none) {
            take(variants.project(v), variants.grid(v).sparkOut() > 0);
        }
    }
    take(plain, plain.cycle->stages.back().sparkOutSteps().has_value()); // the project's own cycle
    cycles.sparkOut = std::ranges::any_of(met, [](const auto& each) { return each.second; });
    least.cycles = cycles;
    return least;
}

double steplessLimit_s(const Project& project, const std::stop_token& stop) {
    return steplessLimitBounds(project, stop).time_s;
}

const char* limitByKey(LimitBy by) {
    switch (by) {
    case LimitBy::rates: return "rates";
    case LimitBy::passes: return "passes";
    case LimitBy::steps: break;
    }
    return "steps";
}

} // namespace sparkout
