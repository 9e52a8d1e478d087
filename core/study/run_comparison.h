// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/leaves.h"
#include "core/project/project.h"
#include "core/quality/light.h"
#include "core/quality/run_summary.h"

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

/// Kept runs held against each other and against the present one.
namespace sparkout {

/// A run that is compared: its inputs and its summary, each null where it is not known.
struct ComparedRun {
    const Project* inputs = nullptr;
    const ReadSummary* summary = nullptr;
};

/// Double strokes or revolutions of a stage, counted from 0.
struct StageCount {
    std::size_t stage = 0;
    double count = 0;
};

/// The margin of a requirement at its worst place.
struct RequirementMargin {
    ConstraintResult requirement;
};

/// The requirement with the least relative margin.
struct WorstMargin {
    ConstraintResult requirement;
};

/// An input or a result of a run; a leaf is one of its project or summary and valid as long as they
/// are, a light is its verdict.
struct RunValue {
    std::string path; ///< "/wheel/width_mm", "/zones/0/roundness_um", "/requirements/burn/margin"
    std::variant<Leaf, StageCount, RequirementMargin, WorstMargin, Light> value;
};

/// An input or a result in which the runs differ.
struct ComparedRow {
    std::string path;
    bool isResult = false;
    std::vector<std::optional<RunValue>> runs; ///< nothing: a run has no such value
};

/// The digits to which a result is stated: decimals, or where they are below 0 significant ones.
struct ResultDigits {
    int decimals = -1;
    int significant = 3;
};
[[nodiscard]] ResultDigits digitsOf(const Field& result);
inline constexpr int worstDigits = 2; ///< significant, of the worst margin in per cent

/// The inputs that the model reads, in the order of the tables; neither kept runs nor the sweep.
[[nodiscard]] std::vector<RunValue> inputsRead(const Project& project);
std::vector<RunValue> inputsRead(Project&&) = delete; // its leaves would be gone

/// What a summary says of a run, in the order of its table, then its margins, the worst of them and
/// the verdict. What is missing is left out; where strips stay uncut, all that is of the surface.
[[nodiscard]] std::vector<RunValue> resultsStated(const ReadSummary& summary);
std::vector<RunValue> resultsStated(ReadSummary&&) = delete;

/// The inputs, then the results, in which the runs differ, in the order of the tables: inputs in
/// any digit, results in those to which they are stated. A value that only some runs have differs;
/// a run of which nothing is known differs in nothing.
[[nodiscard]] std::vector<ComparedRow> compareRuns(const std::vector<ComparedRun>& runs);

/// A requirement of a summary as the verdict has it; nothing of one that this version does not
/// know.
[[nodiscard]] std::optional<ConstraintResult> constraintOf(const RequirementSummary& requirement,
                                                           bool isWhole = true);

/// The requirement with the least relative margin; of the machine's ranges and the least number of
/// steps, which hold up to their ends, of those alone that fail, and where strips stay uncut none
/// of the surface. Nothing where no requirement is known.
[[nodiscard]] std::optional<ConstraintResult> leastMargin(const RunSummary& summary);
[[nodiscard]] std::optional<ConstraintResult>
leastMargin(std::span<const ConstraintResult> constraints);

/// The verdict by a summary alone; none where it holds no requirement.
[[nodiscard]] std::optional<Light> verdictOf(const RunSummary& summary);

/// The largest difference of two lists of numbers; nothing where they are not as long.
[[nodiscard]] std::optional<double> largestDifference(const std::vector<double>& a,
                                                      const std::vector<double>& b);

/// A run and what came out, to lay the curves of one over those of another.
struct RunPlaces {
    const Project& project;
    const RunSummary& summary;
};

/// Whether the zones or sections of two runs are the same ones.
[[nodiscard]] bool haveSamePlaces(const RunPlaces& a, const RunPlaces& b);

/// The zone or section of another run that belongs to one of this: the same one where both have
/// the same, else the nearest along the ground length, each as a share of it.
[[nodiscard]] std::size_t matchingPlace(const RunPlaces& run, std::size_t zone,
                                        const RunPlaces& other);

} // namespace sparkout
