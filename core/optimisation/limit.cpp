// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/limit.h"

#include "core/optimisation/variants.h"
#include "core/process/contact_compliance.h"
#include "core/process/coupled_sections.h"
#include "core/process/force.h"
#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/accuracy_limit.h"
#include "core/quality/constraints.h"
#include "core/simulation/cycle_steps.h"
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
constexpr double slowestShare = 1e-3; ///< of the fastest axial feed: the cells' first upper end

/// The greatest a feed can be: of the machine's range, or of what is set and searched.
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

/// The greatest cut, and what keeps it from being greater.
struct BoundCut {
    double depth_mm = 0;
    LimitBound bound = LimitBound::stock;
    ConstraintKind kind = ConstraintKind::burn;
    [[nodiscard]] bool isSame(const LimitPiece& piece) const {
        return bound == piece.bound && (bound != LimitBound::requirement || kind == piece.kind);
    }
};

/// Least of the depths allowed at every pass [mm], and no more than what counts: the stock.
BoundCut leastLimit(const Project& project, double b, double stock_mm) {
    BoundCut least{project.part->stock_mm};
    for (const DepthLimit& limit : depthLimits(project, b, stock_mm)) {
        if (requirementOf(limit.kind).bindsEveryPass() && limit.depth_mm < least.depth_mm) {
            least = {limit.depth_mm, LimitBound::requirement, limit.kind};
        }
    }
    return least;
}

/// The pieces as they are met, from the deepest stock on.
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

/// The steps of a cycle as far as their time goes.
class StepTimes {
public:
    explicit StepTimes(const Project& project)
        : m_project(project)
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

    /// Least time of a step [s].
    [[nodiscard]] double least_s() const { return travels() ? step_s(m_fastest) : m_revolution_s; }

    /// ρ(s), or more [mm/s], with the cut that it is by.
    [[nodiscard]] std::pair<double, BoundCut> rate(double stock_mm) const {
        if (!travels()) {
            const double slices = isCoupled(m_project) ? m_project.sections : 1;
            const BoundCut cut =
                leastLimit(m_project, m_project.part->length_mm / slices, stock_mm);
            return {cut.depth_mm / m_revolution_s, cut};
        }
        std::pair<double, BoundCut> most{-1, {}};
        double low = 0; // the first cell goes on down to a standstill, where no drive is needed
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
    double m_revolution_s, m_dwells_s = 0, m_travel_mm = 0;
    double m_fastest = 0; ///< S_ax [mm/min]
};

/// What may be left to target where the drawing is held [mm per side].
double leftByField_mm(const Part& part) {
    const double shaft = part.surface == Surface::external ? 1 : -1;
    const double edge_um = shaft > 0 ? part.upper_deviation_um : part.lower_deviation_um;
    const double edge_mm = (part.diameter_mm + edge_um / units::umPerMm) / 2;
    return std::max(shaft * (edge_mm - targetRadius(part)), 0.0) + diameterSlack_mm;
}

/// The least number of passes in which a radius of the gauged section of a plunge loses its stock.
class LeastPasses {
public:
    /// @param left_mm above the target that its last pass may leave
    LeastPasses(const Project& project, double infeed_mm, double stock_mm, double left_mm,
                const std::stop_token& stop)
        : m_law(forceLaw(project))
        , m_b(project.part->length_mm)
        , m_gamma(
              compliantPoints(project)[static_cast<std::size_t>(gaugeSection(project))].gamma_mm_n)
        , m_infeed_mm(infeed_mm)
        , m_left_mm(left_mm)
        , m_cell_mm(stock_mm / cells) {
        const double lastCut_mm = provedLastCut_mm(project, m_b, m_gamma);
        LimitPoints release;
        if (std::isfinite(lastCut_mm)) {
            release = releaseCurve(m_law, m_b, m_gamma, lastCut_mm, stock_mm);
        }
        auto next = release.begin();
        for (int i = 1; i <= cells && !stop.stop_requested(); ++i) {
            const double upper_mm = i * m_cell_mm;
            while (next != release.end() && next->stock_mm < upper_mm) {
                ++next;
            }
            const bool known = next != release.end(); // it rises: its value further on is no less
            BoundCut most = leastLimit(project, m_b, left_mm + upper_mm);
            if (known && next->depth_mm < most.depth_mm) {
                most = {next->depth_mm, LimitBound::accuracy};
            }
            m_most.push_back(most);
        }
    }

    /// None where it cannot be lost in so many. Adds what bounds each pass, of so much time.
    [[nodiscard]] std::optional<int> count(const std::stop_token& stop, double pass_s,
                                           Pieces& pieces) const {
        constexpr int most = 1'000'000;
        constexpr double lastBits = 1e-9;
        double left_mm = cells * m_cell_mm * (1 - lastBits), reached_mm = 0;
        std::size_t cell = cells - 1;
        for (int n = 1; n <= most && !stop.stop_requested(); ++n) {
            reached_mm = depthAfter(m_law, m_b, m_gamma, reached_mm, m_infeed_mm);
            const auto lowest = [&](std::size_t i) { // that is left after a pass that ends in i
                return left_mm - std::min(reached_mm, m_most[i].depth_mm) * (1 + lastBits);
            };
            while (cell > 0 && lowest(cell - 1) <= static_cast<double>(cell) * m_cell_mm) {
                --cell;
            }
            const double after_mm = std::max(lowest(cell), static_cast<double>(cell) * m_cell_mm);
            // at the lower end of its cell it is what allows no cut into the next
            const bool isEnd = cell > 0 && after_mm > lowest(cell);
            const BoundCut& allowed = m_most[isEnd ? cell - 1 : cell];
            const BoundCut feed{reached_mm, LimitBound::feed};
            pieces.add(m_left_mm + left_mm, m_left_mm + std::max(after_mm, 0.0),
                       reached_mm <= allowed.depth_mm ? feed : allowed, pass_s);
            if (after_mm <= 0) {
                return n;
            }
            if (after_mm >= left_mm) {
                return std::nullopt;
            }
            left_mm = after_mm;
        }
        return std::nullopt;
    }

private:
    static constexpr int cells = 200;
    ForceLaw m_law;
    double m_b, m_gamma, m_infeed_mm, m_left_mm, m_cell_mm;
    std::vector<BoundCut> m_most; ///< of a pass that leaves up to the upper end of a cell
};

/// Whether passes of a radius follow one another as the release and the build-up suppose.
bool countsPasses(const Project& project) {
    return !project.operation->travels && !isCoupled(project) && !wheelContact(project);
}

/// Puts a bound in the place of a smaller one.
void takeGreater(SteplessLimit& limit, double time_s, LimitBy by, const Pieces& pieces) {
    if (time_s > limit.time_s) {
        limit = {time_s, by, pieces.all()};
    }
}

/// Of one variant.
SteplessLimit limitOf(const Project& project, bool sparksOut, const std::stop_token& stop) {
    const Blank blank = makeBlank(*project.part);
    const StepTimes times(project);
    SteplessLimit limit;
    if (times.infeed_mm <= 0 && !feedsContinuously(project)) {
        return limit;
    }
    const double left = sparksOut ? leftByField_mm(*project.part) : 0;
    const double all = blank.totalInfeed_mm - left - 2 * stageSlack_mm;
    const double end = left + 2 * stageSlack_mm; ///< stock left there
    const double steps = feedsContinuously(project)
                             ? 1 // what a step feeds grows with the time it takes
                             : std::max(std::ceil(all / times.infeed_mm - 1e-9), 1.0);
    // a last step cut short still takes its dwells and strokes
    const double steps_s = (steps + (sparksOut ? 1 : 0)) * times.least_s();
    Pieces bySteps;
    bySteps.add(end + all, end, {times.infeed_mm, LimitBound::feed}, steps_s);
    takeGreater(limit, steps_s, LimitBy::steps, bySteps);
    if (project.gauge->control == Control::gauge && !project.gauge->position_mm) {
        double deepest = 0;
        const std::vector<double>& gauged =
            blank.depthAt(static_cast<std::size_t>(gaugeSection(project)));
        for (std::size_t k = 0; k < blank.depth_mm.size(); ++k) {
            deepest = blank.isGap(k) ? deepest : std::max(deepest, gauged[k]);
        }
        const double cell = (all - deepest) / stockCells;
        double sum_s = 0;
        std::vector<std::pair<double, BoundCut>> rates; ///< from the size on
        for (int i = 1; i <= stockCells && cell > 0 && !stop.stop_requested(); ++i) {
            rates.push_back(times.rate(end + i * cell));
            sum_s += cell / rates.back().first; // each cell adds to it
        }
        Pieces byRates;
        for (std::size_t i = rates.size(); i > 0; --i) {
            const auto& [rate, cut] = rates[i - 1];
            const auto above = static_cast<double>(i);
            byRates.add(end + above * cell, end + (above - 1) * cell, cut, cell / rate);
        }
        takeGreater(limit, sum_s, LimitBy::rates, byRates);
        if (all > deepest && countsPasses(project)) {
            Pieces byPasses;
            const LeastPasses passes(project, times.infeed_mm, all - deepest, end, stop);
            const int count = passes.count(stop, times.least_s(), byPasses).value_or(0);
            takeGreater(limit, count * times.least_s(), LimitBy::passes, byPasses);
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
    if (variants.count() == 0) {
        return limitOf(plain, false, stop);
    }
    std::vector<std::pair<MachineSettings, bool>> met; // the counts of spark-outs do not matter
    SteplessLimit least{std::numeric_limits<double>::infinity(), LimitBy::steps, {}};
    for (std::size_t v = 0; v < variants.count(); ++v) {
        const Project& variant = variants.project(v);
        const std::pair each(machineSettings(variant), variants.grid(v).sparkOut() > 0);
        if (variants.grid(v).fault() == GridFault::none
            && std::find(met.begin(), met.end(), each) == met.end()) {
            met.push_back(each);
            SteplessLimit limit = limitOf(variant, each.second, stop);
            if (limit.time_s < least.time_s || met.size() == 1) {
                least = std::move(limit);
            }
        }
    }
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
