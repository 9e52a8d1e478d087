// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"
#include "core/simulation/result.h"
#include "core/surface/accuracy.h"
#include "core/surface/formula.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// The requirements on a cycle: one row for each, used for evaluation, display, counting and
/// search.
namespace sparkout {

enum class ConstraintKind {
    diameterMin,
    diameterMax,
    radialRunout,
    roundness,
    cylindricity,
    totalRunout,
    waviness,
    roughness,
    burn,
    selfSharpening,
    wheelPower,
    workPower,
    rangeRadialFeed,
    rangeAxialFeed,
    rangePlungeFeed,
    rangeContinuousFeed,
    rangeWorkSpeed,
    gaugeCommands,
    overlap,
    leastOverlap,
    leastOverlapLast,
    leastSteps,
    count_
};
inline constexpr int constraintKinds = static_cast<int>(ConstraintKind::count_);

/// The scope of a requirement.
enum class ConstraintScope {
    section, ///< each zone or section at the end of the cycle
    part,    ///< the whole part at the end of the cycle
    pass,    ///< every pass; the worst one is kept
    setting, ///< the settings of the machine and the cycle, of one stage or all
};

/// The origin of a limit.
enum class LimitSource {
    input, ///< first input of the row, in the row's unit
    range, ///< nearer end of the machine's range, the row's first input
    model, ///< the model, from the row's inputs
};

/// Numbers of a requirement, as printed by the command line and as shown in the window.
struct RequirementDigits {
    static constexpr int significant = -1;
    int printed = 3;         ///< decimals
    int shown = significant; ///< decimals, or the significant digits of any value
};

/// A completed cycle with the part of its accuracy that the requirements need.
struct Judged {
    const SimulationResult& result;
    const PartAccuracy& accuracy;
    int section = -1; ///< the one that is judged; −1: not of one section
};

struct ConstraintResult;
using ConstraintResults = std::vector<ConstraintResult>;

/// A value that a search may compare before a cycle has ended: a peak of the passes, which only
/// grows.
struct PassBound {
    enum class Peak { depth_mm, power_w };
    Peak peak;
    double most = 0;
};

struct Requirement {
    static constexpr std::size_t mostInputs = 4;
    using Paths = std::array<const char*, mostInputs>; ///< paths of inputs; null after the last

    ConstraintKind kind;
    const char* key; ///< key in files and on the command line
    // Texts: translated in the context "Requirement", `brief` in "RequirementBrief".
    const char* label;
    const char* brief;                ///< short label for a narrow table
    const char* limitName = nullptr;  ///< name of its limit of the depth of cut: "burn"
    const char* measuredBy = nullptr; ///< the reference of a deviation of form
    const char* broken = nullptr; ///< sentence with %1 the place, %2 the excess and %3 the value
    const char* unit = "";        ///< of limit, value and margin; none for a plain number
    const char* unitInFull = nullptr; ///< unit with explanation
    RequirementDigits digits = {};
    bool isDeviation = false; ///< deviation of a diameter: limit and value have a sign
    bool isLeast = false;     ///< the limit is a minimum; a range has both

    ConstraintScope scope;
    LimitSource source;
    Paths inputs = {};             ///< inputs that the limit needs; it is on if all are given
    const char* setting = nullptr; ///< path of the limited setting
    const char* settingOfStage = nullptr; ///< key of that setting of a stage
    bool sharedBySections = false;        ///< coupled sections have a common limit
    Paths estimates = {};                 ///< inputs behind its value without a public source
    bool isCapable = false;               ///< a batch reports its capability

    /// Appends the results: of one section if that is the scope, otherwise of all.
    void (*evaluate)(ConstraintKind kind, const Judged& of, ConstraintResults& found);
    /// The calculation of the value at its worst place; null if it is read off.
    std::optional<FormulaSheet> (*sheet)(const Judged& of) = nullptr;
    /// The greatest depth of cut [mm] allowed in a pass of the effective width b [mm] with this
    /// stock left [mm]; 0: not met at any depth; empty: off. Null: it limits no pass.
    std::optional<double> (*depthLimit)(const Project& project, double b, double stock) = nullptr;
    /// Null: known only at the end of a cycle; empty: off.
    std::optional<PassBound> (*passBound)(const Project& project) = nullptr;

    /// Whether it limits the depth of every pass; otherwise of the last cut alone, or of none.
    [[nodiscard]] constexpr bool bindsEveryPass() const {
        return depthLimit && scope == ConstraintScope::pass;
    }
    /// Whether it is about the finished surface.
    [[nodiscard]] constexpr bool isOfSurface() const {
        return scope == ConstraintScope::section || scope == ConstraintScope::part;
    }
};

/// The requirements in the order of their kinds.
extern const std::array<Requirement, constraintKinds> requirementRows;

[[nodiscard]] inline const Requirement& requirementOf(ConstraintKind kind) {
    return requirementRows[static_cast<std::size_t>(kind)];
}

/// The requirement with a key; null if there is none.
[[nodiscard]] const Requirement* requirementNamed(std::string_view key);

/// Whether any of its inputs is given; true if it has no inputs.
[[nodiscard]] bool isAskedFor(const Requirement& row, const Project& project);

/// The first of its inputs that is not given; empty if it is on.
[[nodiscard]] std::string missingInput(const Requirement& row, const Project& project);

/// The limit of a requirement whose source is an input, if it is on.
[[nodiscard]] std::optional<double> statedLimit(const Requirement& row, const Project& project);

/// The inputs behind a requirement's value that have no public source: estimates of the shop, to be
/// calibrated at the machine. Empty for a setting. Whether the project's values are measured does
/// not matter here.
[[nodiscard]] std::vector<const Field*> estimatesBehind(const Project& project,
                                                        ConstraintKind kind);

} // namespace sparkout
