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

/// What the curves or the map show of a sweep: a result over the varied inputs, and the points that
/// stand out.
struct SweepShown {
    Q_DECLARE_TR_FUNCTIONS(SweepShown)
public:
    /// Of the legends; below: a curve.
    enum Key { presentKey = 1000, chosenKey, limitKey, holdsKey, refusedKey, notReachedKey };

    SweepResultPtr result = {};
    SweepEntry entry = {};
    bool margins = false;                            ///< else values
    std::vector<std::optional<double>> present = {}; ///< of the inputs, as far as they are given
    std::optional<std::size_t> chosen = {};          ///< a point

    [[nodiscard]] bool empty() const { return !result || entry.quantities.empty(); }
    [[nodiscard]] bool isMap() const { return result && result->inputs.size() > 1; }
    [[nodiscard]] SweepScale scaleOf(std::size_t input) const;
    /// The values of an input as they are placed, and those of a point.
    [[nodiscard]] std::vector<double> placesOf(std::size_t input) const;
    [[nodiscard]] double placeOf(std::size_t point, std::size_t input) const;
    /// Of the present values; nothing where one is not given, or not positive over ratios.
    [[nodiscard]] std::optional<double> presentPlace(std::size_t input) const;
    /// Value or margin of a quantity at a point; NaN where there is none.
    [[nodiscard]] double shownAt(std::size_t point, std::size_t quantity) const;
    [[nodiscard]] std::size_t pointNear(double across, double up = 0) const; ///< by their places
    [[nodiscard]] QString textOf(std::size_t point) const;

    /// The points without numbers at a height, as far as there are any.
    [[nodiscard]] std::vector<ChartSeries>
    statusMarks(double size, const std::function<double(std::size_t point)>& height) const;

    /// A row a point that was run and is wanted: its inputs, its state, the quantities.
    [[nodiscard]] static CsvTable tableOf(const SweepResult& sweep,
                                          const std::vector<std::size_t>& quantities,
                                          const std::function<bool(std::size_t)>& wanted);
};

} // namespace sparkout
