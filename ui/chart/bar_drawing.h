// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/chart/bar_chart.h"
#include "ui/chart/chart_scene.h"

#include <QFontMetricsF>
#include <QPainterPath>
#include <QRectF>

#include <cstddef>
#include <vector>

class QPainter;

namespace sparkout {

/// A painted bar, box or slice.
struct BarPart {
    std::size_t series = 0, category = 0; ///< in the chart; a box uses the category only
    QRectF rect;                          ///< for a slice, its bounding box
    QPainterPath slice = {};              ///< empty: the rect

    [[nodiscard]] bool holds(const QPointF& at) const;
};

/// Draws a chart: bars and axes by Qt Charts, over them texts that never overlap, hatches, marks
/// and limits. The same on screen, on paper and in a file.
class BarDrawing {
public:
    void setChart(BarChart chart);
    void setShown(std::vector<bool> shown); ///< by series; further ones are visible
    void setLook(ChartLook look) { m_look = std::move(look); }

    void paint(QPainter& painter, const QSizeF& size);

    [[nodiscard]] const BarChart& chart() const { return m_chart; }
    [[nodiscard]] bool shows(std::size_t series) const;
    /// As last painted, in the order of the categories.
    [[nodiscard]] const std::vector<BarPart>& parts() const { return m_parts; }
    [[nodiscard]] int partAt(const QPointF& at) const;     ///< −1: none
    [[nodiscard]] int categoryAt(const QPointF& at) const; ///< also beside its bars
    [[nodiscard]] const ChartScene& scene() const { return m_scene; }
    [[nodiscard]] const QStringList& texts() const { return m_texts; } ///< as last painted
    [[nodiscard]] const std::vector<QRectF>& numberBoxes() const { return m_taken; } ///< likewise
    /// The least height at which every category has a line of its own.
    [[nodiscard]] static int leastHeight(const BarChart& chart, const QFont& font);

private:
    struct Layout;

    [[nodiscard]] BarChart drawnChart() const;
    [[nodiscard]] double shownTotal(std::size_t category) const;
    /// The text beyond a stack, or at a box; may be empty.
    [[nodiscard]] QString totalText(std::size_t category) const;
    [[nodiscard]] Layout layOut(const QSizeF& size) const;
    [[nodiscard]] QRectF besideAxes(const QSizeF& size, const BarScales& scales) const;
    [[nodiscard]] double widestNumber(const BarScale& scale) const;
    void findParts(const Layout& layout);
    void findSlices(const Layout& layout);
    void paintBand(QPainter& painter, const Layout& layout) const;
    void paintHatches(QPainter& painter) const;
    void paintMarks(QPainter& painter, const Layout& layout) const;
    [[nodiscard]] QRectF beyondLimits(QRectF box, const Layout& layout, bool upwards) const;
    [[nodiscard]] QRectF stackOf(std::size_t category, const Layout& layout) const;
    void paintNumbers(QPainter& painter, const Layout& layout);
    [[nodiscard]] bool sumsNeedRows(const Layout& layout, const QStringList& texts,
                                    const QFont& font) const;
    void paintSums(QPainter& painter, const Layout& layout, const QStringList& texts);
    void paintTotals(QPainter& painter, const Layout& layout);
    void paintSliceNumbers(QPainter& painter, const Layout& layout);
    [[nodiscard]] QFont fontFor(const QStringList& texts, double room) const;
    void paintCategories(QPainter& painter, const Layout& layout);
    void paintAxis(QPainter& painter, const Layout& layout, bool onSecond);
    void paintAxisName(QPainter& painter, const Layout& layout, bool onSecond);
    /// Writes a text where no other is; false if it does not fit.
    bool write(QPainter& painter, const QRectF& box, const QString& text, bool onBar = false);

    BarChart m_chart;
    std::vector<bool> m_hidden;
    ChartLook m_look;
    ChartScene m_scene;
    BarChart m_drawn; ///< with the visible series
    std::vector<std::size_t> m_drawnSeries;
    ChartArea m_area; ///< area as last painted
    std::vector<BarPart> m_parts;
    std::vector<QRectF> m_taken; ///< occupied by texts
    QStringList m_texts;
};

} // namespace sparkout
