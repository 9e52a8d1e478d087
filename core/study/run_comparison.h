// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/member.h"
#include "core/project/project.h"
#include "core/quality/run_summary.h"
#include "core/quality/verdict.h"
#include "core/simulation/feed_series.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <variant>
#include <vector>

/// Comparison of kept runs with each other and with the current run.

namespace sparkout {

/// A kept run recomputed by this version of the engine.
struct RecalledRun {
    Issues issues;                           ///< with errors it is not run
    std::optional<RunSummary> summary;       ///< empty: the inputs were refused
    std::shared_ptr<const FeedSeries> feeds; ///< null: not kept
};

/// Computes the run of inputs that are given as the text of a project. A stopped run gives an empty
/// value.
[[nodiscard]] RecalledRun recallRun(const std::string& inputs, const std::stop_token& stop);

/// Comparison of a kept run with the engine.
struct KeptRunCheck {
    std::string name;
    std::string engineVersion;               ///< engine that computed the kept run
    Issues issues;                           ///< errors of its inputs: it cannot be run
    bool isReadable = true;                  ///< its numbers can be read as a summary
    std::shared_ptr<const ReadSummary> kept; ///< the kept numbers, to which `changed` refers
    std::shared_ptr<const RunSummary> now;
    std::vector<ChangedValue> changed; ///< numbers that differ from the engine's

    [[nodiscard]] bool isTrue() const { return issues.empty() && isReadable && changed.empty(); }
};

/// Runs the inputs of a kept run again and compares its numbers with the result by changedSince().
/// A stopped check counts as equal.
[[nodiscard]] KeptRunCheck checkKeptRun(const KeptRun& run, const std::stop_token& stop = {});

/// Returns the checks of those kept runs of a project whose numbers differ from the engine's.
[[nodiscard]] std::vector<KeptRunCheck> untrueRuns(const Project& project,
                                                   const std::stop_token& stop = {});

/// Inputs and summary of a compared run, each null where it is unknown.
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

/// An input or a result of a run; a leaf belongs to its project or summary and is valid as long as
/// they are, a light is its verdict.
struct RunValue {
    std::string path; ///< "/wheel/width_mm", "/zones/0/roundness_um", "/requirements/burn/margin"
    std::variant<Leaf, StageCount, RequirementMargin, WorstMargin, Light> value;
};

/// An input or a result in which the runs differ.
struct ComparedRow {
    std::string path;
    bool isResult = false;
    std::vector<std::optional<RunValue>> runs; ///< by run; empty: the run does not have this value
};

/// Digits to which a result is stated: decimals, or significant digits where decimals are below 0.
struct ResultDigits {
    int decimals = -1;
    int significant = 3;
};
[[nodiscard]] ResultDigits digitsOf(const Field& result);
inline constexpr int worstDigits = 2; ///< significant digits of the worst margin in per cent

/// Returns the inputs that the model reads, in the order of the tables, without kept runs and
/// sweep.
[[nodiscard]] std::vector<RunValue> inputsRead(const Project& project);
std::vector<RunValue> inputsRead(Project&&) = delete; // its leaves would dangle

/// Returns the results in a summary in the order of its table, then its margins, the worst margin
/// and the verdict. Missing values are left out; where strips stay uncut, so are all values of the
/// surface. The inputs of the run, if given, decide which results are undecided.
[[nodiscard]] std::vector<RunValue> resultsStated(const ReadSummary& summary,
                                                  const Project* inputs = nullptr);
std::vector<RunValue> resultsStated(ReadSummary&&, const Project* inputs = nullptr) = delete;

/// Returns the inputs, then the results, in which the runs differ, in the order of the tables:
/// inputs in any digit, results in their stated digits. A value that only some runs have differs; a
/// run without inputs and summary differs in nothing.
[[nodiscard]] std::vector<ComparedRow> compareRuns(const std::vector<ComparedRun>& runs);

/// Converts a requirement of a summary to that of the verdict; empty if this version does not know
/// it. The summary has no bounds of the value: they follow from the inputs, if given.
[[nodiscard]] std::optional<ConstraintResult> constraintOf(const RequirementSummary& requirement,
                                                           bool isWhole = true,
                                                           const Project* inputs = nullptr);

/// Returns the requirement with the least relative margin of those whose margin is known; machine
/// ranges and the least number of steps, which may be used up to their ends, count only where they
/// fail. Empty if no margin is known.
[[nodiscard]] std::optional<ConstraintResult> leastMargin(const RunSummary& summary,
                                                          const Project* inputs = nullptr);
[[nodiscard]] std::optional<ConstraintResult>
leastMargin(std::span<const ConstraintResult> constraints);

/// Returns the verdict by a summary and, if given, the inputs of the run; empty if the summary
/// contains no requirement.
[[nodiscard]] std::optional<Light> verdictOf(const RunSummary& summary,
                                             const Project* inputs = nullptr);

/// Returns the largest difference of two lists of numbers; empty if their lengths differ.
[[nodiscard]] std::optional<double> largestDifference(const std::vector<double>& a,
                                                      const std::vector<double>& b);

/// A run and its summary, for drawing curves of one run over those of another.
struct RunPlaces {
    const Project& project;
    const RunSummary& summary;
};

/// Returns whether the zones or sections of two runs are the same.
[[nodiscard]] bool haveSamePlaces(const RunPlaces& a, const RunPlaces& b);

/// Returns the zone or section of another run that corresponds to one of this run: the same one if
/// both have the same, otherwise the nearest along the ground length, each as a share of it.
[[nodiscard]] std::size_t matchingPlace(const RunPlaces& run, std::size_t zone,
                                        const RunPlaces& other);

} // namespace sparkout
