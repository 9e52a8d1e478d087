// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/variants.h"
#include "tests/whole_project.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

/// The cycles of a grid by the definition of the project file, written a second time.
namespace sparkout::plain_grid {

/// A cycle of a grid and the machine it is run with.
struct PlainCycle {
    MachineSettings machine;
    Cycle cycle;
};

/// The cycles of a grid in its order, as the page of the project file tells them.
class PlainGrid {
public:
    explicit PlainGrid(const Project& project) : p(project), asked(*project.optimisation) {
        const Machine& own = *p.machine;
        const bool traverse = p.operation == Operation::traverse;
        for (const double speed : listed(asked.work_speed_rpm, own.work_speed_rpm)) {
            if (isLeftOut(speed)) {
                continue;
            }
            for (const double entry :
                 listed(traverse ? asked.dwell_entry_s : Levels(), own.dwell_entry_s)) {
                for (const double exit :
                     listed(traverse ? asked.dwell_exit_s : Levels(), own.dwell_exit_s)) {
                    for (const double sparkOut : listed(asked.unfed_steps, 0)) {
                        machine = {speed, entry, exit};
                        sparks = static_cast<int>(sparkOut);
                        addNumbers();
                    }
                }
            }
        }
    }

    std::vector<PlainCycle> cycles;

private:
    static std::vector<double> listed(const Levels& levels, double own) {
        const std::vector<double> values = levelValues(levels);
        return values.empty() ? std::vector<double>{own} : values;
    }

    /// The wheel turns nearly k times, k = 1, 2, …, while the work turns once.
    bool isLeftOut(double speed) const {
        const double wheel =
            60'000 * p.machine->wheel_speed_m_s / (std::numbers::pi * p.wheel->diameter_mm);
        for (int k = 1; asked.least_ratio_distance && k <= wheel / speed + 1; ++k) {
            if (std::abs(wheel / speed - k) < *asked.least_ratio_distance) {
                return true;
            }
        }
        return false;
    }

    void addNumbers() {
        for (std::size_t i = 0; i < asked.stages.size(); ++i) {
            bool before = false;
            for (std::size_t j = 0; j < i; ++j) {
                before = before || asked.stages[j] == asked.stages[i];
            }
            if (!before) {
                feeding = static_cast<std::size_t>(asked.stages[i]);
                addStage({}, p.part->stock_mm);
            }
        }
    }

    static bool within(const NumberRows& rows, std::size_t z, double value) {
        return !rows || z >= rows->size()
               || (value > (*rows)[z][0] - 1e-9 && value < (*rows)[z][1] + 1e-9);
    }

    void addStage(const Cycle& begun, double left_mm) {
        const std::size_t z = begun.stages.size();
        if (z == feeding + (sparks > 0 ? 1 : 0)) {
            const double last = begun.stages.back().stock_mm;
            const auto& bounds = asked.last_stock_mm;
            const bool bounded = bounds && z > 1;
            if ((!bounded || (last > bounds->front() - 1e-9 && last < bounds->back() + 1e-9))
                && within(asked.stage_stock_mm, z - 1, last)) {
                cycles.push_back({machine, begun});
            }
            return;
        }
        const bool traverse = p.operation == Operation::traverse;
        const std::vector<double> radial =
            z == feeding ? std::vector<double>{0}
                         : levelValues(traverse ? asked.radial_feed_mm : asked.radial_feed_mm_min);
        const std::vector<double> axial =
            traverse ? levelValues(asked.axial_feed_mm_min) : std::vector<double>{0};
        for (const double radialFeed : radial) {
            for (const double axialFeed : axial) {
                Stage stage;
                if (z == feeding) {
                    stage.spark_out = {SparkOut::Mode::count, sparks};
                } else {
                    (traverse ? stage.radial_feed_mm : stage.radial_feed_mm_min) = radialFeed;
                }
                addOf(begun, stage, axialFeed, left_mm);
            }
        }
        for (const double continuous : traverse&& z < feeding
                                           ? levelValues(asked.continuous_feed_mm_min)
                                           : std::vector<double>{}) {
            for (const double axialFeed : axial) {
                Stage stage;
                stage.radial_feed_mm = 0;
                stage.continuous_feed_mm_min = continuous;
                addOf(begun, stage, axialFeed, left_mm);
            }
        }
    }

    void addOf(const Cycle& begun, Stage stage, double axialFeed, double left_mm) {
        if (p.operation == Operation::traverse) {
            stage.axial_feed_mm_min = axialFeed;
        }
        if (mayFollow(begun, stage)) {
            addStocks(begun, stage, left_mm);
        }
    }

    bool mayFollow(const Cycle& begun, const Stage& stage) const {
        const std::size_t z = begun.stages.size();
        const bool sparksOut = stage.spark_out.mode != SparkOut::Mode::none;
        const double continuous = stage.continuous_feed_mm_min.value_or(0);
        const bool fits =
            (!stage.radial_feed_mm || continuous > 0
             || within(asked.stage_radial_feed_mm, z, *stage.radial_feed_mm))
            && (continuous == 0 || within(asked.stage_continuous_feed_mm_min, z, continuous))
            && (!stage.radial_feed_mm_min
                || within(asked.stage_radial_feed_mm_min, z, *stage.radial_feed_mm_min))
            && (!stage.axial_feed_mm_min
                || within(asked.stage_axial_feed_mm_min, z, *stage.axial_feed_mm_min));
        if (!fits || z == 0 || !asked.non_increasing) {
            return fits;
        }
        const Stage& before = begun.stages.back();
        return stage.axial_feed_mm_min <= before.axial_feed_mm_min
               && continuous <= before.continuous_feed_mm_min.value_or(0)
               && (sparksOut
                   || (stage.radial_feed_mm <= before.radial_feed_mm
                       && stage.radial_feed_mm_min <= before.radial_feed_mm_min));
    }

    void addStocks(const Cycle& begun, Stage stage, double left_mm) {
        const std::size_t z = begun.stages.size();
        const double step = asked.stock_step_mm;
        if (z + 1 == feeding + (sparks > 0 ? 1 : 0)) {
            addTo(begun, stage, left_mm, left_mm);
            return;
        }
        for (int k = 1; (k - 1) * step < left_mm - 1e-9; ++k) {
            const double stock = std::min(k * step, left_mm);
            const bool all = stock > left_mm - 1e-9, part = stock < k * step - 1e-9;
            const bool mayTakeAll =
                z + 1 == feeding && sparks > 0 && !(part && asked.stage_stock_mm);
            if ((!all || mayTakeAll)
                && (z + 1 == feeding + (sparks > 0 ? 1 : 0)
                    || within(asked.stage_stock_mm, z, k * step))) {
                addTo(begun, stage, stock, left_mm);
            }
        }
    }

    void addTo(Cycle cycle, Stage stage, double stock_mm, double left_mm) {
        stage.stock_mm = asWritten(stock_mm);
        cycle.stages.push_back(stage);
        addStage(cycle, std::max(asWritten(left_mm - stock_mm), 0.0));
    }

    const Project& p;
    const Optimisation& asked;
    MachineSettings machine;
    int sparks = 0;
    std::size_t feeding = 0; ///< number of stages that feed
};

inline bool sameCycle(const Cycle& a, const Cycle& b) {
    return std::equal(a.stages.begin(), a.stages.end(), b.stages.begin(), b.stages.end(),
                      [](const Stage& x, const Stage& y) {
                          return x.radial_feed_mm == y.radial_feed_mm
                                 && x.radial_feed_mm_min == y.radial_feed_mm_min
                                 && x.axial_feed_mm_min == y.axial_feed_mm_min
                                 && x.continuous_feed_mm_min == y.continuous_feed_mm_min
                                 && x.spark_out == y.spark_out
                                 && std::abs(x.stock_mm - y.stock_mm) < 1e-12;
                      });
}

} // namespace sparkout::plain_grid
