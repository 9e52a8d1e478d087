// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace sparkout {

/// The possible values of a setting, in order: each has a whole number, its place.
class SettingScale {
public:
    /// base + k·step.
    [[nodiscard]] static SettingScale steps(double base, double step);
    /// Positive numbers as people enter them: with two significant digits, three if the first one
    /// is 1, so that a step is at most a twentieth.
    [[nodiscard]] static SettingScale digits();
    /// Times of k whole revolutions [s], with three decimals.
    [[nodiscard]] static SettingScale revolutions(double speed_rpm);

    [[nodiscard]] double at(std::int64_t place) const;
    /// The last place with a value below, and the first with a value above. Values that differ by
    /// rounding count as equal.
    [[nodiscard]] std::int64_t lastBelow(double value) const;
    [[nodiscard]] std::int64_t firstAbove(double value) const;
    /// The last place with a value up to this one, and the first from it on.
    [[nodiscard]] std::int64_t lastUpTo(double value) const { return firstAbove(value) - 1; }
    [[nodiscard]] std::int64_t firstFrom(double value) const { return lastBelow(value) + 1; }

private:
    enum class Kind { steps, digits, revolutions };
    SettingScale(Kind kind, double base, double step) : m_kind(kind), m_base(base), m_step(step) {}

    [[nodiscard]] std::int64_t about(double value) const;

    Kind m_kind;
    double m_base, m_step;
};

/// A change made by a remedy: one setting, or several where none helps alone.
enum class RemedyKind {
    radialFeed, ///< feed of a feeding stage
    axialFeed,  ///< feed of a stage
    stock,      ///< stock of a stage; its neighbour takes the difference
    sparkOut,   ///< double strokes or revolutions of the last stage
    dwellEntry, ///< whole revolutions
    dwellExit,  ///< whole revolutions
    workSpeed,
    plungeFeed,     ///< at the reversal
    targetDiameter, ///< that the gauge is set to, within the field
    addFeed, ///< an additional stage after the last feeding one, with half of its stock: its feed
    addSparkOut,   ///< an additional spark-out at the end: its double strokes or revolutions
    stockWithFeed, ///< of the finishing stage, with another feed of the first
    startingCycle, ///< all stages, work speed, overruns and dwells: withStartingCycle()
};
/// The key in files: "setting", "pair", "starting_cycle".
[[nodiscard]] const char* remedyKindKey(RemedyKind kind);

/// A setting of a project and its possible values: within the allowed and usual range, and
/// adjustable on the machine. A starting cycle has one value.
struct RemedySetting {
    RemedyKind kind;
    std::size_t stage = 0; ///< changed stage, or the one before an added stage; from 0
    std::size_t other = 0; ///< stage that takes the difference of the stock
    double before = 0;     ///< current value; for an additional stage that without effect
    double low = 0, high = 0;
    SettingScale scale;
    double feed = 0, feedBefore = 0; ///< for a pair: that of the first stage
    /// For a starting cycle: the project with it, once made.
    std::shared_ptr<const Project> made{};

    /// The project with only this value changed.
    [[nodiscard]] Project applied(Project project, double value) const;
    /// Makes a starting cycle for the project, which stays the same for all parts of the batch and
    /// for an unworn wheel.
    void make(const Project& project);
    /// The changed input, "/cycle/stages/1/radial_feed_mm"; for an additional stage that stage, for
    /// a starting cycle its first stage.
    [[nodiscard]] std::string path(const Project& project) const;
    /// The path of an input of the unchanged project, whose row has label, symbol and unit.
    [[nodiscard]] std::string rowPath(const Project& project) const;
    /// The path of an input of the unchanged project after applying the setting.
    [[nodiscard]] std::string pathAfter(const std::string& path) const;
    [[nodiscard]] bool addsStage() const {
        return kind == RemedyKind::addFeed || kind == RemedyKind::addSparkOut;
    }
    /// Whether its value is a number of double strokes or revolutions.
    [[nodiscard]] bool isCount() const {
        return kind == RemedyKind::sparkOut || kind == RemedyKind::addSparkOut;
    }
    /// Whether nothing else changes.
    [[nodiscard]] bool isSingle() const { return !isPair() && !isWholeCycle(); }
    [[nodiscard]] bool isPair() const { return kind == RemedyKind::stockWithFeed; }
    [[nodiscard]] bool isWholeCycle() const { return kind == RemedyKind::startingCycle; }
    /// Least number of values of an offered interval.
    [[nodiscard]] int leastValues() const { return isCount() || isWholeCycle() ? 1 : 3; }
    [[nodiscard]] bool isDwell() const {
        return kind == RemedyKind::dwellEntry || kind == RemedyKind::dwellExit;
    }
};

/// All settings of a valid project that a remedy may change: a starting cycle, the single settings,
/// those of finishing stages first, and pairs.
[[nodiscard]] std::vector<RemedySetting> remedySettings(const Project& project);

} // namespace sparkout
