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
#include "core/quality/depth_limits.h"
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

/// Least of the depths allowed at every pass [mm], and no more than what counts: the stock.
double leastLimit(const Project& project, double b, double stock_mm) {
    double least = project.part->stock_mm;
    for (const DepthLimit& limit : depthLimits(project, b, stock_mm)) {
        if (requirementOf(limit.kind).bindsEveryPass()) {
            least = std::min(least, limit.depth_mm);
        }
    }
    return least;
}

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

    /// ρ(s), or more [mm/s].
    [[nodiscard]] double rate(double stock_mm) const {
        if (!travels()) {
            const double slices = isCoupled(m_project) ? m_project.sections : 1;
            return leastLimit(m_project, m_project.part->length_mm / slices, stock_mm)
                   / m_revolution_s;
        }
        double most = 0;
        double low = 0; // the first cell goes on down to a standstill, where no drive is needed
        for (int i = 0; i <= feedCells; ++i) {
            const double high =
                m_fastest * std::pow(slowestShare, 1 - static_cast<double>(i) / feedCells);
            const double width =
                std::min(std::max(low, m_fastest * 1e-9) / m_project.machine->work_speed_rpm,
                         m_project.wheel->width_mm);
            most = std::max(most, leastLimit(m_project, width, stock_mm) / (step_s(high) / 2));
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
            m_most_mm.push_back(
                std::min(leastLimit(project, m_b, left_mm + upper_mm),
                         known ? next->depth_mm : std::numeric_limits<double>::infinity()));
        }
    }

    /// None where it cannot be lost in so many.
    [[nodiscard]] std::optional<int> count(const std::stop_token& stop) const {
        constexpr int most = 1'000'000;
        constexpr double lastBits = 1e-9;
        double left_mm = cells * m_cell_mm * (1 - lastBits), reached_mm = 0;
        std::size_t cell = cells - 1;
        for (int n = 1; n <= most && !stop.stop_requested(); ++n) {
            reached_mm = depthAfter(m_law, m_b, m_gamma, reached_mm, m_infeed_mm);
            const auto lowest = [&](std::size_t i) { // that is left after a pass that ends in i
                return left_mm - std::min(reached_mm, m_most_mm[i]) * (1 + lastBits);
            };
            while (cell > 0 && lowest(cell - 1) <= static_cast<double>(cell) * m_cell_mm) {
                --cell;
            }
            const double after_mm = std::max(lowest(cell), static_cast<double>(cell) * m_cell_mm);
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
    double m_b, m_gamma, m_infeed_mm, m_cell_mm;
    std::vector<double> m_most_mm; ///< of a pass that leaves up to the upper end of a cell
};

/// Whether passes of a radius follow one another as the release and the build-up suppose.
bool countsPasses(const Project& project) {
    return !project.operation->travels && !isCoupled(project) && !wheelContact(project);
}

/// Of one variant.
double limitOf(const Project& project, bool sparksOut, const std::stop_token& stop) {
    const Blank blank = makeBlank(*project.part);
    const StepTimes times(project);
    if (times.infeed_mm <= 0 && !feedsContinuously(project)) {
        return 0;
    }
    const double left = sparksOut ? leftByField_mm(*project.part) : 0;
    const double all = blank.totalInfeed_mm - left - 2 * stageSlack_mm;
    const double steps = feedsContinuously(project)
                             ? 1 // what a step feeds grows with the time it takes
                             : std::max(std::ceil(all / times.infeed_mm - 1e-9), 1.0);
    // a last step cut short still takes its dwells and strokes
    double limit_s = (steps + (sparksOut ? 1 : 0)) * times.least_s();
    if (project.gauge->control == Control::gauge && !project.gauge->position_mm) {
        double deepest = 0;
        const std::vector<double>& gauged =
            blank.depthAt(static_cast<std::size_t>(gaugeSection(project)));
        for (std::size_t k = 0; k < blank.depth_mm.size(); ++k) {
            deepest = blank.isGap(k) ? deepest : std::max(deepest, gauged[k]);
        }
        const double cell = (all - deepest) / stockCells;
        double sum_s = 0;
        for (int i = 1; i <= stockCells && cell > 0 && !stop.stop_requested(); ++i) {
            sum_s += cell / times.rate(left + 2 * stageSlack_mm + i * cell); // each cell adds to it
        }
        limit_s = std::max(limit_s, sum_s);
        if (all > deepest && countsPasses(project)) {
            const LeastPasses passes(project, times.infeed_mm, all - deepest,
                                     left + 2 * stageSlack_mm, stop);
            limit_s = std::max(limit_s, passes.count(stop).value_or(0) * times.least_s());
        }
    }
    return limit_s * (1 - 1e-9);
}

} // namespace

double steplessLimit_s(const Project& project, const std::stop_token& stop) {
    Project plain = project;
    plain.runs.clear();
    plain.batch.reset();
    const Variants variants(plain, stop);
    if (variants.isCutShort()) {
        return 0;
    }
    if (variants.count() == 0) {
        return limitOf(plain, false, stop);
    }
    std::vector<std::pair<MachineSettings, bool>> met; // the counts of spark-outs do not matter
    double least_s = std::numeric_limits<double>::infinity();
    for (std::size_t v = 0; v < variants.count(); ++v) {
        const Project& variant = variants.project(v);
        const std::pair each(machineSettings(variant), variants.grid(v).sparkOut() > 0);
        if (variants.grid(v).fault() == GridFault::none
            && std::find(met.begin(), met.end(), each) == met.end()) {
            met.push_back(each);
            least_s = std::min(least_s, limitOf(variant, each.second, stop));
        }
    }
    return least_s;
}

} // namespace sparkout
