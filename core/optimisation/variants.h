// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/grid.h"

#include <cstdint>
#include <memory>
#include <stop_token>
#include <utility>
#include <vector>

namespace sparkout {

/// What of the machine a grid may leave free, one value for the whole cycle.
struct MachineSettings {
    double work_speed_rpm = 0; ///< n [rev/min]
    double dwell_entry_s = 0;  ///< traverse [s]
    double dwell_exit_s = 0;   ///< traverse [s]
    friend bool operator==(const MachineSettings&, const MachineSettings&) = default;
};
[[nodiscard]] MachineSettings machineSettings(const Project& project);
void setMachine(Project& project, const MachineSettings& settings);

/// The whole of what a project's optimisation asks for: a grid of cycles for each work speed, entry
/// dwell, exit dwell and count of spark-outs, as listed, the work speed changing last of all and
/// the spark-outs first. That is their order, before the grid order of the cycles of one variant.
/// What is not listed is as the machine is set, with no spark-out.
class Variants {
public:
    /// With a fault there are none. A stop may leave some out.
    explicit Variants(const Project& project, const std::stop_token& stop = {});

    /// Of the first variant, where all have one; else none.
    [[nodiscard]] GridFault fault() const { return m_fault; }
    [[nodiscard]] std::size_t count() const { return m_variants.size(); }
    /// Not all are there, as they were stopped being made.
    [[nodiscard]] bool isCutShort() const { return m_isCutShort; }
    /// The project with the variant's machine, whose optimisation lists this variant alone.
    [[nodiscard]] const Project& project(std::size_t variant) const {
        return m_variants[variant].project;
    }
    [[nodiscard]] const Grid& grid(std::size_t variant) const { return *m_variants[variant].grid; }
    /// Whether two variants differ in one thing alone.
    [[nodiscard]] bool differInOne(std::size_t a, std::size_t b) const;
    /// The number of cycles of all, 2^63 − 1 when there are more.
    [[nodiscard]] std::int64_t size() const;

private:
    /// The machine leaves the grid as it is: variants of one count of spark-outs share it.
    struct Variant {
        Project project;
        std::shared_ptr<const Grid> grid;
    };
    std::vector<Variant> m_variants;
    GridFault m_fault = GridFault::none;
    bool m_isCutShort = false;
};

/// The number of cycles that a project's optimisation asks for, without making the variants.
[[nodiscard]] std::int64_t gridSize(const Project& project);

} // namespace sparkout
