// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/form/accuracy.h"
#include "core/limits/formula.h"
#include "core/simulation/result.h"

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

/// What a cycle is held against: one row for each requirement, read by everything that evaluates,
/// shows, counts or searches.
namespace sparkout {

enum class ConstraintKind {
    diameterMin,
    diameterMax,
    radialRunout,
    roundness,
    cylindricity,
    totalRunout,
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

/// What a requirement is held against.
enum class ConstraintScope {
    section, ///< each zone or section at the end of the cycle
    part,    ///< the whole part at the end of the cycle
    pass,    ///< every pass; kept is the worst
    setting, ///< the settings of the machine and its cycle, for a stage or for all
};

/// Where a limit comes from.
enum class LimitSource {
    input, ///< the first of the row's inputs, in the row's unit
    range, ///< the nearer end of the machine's range, the row's first input
    model, ///< the model, from the row's inputs
};

/// Numbers of a requirement, as printed by the command line and as shown in the window.
struct RequirementDigits {
    static constexpr int significant = -1;
    int printed = 3;         ///< decimals
    int shown = significant; ///< decimals, or the significant digits of any value
};

/// A cycle that ran, held against a requirement, with as much of its accuracy as is required.
struct Judged {
    const SimulationResult& result;
    const PartAccuracy& accuracy;
    int section = -1; ///< the one that is judged; −1: not of one section
};

struct ConstraintResult;
using ConstraintResults = std::vector<ConstraintResult>;

/// What a search may compare before a cycle has ended: a peak of its passes, which only grows.
struct PassBound {
    enum class Peak { depth_mm, power_w };
    Peak peak;
    double most = 0;
};

struct Requirement {
    static constexpr std::size_t mostInputs = 4;
    using Paths = std::array<const char*, mostInputs>; ///< of inputs; null: no more

    ConstraintKind kind;
    const char* key; ///< in files and on the command line
    // Texts: translated in the context "Requirement", `brief` in "RequirementBrief".
    const char* label;
    const char* brief;                ///< for one line of a narrow table
    const char* limitName = nullptr;  ///< of its limit of the depth of cut: "burn"
    const char* measuredBy = nullptr; ///< the reference of a deviation of form
    const char* broken = nullptr;     ///< sentence of %1 where, %2 by how much and %3 the value
    const char* unit = "";            ///< of limit, value and margin; none for a plain number
    const char* unitInFull = nullptr; ///< for a reader who does not know the requirement
    RequirementDigits digits = {};
    bool isDeviation = false; ///< of a diameter: limit and value are shown with their sign
    bool isLeast = false;     ///< the limit is the least that holds; of a range either end may be

    ConstraintScope scope;
    LimitSource source;
    Paths inputs = {};                    ///< that the limit rests on; it is on where all are given
    const char* setting = nullptr;        ///< path of the setting that is held against it
    const char* settingOfStage = nullptr; ///< key of that setting of a stage
    bool sharedBySections = false;        ///< coupled sections have one limit together
    Paths estimates = {};                 ///< inputs behind its value without a public source
    bool isCapable = false;               ///< a batch states capability of it

    /// Appends the results: of a section, where the scope is one; else of all.
    void (*evaluate)(ConstraintKind kind, const Judged& of, ConstraintResults& found);
    /// How the number of its worst place came about; null: it is read off.
    std::optional<FormulaSheet> (*sheet)(const Judged& of) = nullptr;
    /// The greatest depth of cut [mm] that it allows a pass of the effective width b [mm] with this
    /// stock left [mm], 0: not met at any depth; nothing: off. Null: it limits no pass.
    std::optional<double> (*depthLimit)(const Project& project, double b, double stock) = nullptr;
    /// Null: a search knows it at the end alone; nothing: off.
    std::optional<PassBound> (*passBound)(const Project& project) = nullptr;

    /// Whether it limits the depth of every pass; else of the last cut alone, or of none.
    [[nodiscard]] constexpr bool bindsEveryPass() const {
        return depthLimit && scope == ConstraintScope::pass;
    }
    /// Whether it is about the finished surface.
    [[nodiscard]] constexpr bool isOfSurface() const {
        return scope == ConstraintScope::section || scope == ConstraintScope::part;
    }
};

/// In the order of the kinds.
extern const std::array<Requirement, constraintKinds> requirementRows;

[[nodiscard]] inline const Requirement& requirementOf(ConstraintKind kind) {
    return requirementRows[static_cast<std::size_t>(kind)];
}

/// The one of a key; null: none.
[[nodiscard]] const Requirement* requirementNamed(std::string_view key);

/// Whether any of its inputs is given; one without inputs always is asked for.
[[nodiscard]] bool isAskedFor(const Requirement& row, const Project& project);

/// The first of its inputs that is not given; empty: it is on.
[[nodiscard]] std::string missingInput(const Requirement& row, const Project& project);

/// The limit of a requirement whose source is an input, where it is on.
[[nodiscard]] std::optional<double> statedLimit(const Requirement& row, const Project& project);

} // namespace sparkout
