// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace sparkout {

/// The last stage's spark-out: none, a number of strokes or revolutions, or until size. As an input
/// it is a CountOrWord.
struct SparkOut {
    enum class Mode { none, count, untilSize };
    Mode mode = Mode::none;
    int count = 0; ///< double strokes (traverse) or revolutions (plunge), with Mode::count
    friend bool operator==(const SparkOut&, const SparkOut&) = default;

    [[nodiscard]] static std::span<const Choice> words();
    [[nodiscard]] static Phrase expected();
    [[nodiscard]] static SparkOut ofNumber(int number) { return {Mode::count, number}; }
    [[nodiscard]] static SparkOut ofWord(std::size_t) { return {Mode::untilSize, 0}; }
    [[nodiscard]] int* number() { return mode == Mode::count ? &count : nullptr; }
    [[nodiscard]] std::optional<std::size_t> word() const {
        return mode == Mode::untilSize ? std::optional<std::size_t>(0) : std::nullopt;
    }
};

/// One stage of the cycle: its feeds and the radial stock it removes. As in the file, it has
/// members for the feeds of every kind of operation; OperationTraits::feeds lists those in use.
struct Stage {
    std::optional<double> radial_feed_mm;     ///< S_t, per double stroke [mm]
    std::optional<double> axial_feed_mm_min;  ///< S_ax [mm/min]
    std::optional<double> radial_feed_mm_min; ///< S_p [mm/min]
    /// S_c, traverse: continuous feed besides S_t [mm/min].
    std::optional<double> continuous_feed_mm_min;
    double stock_mm = 0; ///< Π_z, per side [mm]
    SparkOut spark_out;  ///< spark-out, only in the last stage

    /// Whether the stage is fed radially; otherwise it sparks out.
    [[nodiscard]] bool feeds() const { return spark_out.mode == SparkOut::Mode::none; }
    /// S_c of a stage that feeds continuously [mm/min]; otherwise 0.
    [[nodiscard]] double continuousFeed_mm_min() const {
        return feeds() ? continuous_feed_mm_min.value_or(0) : 0;
    }
    /// A spark-out until size, which may never end.
    [[nodiscard]] bool waitsForSize() const { return spark_out.mode == SparkOut::Mode::untilSize; }
    /// The given number of spark-out steps: double strokes or revolutions.
    [[nodiscard]] std::optional<int> sparkOutSteps() const {
        return spark_out.mode == SparkOut::Mode::count ? std::optional(spark_out.count)
                                                       : std::nullopt;
    }
    void dropSparkOut() { spark_out = {}; }
    void sparkOutFor(int steps) { spark_out = SparkOut::ofNumber(steps); }
    void sparkOutUntilSize() { spark_out = {SparkOut::Mode::untilSize, 0}; }

    static constexpr const char* sparkOutKey = "spark_out"; ///< of the member in the file
};

struct Cycle {
    std::vector<Stage> stages;
};

/// Whether a stage feeds while the table travels.
[[nodiscard]] bool feedsContinuously(const Project& project);

/// Whether a stage of the project retracts the wheel head.
[[nodiscard]] bool drawsBack(const Project& project);

/// Whether the stage, one of the project's, may retract the wheel head: between feeding stages,
/// where the gauge ends stages.
[[nodiscard]] bool mayRetract(const Project& project, const Stage& stage);

template <>
const StructInfo& tableOf<Stage>();
template <>
const StructInfo& tableOf<Cycle>();

} // namespace sparkout
