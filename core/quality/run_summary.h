// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/member.h"
#include "core/quality/constraints.h"
#include "core/simulation/result.h"

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

/// The results of a kept run. Members are named by their keys in the file and carry its units;
/// their rows give labels and units for display.
namespace sparkout {

/// Results of one zone or section at the end of the cycle.
struct ZoneSummary {
    std::string zone;                     ///< "rz1", "nz", "rz2" or "section"
    double position_mm = 0;               ///< middle, from the headstock end
    double diameter_deviation_min_um = 0; ///< smallest diameter less the nominal one
    double diameter_deviation_max_um = 0; ///< largest diameter less the nominal one
    double radial_runout_um = 0;
    double roundness_um = 0; ///< by the minimum zone
    double peak_normal_force_n = 0;
    std::vector<double> radii_um; ///< less the nominal radius
};

/// A requirement at its worst place.
struct RequirementSummary {
    std::string name;  ///< Requirement::key
    std::string where; ///< "rz1", "section 2" (from 0), "part", "stage 2", "cycle"
    double limit = 0;
    double value = 0;
    double margin = 0; ///< in the unit of the requirement
    double relative_margin = 0;
    bool ok = false;
};

struct RunSummary {
    RunStatus status = RunStatus::completed;
    double cycle_time_min = 0;
    int count = 0;                       ///< double strokes or revolutions
    std::vector<double> counts_by_stage; ///< the counts by stage
    std::vector<ZoneSummary> zones;      ///< or the sections from the headstock end
    double cylindricity_um = 0;
    double total_runout_um = 0;
    double peak_normal_force_n = 0;
    double peak_power_w = 0;
    std::vector<RequirementSummary> requirements; ///< in the order of their kinds
};

[[nodiscard]] RunSummary summarise(const SimulationResult& result, const PartAccuracy& accuracy,
                                   const std::vector<ConstraintResult>& constraints);

/// A run to be kept: its inputs and its summary.
[[nodiscard]] KeptRun keptRun(const SimulationResult& result, const RunSummary& summary,
                              std::string name, std::string when);

/// A summary read from a file. Values not written by another version are missing; its additional
/// values are ignored.
struct ReadSummary {
    RunSummary summary;
    std::set<std::string> missing; ///< paths of values, "/zones/0/roundness_um"
};

/// Empty if the text is not a summary.
[[nodiscard]] std::optional<ReadSummary> readSummary(std::string_view text);

/// Equal radii and deviations of two runs: the last bits of cos and exp differ between processors.
inline constexpr double sameRadius_um = 1e-6;

/// A value that differs between two summaries, which must outlive it.
struct ChangedValue {
    std::string path; ///< "/zones/0/roundness_um"; of a requirement "/requirements/burn/margin"
    Leaf kept;
    std::optional<Leaf> now; ///< empty: the value no longer exists
};

/// The differences of a repeated run from the kept one: counts exactly, radii and deviations within
/// sameRadius_um, other numbers to a millionth of them, or of one.
[[nodiscard]] std::vector<ChangedValue> changedSince(const ReadSummary& kept,
                                                     const RunSummary& now);

template <>
std::span<const Choice> choicesOf<RunStatus>();
template <>
const StructInfo& tableOf<ZoneSummary>();
template <>
const StructInfo& tableOf<RequirementSummary>();
template <>
const StructInfo& tableOf<RunSummary>();

} // namespace sparkout
