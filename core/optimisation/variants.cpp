// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/optimisation/variants.h"

#include <algorithm>
#include <array>
#include <limits>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

std::vector<double> listed(const Levels& levels, double own) {
    std::vector<double> values = levelValues(levels);
    return values.empty() ? std::vector<double>{own} : values;
}

Levels only(double value) {
    return std::vector<double>{value};
}

} // namespace

MachineSettings machineSettings(const Project& project) {
    return {project.machine.work_speed_rpm, project.machine.dwell_entry_s,
            project.machine.dwell_exit_s};
}

void setMachine(Project& project, const MachineSettings& settings) {
    project.machine.work_speed_rpm = settings.work_speed_rpm;
    project.machine.dwell_entry_s = settings.dwell_entry_s;
    project.machine.dwell_exit_s = settings.dwell_exit_s;
}

Variants::Variants(const Project& project) {
    Project plain = project;
    plain.runs.clear();
    if (!project.optimisation) {
        m_fault = GridFault::notGiven;
        return;
    }
    Optimisation& asked = *plain.optimisation;
    if (project.operation == Operation::plunge) {
        asked.dwell_entry_s = asked.dwell_exit_s = {};
    }
    const auto number = [](const Levels& levels) { return std::max(levelCount(levels), 1.0); };
    if (number(asked.work_speed_rpm) * number(asked.dwell_entry_s) * number(asked.dwell_exit_s)
            * number(asked.spark_out)
        > mostVariants) {
        m_fault = GridFault::tooManyVariants;
        return;
    }
    const MachineSettings own = machineSettings(project);
    const std::vector<double> speeds = listed(asked.work_speed_rpm, own.work_speed_rpm),
                              entries = listed(asked.dwell_entry_s, own.dwell_entry_s),
                              exits = listed(asked.dwell_exit_s, own.dwell_exit_s),
                              sparkOuts = listed(asked.spark_out, 0);
    for (const double speed : speeds) {
        for (const double entry : entries) {
            for (const double exit : exits) {
                for (const double sparkOut : sparkOuts) {
                    setMachine(plain, {speed, entry, exit});
                    asked.work_speed_rpm = only(speed);
                    asked.dwell_entry_s = only(entry);
                    asked.dwell_exit_s = only(exit);
                    asked.spark_out = only(sparkOut);
                    m_variants.emplace_back(plain);
                }
            }
        }
    }
    const bool any = std::any_of(m_variants.begin(), m_variants.end(), [](const Variant& each) {
        return each.grid.fault() == GridFault::none;
    });
    if (!any) {
        m_fault = m_variants.front().grid.fault();
        m_variants.clear();
    }
}

bool Variants::differInOne(std::size_t a, std::size_t b) const {
    const MachineSettings x = machineSettings(project(a)), y = machineSettings(project(b));
    const int differences = static_cast<int>(x.work_speed_rpm != y.work_speed_rpm)
                            + static_cast<int>(x.dwell_entry_s != y.dwell_entry_s)
                            + static_cast<int>(x.dwell_exit_s != y.dwell_exit_s)
                            + static_cast<int>(grid(a).sparkOut() != grid(b).sparkOut());
    return differences == 1;
}

// Of the cycles of a variant only whether they spark out counts for their number.
std::int64_t Variants::size() const {
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    std::array<std::optional<std::int64_t>, 2> sizes;
    std::int64_t sum = 0;
    for (const Variant& each : m_variants) {
        if (each.grid.fault() != GridFault::none) {
            continue;
        }
        std::optional<std::int64_t>& size = sizes[each.grid.sparkOut() > 0 ? 1 : 0];
        size = size ? size : each.grid.size();
        sum = *size > most - sum ? most : sum + *size;
    }
    return sum;
}

std::int64_t gridSize(const Project& project) {
    return Variants(project).size();
}

} // namespace sparkout
