// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/process/ground_stretch.h"
#include "core/simulation/progress.h"
#include "core/simulation/result.h"
#include "core/simulation/trajectory.h"

#include <cstddef>
#include <optional>
#include <vector>

/// The stock as the layers in which the cycle takes it off: what the view "Layers" draws.
namespace sparkout {

/// One double stroke or revolution, or several of one stage in a row.
struct LayerSpan {
    int first = 1; ///< number of its first double stroke or revolution, from 1
    int last = 1;  ///< and of its last
    int stage = 1;
};

/// The layers of one zone or section.
struct LayerColumn {
    Zone zone = Zone::section;
    int section = 0;            ///< from 0
    Stretch stretch;            ///< of the ground length
    double blank_mm = 0;        ///< radius before the first layer
    double final_mm = 0;        ///< radius after the last one, of the result
    std::vector<double> sum_mm; ///< Σa after each layer, never falling; one a span
};

/// The layers of a run; no columns without a trajectory.
struct LayerSeries {
    Operation operation;
    double removalSign = 1;    ///< radius = blank − sign·Σa: +1 external, −1 internal
    double length_mm = 0;      ///< L_p
    double target_mm = 0;      ///< R_t
    double lowerLimit_mm = 0;  ///< radius at the lower deviation of the diameter
    double upperLimit_mm = 0;  ///< radius at the upper one
    std::optional<int> radius; ///< k; none: means over the radii that are ground
    std::vector<bool> gaps;    ///< of the K radii, those in a gap
    std::vector<LayerSpan> spans;
    std::vector<LayerColumn> columns; ///< РЗ1, НЗ, РЗ2, or the sections from the headstock on

    [[nodiscard]] double sumAfter_mm(const LayerColumn& column, std::size_t count) const {
        return count > 0 ? column.sum_mm[count - 1] : 0;
    }
    /// Radius after so many of the spans.
    [[nodiscard]] double radiusAfter_mm(const LayerColumn& column, std::size_t count) const {
        return column.blank_mm - removalSign * sumAfter_mm(column, count);
    }
    /// Spans that have begun when so many double strokes or revolutions have; all of them at most.
    [[nodiscard]] std::size_t spansAt(int strokes) const;
    [[nodiscard]] double largestSum_mm() const;
    [[nodiscard]] int strokeCount() const { return spans.empty() ? 0 : spans.back().last; }
};

/// Layers up to a moment of the cycle: the newest of them may have been cut in part.
struct LayersDone {
    std::size_t count = 0;      ///< spans that have begun
    std::vector<double> sum_mm; ///< Σa of each column at that moment
};

/// More double strokes or revolutions than this are merged, stage by stage.
inline constexpr int mostLayers = 400;

/// Of one of the K radii, or their mean.
[[nodiscard]] LayerSeries makeLayerSeries(const SimulationResult& result,
                                          const Trajectory& trajectory,
                                          std::optional<int> radius = {});

/// At the end of the cycle.
[[nodiscard]] LayersDone allLayers(const LayerSeries& series);

/// Σa of a column after so many of the layers done [mm].
[[nodiscard]] double sumDone_mm(const LayerSeries& series, const LayersDone& done,
                                std::size_t column, std::size_t count);

/// How many of the layers have been cut, and how much of the newest.
[[nodiscard]] LayersDone layersDone(const LayerSeries& series, const Trajectory& trajectory,
                                    const Progress& progress);

} // namespace sparkout
