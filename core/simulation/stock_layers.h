// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/profile.h"
#include "core/simulation/progress.h"
#include "core/simulation/result.h"

#include <cstddef>
#include <optional>
#include <vector>

/// The layers of stock removed in the cycle, for the view "Layers".
namespace sparkout {

/// One double stroke or revolution, or several successive ones of one stage.
struct LayerSpan {
    int first = 1; ///< number of its first double stroke or revolution, from 1
    int last = 1;  ///< number of its last
    int stage = 1;
};

/// The layers of one zone or section.
struct LayerColumn {
    Zone zone = Zone::section;
    int section = 0;            ///< counted from 0
    Stretch stretch;            ///< its part of the ground length
    double blank_mm = 0;        ///< radius before the first layer
    double final_mm = 0;        ///< radius after the last layer, from the result
    std::vector<double> sum_mm; ///< Σa after each layer, one value a span, never falling
};

/// The layers of a run; no columns without a trajectory.
struct LayerSeries {
    Operation operation;
    double removalSign = 1;    ///< radius = blank − sign·Σa: +1 external, −1 internal
    double length_mm = 0;      ///< L_p
    double target_mm = 0;      ///< R_t
    double lowerLimit_mm = 0;  ///< radius at the lower deviation of the diameter
    double upperLimit_mm = 0;  ///< radius at the upper deviation
    std::optional<int> radius; ///< k; none: means over the ground radii
    std::vector<bool> gaps;    ///< true for those of the K radii that are in a gap
    std::vector<LayerSpan> spans;
    std::vector<LayerColumn> columns; ///< РЗ1, НЗ, РЗ2, or the sections from the headstock on

    [[nodiscard]] double sumAfter_mm(const LayerColumn& column, std::size_t count) const {
        return count > 0 ? column.sum_mm[count - 1] : 0;
    }
    /// Returns the radius after `count` spans.
    [[nodiscard]] double radiusAfter_mm(const LayerColumn& column, std::size_t count) const {
        return column.blank_mm - removalSign * sumAfter_mm(column, count);
    }
    /// Returns the number of spans that have begun after this number of double strokes or
    /// revolutions has begun, at most all of them.
    [[nodiscard]] std::size_t spansAt(int strokes) const;
    [[nodiscard]] double largestSum_mm() const;
    [[nodiscard]] int strokeCount() const { return spans.empty() ? 0 : spans.back().last; }
};

/// Layers up to a moment of the cycle; the last of them may be partly cut.
struct LayersDone {
    std::size_t count = 0;      ///< number of spans that have begun
    std::vector<double> sum_mm; ///< Σa of each column at that moment
};

/// Greatest number of double strokes or revolutions without merging.
inline constexpr int mostLayers = 400;

/// Makes the layers of one of the K radii, or of their mean.
[[nodiscard]] LayerSeries makeLayerSeries(const SimulationResult& result,
                                          const Trajectory& trajectory,
                                          std::optional<int> radius = {});

/// Returns the layers at the end of the cycle.
[[nodiscard]] LayersDone allLayers(const LayerSeries& series);

/// Returns Σa of a column after `count` of the finished layers [mm].
[[nodiscard]] double sumDone_mm(const LayerSeries& series, const LayersDone& done,
                                std::size_t column, std::size_t count);

/// Returns the layers cut up to a moment, with the depth of the last one.
[[nodiscard]] LayersDone layersDone(const LayerSeries& series, const Trajectory& trajectory,
                                    const Progress& progress);

} // namespace sparkout
