// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/grid.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>
#include <vector>

namespace sparkout {

/// Machine settings that a grid may leave free, one value for the whole cycle.
struct MachineSettings {
    double work_speed_rpm = 0; ///< n [rev/min]
    double dwell_entry_s = 0;  ///< traverse [s]
    double dwell_exit_s = 0;   ///< traverse [s]
    int radii = 0; ///< K of the project before another work speed, with a wheel out of true
    friend bool operator==(const MachineSettings&, const MachineSettings&) = default;
};
[[nodiscard]] MachineSettings machineSettings(const Project& project);
void setMachine(Project& project, const MachineSettings& settings);

/// The work speeds of a search [rev/min]: those that it lists, or the machine's.
struct SearchedSpeeds {
    std::vector<double> allowed;
    std::vector<double> leftOut; ///< n_k/n is nearer to a whole number than leastRatioDistance()
};
/// The least distance of n_k/n from a whole number that a search allows: that of the project. Where
/// it states none and no runout of the wheel, a search that may choose the work speed takes
/// nearRatio, since the waves that a wheel would print are not known. Empty: any. The project must
/// have a search.
[[nodiscard]] std::optional<double> leastRatioDistance(const Project& project);
/// The project must have a search. By default, where every speed is too near, none is left out.
[[nodiscard]] SearchedSpeeds searchedSpeeds(const Project& project);
/// The work speed nearest to the end of a range, beyond a level of the search, that the machine can
/// be set to and leastRatioDistance() allows [rev/min]; the level where there is none.
[[nodiscard]] double farthestSpeed_rpm(const Project& project, double level_rpm, double end_rpm);

/// All grids of a project's optimisation: one for each combination of allowed work speed, entry
/// dwell, exit dwell and spark-out count as listed. In the order of the variants the spark-outs
/// change first and the work speed last; the order of variants precedes the grid order of the
/// cycles of one variant. An unlisted setting has the machine's value, an unlisted spark-out count
/// means none.
class Variants {
public:
    /// With a fault there are no variants. A stop may leave some out.
    explicit Variants(const Project& project, const std::stop_token& stop = {});

    /// Returns the fault of the first variant if all variants have one; otherwise none.
    [[nodiscard]] GridFault fault() const { return m_fault; }
    [[nodiscard]] std::size_t count() const { return m_variants.size(); }
    /// Returns whether a stop left variants out.
    [[nodiscard]] bool isCutShort() const { return m_isCutShort; }
    /// Returns the project with the variant's machine settings, whose optimisation lists this
    /// variant alone.
    [[nodiscard]] const Project& project(std::size_t variant) const {
        return m_variants[variant].project;
    }
    [[nodiscard]] const Grid& grid(std::size_t variant) const { return *m_variants[variant].grid; }
    /// Returns whether two variants differ in exactly one setting.
    [[nodiscard]] bool differInOne(std::size_t a, std::size_t b) const;
    /// Number of cycles of all variants, at most 2^63 − 1.
    [[nodiscard]] std::int64_t size() const;

private:
    /// The machine settings do not affect the grid: variants with one spark-out count share it.
    struct Variant {
        Project project;
        std::shared_ptr<const Grid> grid;
    };
    std::vector<Variant> m_variants;
    GridFault m_fault = GridFault::none;
    bool m_isCutShort = false;
};

/// Returns the number of cycles of a project's optimisation without making the variants.
[[nodiscard]] std::int64_t gridSize(const Project& project);

} // namespace sparkout
