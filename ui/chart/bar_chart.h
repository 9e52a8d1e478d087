// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/legend.h"
#include "ui/chart/quantity_colour.h"
#include "ui/kit/theme.h"
#include "ui/table/csv_table.h"

#include <QColor>
#include <QPalette>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace sparkout {

/// A colour that depends on the palette.
using BarColour = std::function<QColor(const QPalette&)>;
[[nodiscard]] BarColour barColour(Tone tone);
[[nodiscard]] BarColour barColour(style::Drawn what);

/// The bars of one kind: a value for each category.
struct BarSeries {
    QString name;
    BarColour colour;
    Hatch hatch = Hatch::none;
    std::vector<double> values; ///< no number: no bar
    bool onSecond = false;      ///< of the second axis, of grouped standing bars alone
    bool atLeast = false;       ///< its values are lower bounds: "≥ 54"
};

/// Five values of a distribution, from the least to the greatest.
struct BarBox {
    double least = 0, low = 0, median = 0, high = 0, most = 0;
    std::size_t kind = 0; ///< index among the chart's kinds, if it has several
};

/// A kind of boxes with its colour, for a chart with several kinds.
struct BoxKind {
    QString name;
    BarColour colour;
};

/// Allowed values, as a band behind the bars.
struct BarBand {
    double low = 0, high = 0;
    QString name;
};

/// A named value, as a line across the bars.
struct BarLimit {
    double at = 0;
    QString name;
    Qt::PenStyle pen = Qt::DashLine;
    BarColour colour = {}; ///< none: that of texts
};

/// A chart as a value, for drawing, describing and tabulating categories side by side.
struct BarChart {
    enum class Shape {
        stacked, ///< series on top of one another, negative values downwards
        grouped, ///< side by side
        boxes,   ///< boxes with whiskers, instead of series
        ring,    ///< one category: the series as slices
    };
    using Number = std::function<QString(double)>;

    Shape shape = Shape::stacked;
    bool isLying = false; ///< bars from left to right, the first category on top
    QString what;         ///< the categories are: "Stage"
    QStringList categories;
    QString axis, unit; ///< name and unit of the values: "Time", "min"
    QString secondAxis, secondUnit;
    std::vector<BarSeries> series;
    std::vector<BarBox> boxes; ///< by category
    BarColour boxColour = {};
    std::vector<BoxKind> boxKinds = {}; ///< replace that colour
    std::vector<double> sums;           ///< by category, drawn as marks if bars lead up and down
    QString sumName;
    bool hasTotals = false; ///< the stacks' heights are stated
    std::optional<BarBand> band;
    std::vector<BarLimit> limits;
    std::optional<double> most; ///< bars beyond it are cut, unlike their numbers
    Number number = {};         ///< a value as a text without its unit
    Number secondNumber = {};   ///< for the second axis
    QString centre = {};        ///< text in the centre of a ring
    QString remark = {};        ///< a sentence on omitted data, for instance
    /// The name of a series in a category, if it differs.
    std::function<QString(std::size_t series, std::size_t category)> partName = {};
    /// What the values of the second axis are of: a column of the table, and its texts by category.
    QString secondOf = {};
    QStringList secondNames = {};

    /// Converts values and limits in seconds to the unit of the longest.
    void fitTimeUnit();

    [[nodiscard]] bool empty() const { return categories.isEmpty(); }
    [[nodiscard]] const BarColour& colourOfBox(std::size_t category) const;
    [[nodiscard]] QString axisText() const;       ///< "Time, min"
    [[nodiscard]] QString secondAxisText() const; ///< of the second axis, with its unit
    [[nodiscard]] QString numberText(double value, bool onSecond = false) const;
    /// Of a series, "≥ 54" where it is a lower bound.
    [[nodiscard]] QString valueText(std::size_t series, std::size_t category) const;
    [[nodiscard]] bool isLowerBound(std::size_t category) const; ///< some part of the stack
    [[nodiscard]] double value(std::size_t series, std::size_t category) const; ///< no number: none
    [[nodiscard]] double total(std::size_t category) const;                     ///< of all series
    /// "Stage 1, working stroke: 0.42 min".
    [[nodiscard]] QString described(std::size_t series, std::size_t category) const;
    /// The chart as text, a line for each category.
    [[nodiscard]] QString description() const;
    /// A row for each category, with the visible series.
    [[nodiscard]] CsvTable table(const std::function<bool(std::size_t)>& shows) const;
    /// Keys: the series in order, if hiding one leaves others.
    [[nodiscard]] LegendEntries legend(const QPalette& palette, bool isDimmed,
                                       const std::function<bool(std::size_t)>& shows) const;
};

} // namespace sparkout
