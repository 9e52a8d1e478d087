// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/bar_chart.h"

#include <QGraphicsScene>
#include <QPointer>
#include <QRectF>

#include <vector>

class QAbstractAxis;
class QAbstractSeries;
class QChart;
class QPainter;
class QValueAxis;

namespace sparkout {

/// An axis of values: round steps from `below` steps under 0 to `above` over it.
struct BarScale {
    double step = 1;
    int below = 0, above = 1;

    [[nodiscard]] double low() const { return -below * step; }
    [[nodiscard]] double high() const { return above * step; }
    [[nodiscard]] double clamped(double value) const; ///< to the visible range
    /// The position of a value on the axis, from 0 to 1.
    [[nodiscard]] double share(double value) const;
};

/// Both axes of a chart, with equal steps and 0 at the same height.
struct BarScales {
    BarScale first, second;
};

/// The axis for all drawn data, with about this number of steps; it includes 0 even for boxes.
[[nodiscard]] BarScales scalesOf(const BarChart& chart, int steps);

struct ChartLook {
    QPalette palette;
    QFont font;
    bool isDimmed = false;

    [[nodiscard]] QColor toned(const BarColour& colour) const;
    [[nodiscard]] QColor ink() const;
};

/// The positions of a chart's bars, computed as Qt Charts would in an area.
struct ChartArea {
    static constexpr double hole = 0.58; ///< share of the radius of a ring
    static constexpr double most = 0.72; ///< share of a category's width for its bars
    static constexpr double widest = 46; ///< bars of a category together, standing or lying

    QRectF rect;
    /// Share of a category's width for its bars, by the number of categories.
    [[nodiscard]] double barShare(const BarChart& chart) const;
    [[nodiscard]] double at(const BarChart& chart, const BarScale& scale, double value) const;
    [[nodiscard]] double middle(const BarChart& chart, std::size_t category) const; ///< across
    [[nodiscard]] double room(const BarChart& chart) const; ///< width of a category
    /// The rectangle between two values of a category; its place across follows from its index
    /// among the bars.
    [[nodiscard]] QRectF bar(const BarChart& chart, const BarScale& scale, std::size_t category,
                             double from, double to, double middle, double width) const;
};

/// A chart of Qt Charts: its bars, boxes or slices, axes and grid. It has no texts, since Qt Charts
/// truncates texts that do not fit. Values of a small chart change in place; a large one, or one
/// with other series or categories, is rebuilt.
class ChartScene {
public:
    ChartScene();
    ~ChartScene();

    /// Every series has a value for each category.
    void show(const BarChart& chart, const BarScales& scales, const ChartLook& look);
    void paint(QPainter& painter, const QSizeF& size, const ChartArea& area);

    [[nodiscard]] QChart* chart() const { return m_chart; } ///< null before the first show()
    [[nodiscard]] const QList<QAbstractSeries*>& series() const { return m_series; }

private:
    [[nodiscard]] bool isAlike(const BarChart& chart) const;
    [[nodiscard]] bool hasValuesOf(const BarChart& chart) const;
    void build(const BarChart& chart, const BarScales& scales);
    void buildBars(const BarChart& chart, const BarScales& scales, bool onSecond);
    void buildAxes(const BarChart& chart);
    void fill(const BarChart& chart, const BarScales& scales);
    void colour(const BarChart& chart, const ChartLook& look);

    QGraphicsScene m_scene;
    QChart* m_chart = nullptr; ///< owned by the scene
    QList<QAbstractSeries*> m_series;
    QAbstractAxis* m_categories = nullptr;
    QValueAxis* m_values = nullptr;
    QValueAxis* m_secondValues = nullptr;
    BarChart m_shown;
};

} // namespace sparkout
