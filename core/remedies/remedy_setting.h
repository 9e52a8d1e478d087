// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/remedies/setting_scale.h"

#include <cstddef>
#include <memory>
#include <string>
#include <vector>

namespace sparkout {

/// What a remedy may change: one setting, or more where none alone may do.
enum class RemedyKind {
    radialFeed, ///< of a stage that feeds
    axialFeed,  ///< of a stage
    stock,      ///< of a stage, its neighbour has the difference
    sparkOut,   ///< double strokes or revolutions of the last stage
    dwellEntry, ///< whole revolutions
    dwellExit,  ///< whole revolutions
    workSpeed,
    plungeFeed,    ///< at the reversal
    addFeed,       ///< a stage more behind the last that feeds, with half of its stock: its feed
    addSparkOut,   ///< a spark-out more behind all: its double strokes or revolutions
    stockWithFeed, ///< of the finishing stage, with another feed of the first
    startingCycle, ///< all stages, work speed, overruns and dwells: withStartingCycle()
};
/// Its name in files: "setting", "pair", "starting_cycle".
[[nodiscard]] const char* remedyKindKey(RemedyKind kind);

/// One setting of a project, and the values it may be given: within what the project file allows
/// and what is usual, and what the machine can be set to. Of a starting cycle the one value says
/// that it is taken.
struct RemedySetting {
    RemedyKind kind;
    std::size_t stage = 0; ///< that is changed, or behind which one is added; from 0
    std::size_t other = 0; ///< whose stock makes up for that of the stage
    double before = 0;     ///< the value there is; of a stage more the one with which all stays
    double low = 0, high = 0;
    SettingScale scale;
    double feed = 0, feedBefore = 0; ///< of a pair: that of the first stage, which goes with all
    /// Of a starting cycle: with it, once it was made.
    std::shared_ptr<const Project> made{};

    /// The project with this value, all else as it was.
    [[nodiscard]] Project applied(Project project, double value) const;
    /// Makes a starting cycle for the project, which is then the same whatever it is applied to: a
    /// part of the batch, or the project with a wheel that is not worn.
    void make(const Project& project);
    /// The input that is changed, "/cycle/stages/1/radial_feed_mm"; of a stage more the stage that
    /// is added, of a starting cycle its first stage.
    [[nodiscard]] std::string path(const Project& project) const;
    /// The same as an input of the project as it is, whose row has label, symbol and unit.
    [[nodiscard]] std::string rowPath(const Project& project) const;
    /// Where an input of the project as it is stands once the setting is applied.
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
    /// Of an interval that is offered, at least.
    [[nodiscard]] int leastValues() const { return isCount() || isWholeCycle() ? 1 : 3; }
    [[nodiscard]] bool isDwell() const {
        return kind == RemedyKind::dwellEntry || kind == RemedyKind::dwellExit;
    }
};

/// All settings of a valid project that a remedy may change: a starting cycle, the single settings,
/// the finishing stages first, and pairs.
[[nodiscard]] std::vector<RemedySetting> remedySettings(const Project& project);

} // namespace sparkout
