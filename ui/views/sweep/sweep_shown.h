// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/line_chart.h"
#include "ui/views/sweep/sweep_scale.h"
#include "ui/views/sweep/sweep_text.h"

#include <QCoreApplication>

#include <functional>
#include <optional>
#include <vector>

namespace sparkout {

/// The content of the curves or the map of a sweep: a result over the varied inputs, and the marked
/// points.
struct SweepShown {
    Q_DECLARE_TR_FUNCTIONS(SweepShown)
public:
    /// Keys of the legends; smaller ones are curves.
    enum Key { presentKey = 1000, chosenKey, limitKey, holdsKey, refusedKey, notReachedKey };

    SweepResultPtr result = {};
    SweepEntry entry = {};
    bool margins = false;                            ///< false: values
    std::vector<std::optional<double>> present = {}; ///< current values of the inputs, if given
    std::optional<std::size_t> chosen = {};          ///< index of a point

    [[nodiscard]] bool empty() const { return !result || entry.quantities.empty(); }
    [[nodiscard]] bool isMap() const { return result && result->inputs.size() > 1; }
    [[nodiscard]] SweepScale scaleOf(std::size_t input) const;
    /// The positions of an input's values on the axis, and that of a point.
    [[nodiscard]] std::vector<double> placesOf(std::size_t input) const;
    [[nodiscard]] double placeOf(std::size_t point, std::size_t input) const;
    /// The position of the current value; empty if it is not given, or not positive on an axis of
    /// equal ratios.
    [[nodiscard]] std::optional<double> presentPlace(std::size_t input) const;
    /// Value or margin of a quantity at a point; NaN without a value.
    [[nodiscard]] double shownAt(std::size_t point, std::size_t quantity) const;
    [[nodiscard]] std::size_t pointNear(double across, double up = 0) const; ///< to this position
    [[nodiscard]] QString textOf(std::size_t point) const;

    /// Marks for the points without values, at a given height.
    [[nodiscard]] std::vector<ChartSeries>
    statusMarks(double size, const std::function<double(std::size_t point)>& height) const;

    /// A row for each point that was run: its inputs, its state, the quantities.
    [[nodiscard]] static CsvTable tableOf(const SweepResult& sweep,
                                          const std::vector<std::size_t>& quantities);
    [[nodiscard]] ChartTable table() const; ///< of the shown quantities
};

} // namespace sparkout
