// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/bar_drawing.h"

#include "ui/chart/view_plot.h"
#include "ui/kit/font_size.h"
#include "ui/text/names.h"

#include <QPainter>
#include <QScopeGuard>
#include <QtMath>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

using Shape = BarChart::Shape;

constexpr double textGap = 4;           ///< between texts and their objects
constexpr double ringRoom = 2.2;        ///< about a ring, in heights of a text
constexpr double widestCategory = 0.58; ///< relative to the width, names beside lying bars
constexpr double fieldAlpha = 0.22;
constexpr double markWidth = 3;
constexpr double lineOfCategory = 1.45; ///< a lying bar with its name, in text heights
constexpr double leastType = 0.8;       ///< relative to the font, names under narrow bars

QStringList linesOf(const QString& text) {
    return text.split(u'\n');
}

double widthOf(const QFontMetricsF& metrics, const QString& text) {
    double width = 0;
    for (const QString& line : linesOf(text)) {
        width = std::max(width, metrics.horizontalAdvance(line));
    }
    return width;
}

/// With the decimals of the step.
QString axisNumber(const BarScale& scale, int tick) {
    const int decimals =
        std::clamp(static_cast<int>(std::ceil(-std::log10(scale.step) - 1e-9)), 0, 9);
    return Names::fixed(tick * scale.step, decimals);
}

qsizetype mostLines(const QStringList& texts) {
    qsizetype lines = 1;
    for (const QString& text : texts) {
        lines = std::max(lines, linesOf(text).size());
    }
    return lines;
}

} // namespace

struct BarDrawing::Layout {
    QSizeF size;
    ChartArea area;
    BarScales scales;
    QFontMetricsF metrics;
};

bool BarPart::holds(const QPointF& at) const {
    constexpr double near = 1;
    return slice.isEmpty() ? rect.adjusted(-near, -near, near, near).contains(at)
                           : slice.contains(at);
}

void BarDrawing::setChart(BarChart chart) {
    m_chart = std::move(chart);
    m_drawn = {};
    m_parts.clear(); // of the previous chart
}

void BarDrawing::setShown(std::vector<bool> shown) {
    shown.flip();
    m_hidden = std::move(shown);
}

bool BarDrawing::shows(std::size_t series) const {
    return series >= m_hidden.size() || !m_hidden[series];
}

int BarDrawing::partAt(const QPointF& at) const {
    const auto found =
        std::ranges::find_if(m_parts, [&at](const BarPart& part) { return part.holds(at); });
    return found == m_parts.end() ? -1 : static_cast<int>(found - m_parts.begin());
}

int BarDrawing::categoryAt(const QPointF& at) const {
    if (m_drawn.empty() || !m_area.rect.contains(at)) {
        return -1;
    }
    const double along = m_drawn.isLying ? at.y() - m_area.rect.top() : at.x() - m_area.rect.left();
    return std::clamp(static_cast<int>(along / m_area.room(m_drawn)), 0,
                      static_cast<int>(m_drawn.categories.size()) - 1);
}

int BarDrawing::leastHeight(const BarChart& chart, const QFont& font) {
    constexpr double standing = 7; // a chart of standing bars, in heights of a text
    const QFontMetricsF metrics(font);
    const double line = metrics.height();
    const auto categories = static_cast<double>(chart.categories.size());
    const double bars = chart.isLying ? std::max(categories, 2.0) * lineOfCategory : standing;
    const double names = chart.isLying
                             ? 0 // they are below; beside standing bars vertical
                             : std::max(metrics.horizontalAdvance(chart.axisText()),
                                        metrics.horizontalAdvance(chart.secondAxisText()));
    return static_cast<int>(
        std::ceil(std::max((bars + 2) * line + 3 * textGap, names + 3 * textGap)));
}

// --- layout -------------------------------------------------------------------------------------

/// The visible series of the chart.
BarChart BarDrawing::drawnChart() const {
    BarChart drawn = m_chart;
    drawn.series.clear();
    for (std::size_t i = 0; i < m_chart.series.size(); ++i) {
        if (shows(i)) {
            drawn.series.push_back(m_chart.series[i]);
        }
    }
    for (BarSeries& of : drawn.series) {
        for (double& value : of.values) {
            value = drawn.most && value > *drawn.most ? *drawn.most : value;
        }
    }
    return drawn;
}

/// The sum of the values themselves, even where their bars are cut.
double BarDrawing::shownTotal(std::size_t category) const {
    double sum = 0;
    for (const std::size_t i : m_drawnSeries) {
        const double value = m_chart.value(i, category);
        sum += std::isfinite(value) ? value : 0;
    }
    return sum;
}

double BarDrawing::widestNumber(const BarScale& scale) const {
    const QFontMetricsF metrics(m_look.font);
    double width = 0;
    for (int tick = -scale.below; tick <= scale.above; ++tick) {
        width = std::max(width, metrics.horizontalAdvance(axisNumber(scale, tick)));
    }
    return width;
}

/// The area that texts beside and below the axes leave.
QRectF BarDrawing::besideAxes(const QSizeF& size, const BarScales& scales) const {
    const QFontMetricsF metrics(m_look.font);
    const double line = metrics.height();
    QRectF area(QPointF(), size);
    const double number = widestNumber(scales.first);
    if (m_drawn.isLying) {
        double names = 0;
        for (const QString& name : m_drawn.categories) {
            names = std::max(names, widthOf(metrics, name));
        }
        names = std::min(names, widestCategory * size.width());
        area.adjust(names + textGap, textGap, -(number / 2 + textGap), -(2 * line + 2 * textGap));
    } else {
        const bool second = !m_drawn.secondAxis.isEmpty();
        const double right = second ? widestNumber(scales.second) + line + 3 * textGap : textGap;
        area.adjust(number + line + 3 * textGap, line / 2 + textGap, -right,
                    -(static_cast<double>(mostLines(m_drawn.categories)) * line + 2 * textGap));
    }
    return area;
}

BarDrawing::Layout BarDrawing::layOut(const QSizeF& size) const {
    const QFontMetricsF metrics(m_look.font);
    Layout layout{size, {}, {}, metrics};
    if (m_drawn.shape == Shape::ring) {
        const double side =
            std::max(std::min(size.width(), size.height()) - 2 * ringRoom * metrics.height(), 20.0);
        layout.area.rect = {(size.width() - side) / 2, (size.height() - side) / 2, side, side};
        return layout;
    }
    layout.scales = scalesOf(m_drawn, 4);
    const double length = m_drawn.isLying ? besideAxes(size, layout.scales).width()
                                          : besideAxes(size, layout.scales).height();
    const double each =
        m_drawn.isLying ? widestNumber(layout.scales.first) + 3 * textGap : 2 * metrics.height();
    layout.scales = scalesOf(m_drawn, std::clamp(static_cast<int>(length / each), 1, 6));
    const QRectF area = besideAxes(size, layout.scales);
    layout.area.rect = area.isValid() ? area : QRectF(area.topLeft(), QSizeF(1, 1));
    return layout;
}

// --- parts --------------------------------------------------------------------------------------

/// Computes the bars like Qt Charts, which puts the series into equal groups by their axis.
void BarDrawing::findParts(const Layout& layout) {
    m_parts.clear();
    const BarChart& chart = m_drawn;
    const ChartArea& area = layout.area;
    const double width = area.barShare(chart) * area.room(chart);
    for (std::size_t c = 0; c < static_cast<std::size_t>(chart.categories.size()); ++c) {
        if (chart.shape == Shape::boxes) {
            const BarBox& box = chart.boxes[c];
            m_parts.push_back(
                {0, c, area.bar(chart, layout.scales.first, c, box.least, box.most, 0, width)});
            continue;
        }
        const auto count = [&chart](bool onSecond) {
            return static_cast<double>(
                std::ranges::count(chart.series, onSecond, &BarSeries::onSecond));
        };
        const double groups = (count(false) > 0 ? 1 : 0) + (count(true) > 0 ? 1 : 0);
        double up = 0, down = 0;
        std::array<double, 2> placed{}; // number of series on either axis
        for (std::size_t i = 0; i < chart.series.size(); ++i) {
            const double value = chart.value(i, c);
            const bool onSecond = chart.series[i].onSecond;
            const BarScale& scale = onSecond ? layout.scales.second : layout.scales.first;
            const double place = placed.at(onSecond ? 1 : 0)++;
            if (!std::isfinite(value)) {
                continue;
            }
            double from = 0, beside = 0, own = width;
            if (chart.shape == Shape::stacked) {
                double& reached = value < 0 ? down : up;
                from = std::exchange(reached, reached + value);
            } else {
                own = width / groups / count(onSecond);
                const double slot = onSecond ? groups - 1 : 0;
                beside = ((slot + 0.5) / groups - 0.5) * area.room(chart)
                         + (place - (count(onSecond) - 1) / 2) * own;
                beside = chart.isLying ? -beside : beside; // Qt Charts counts from the bottom
            }
            m_parts.push_back(
                {m_drawnSeries[i], c, area.bar(chart, scale, c, from, from + value, beside, own)});
        }
    }
}

void BarDrawing::findSlices(const Layout& layout) {
    m_parts.clear();
    const QRectF& ring = layout.area.rect;
    const QRectF hole(ring.center() - QPointF(ring.width(), ring.height()) * ChartArea::hole / 2,
                      ring.size() * ChartArea::hole);
    double angle = 90;
    const double all = m_drawn.total(0);
    for (std::size_t i = 0; i < m_drawn.series.size() && all > 0; ++i) {
        const double span = -360 * m_drawn.value(i, 0) / all; // clockwise
        QPainterPath slice;
        slice.arcMoveTo(ring, angle);
        slice.arcTo(ring, angle, span);
        slice.arcTo(hole, angle + span, -span);
        slice.closeSubpath();
        if (span < 0) {
            m_parts.push_back({m_drawnSeries[i], 0, slice.boundingRect(), slice});
        }
        angle += span;
    }
}

// --- painting -----------------------------------------------------------------------------------

void BarDrawing::paint(QPainter& painter, const QSizeF& size) {
    m_drawn = drawnChart();
    m_drawnSeries.clear();
    for (std::size_t i = 0; i < m_chart.series.size(); ++i) {
        if (shows(i)) {
            m_drawnSeries.push_back(i);
        }
    }
    m_parts.clear();
    m_taken.clear();
    m_texts.clear();
    const bool isBoxes = m_drawn.shape == Shape::boxes;
    if (m_drawn.empty() || (m_drawn.series.empty() && !isBoxes) || size.isEmpty()) {
        return;
    }
    const Layout layout = layOut(size);
    m_area = layout.area;
    painter.save();
    painter.setFont(m_look.font);
    const bool isRing = m_drawn.shape == Shape::ring;
    isRing ? findSlices(layout) : findParts(layout);
    paintBand(painter, layout);
    m_scene.show(m_drawn, layout.scales, m_look);
    m_scene.paint(painter, size, layout.area);
    paintHatches(painter);
    if (isRing) {
        paintSliceNumbers(painter, layout);
    } else {
        paintMarks(painter, layout);
        paintAxis(painter, layout, false);
        if (!m_drawn.secondAxis.isEmpty()) {
            paintAxis(painter, layout, true);
        }
        paintCategories(painter, layout);
        paintTotals(painter, layout);
        paintNumbers(painter, layout);
    }
    painter.restore();
}

bool BarDrawing::write(QPainter& painter, const QRectF& box, const QString& text, bool onBar) {
    const QRectF clear = box.adjusted(-textGap, 0, textGap, 0);
    const auto meets = [&clear](const QRectF& other) { return clear.intersects(other); };
    if (std::ranges::any_of(m_taken, meets)) {
        return false;
    }
    if (onBar) { // hatches and colours would impair legibility
        QColor ground = m_look.palette.color(QPalette::Base);
        ground.setAlphaF(0.82F);
        painter.setPen(Qt::NoPen);
        painter.setBrush(ground);
        painter.drawRoundedRect(box.adjusted(-1, 0, 1, 0), 2, 2);
    }
    painter.setPen(m_look.ink());
    painter.drawText(box, Qt::AlignCenter | Qt::TextDontClip, text);
    m_taken.push_back(box);
    m_texts << text;
    return true;
}

void BarDrawing::paintBand(QPainter& painter, const Layout& layout) const {
    if (!m_drawn.band) {
        return;
    }
    const BarScale& scale = layout.scales.first;
    const double a = layout.area.at(m_drawn, scale, m_drawn.band->low);
    const double b = layout.area.at(m_drawn, scale, m_drawn.band->high);
    QRectF field = layout.area.rect;
    if (m_drawn.isLying) {
        field.setLeft(std::min(a, b));
        field.setRight(std::max(a, b));
    } else {
        field.setTop(std::min(a, b));
        field.setBottom(std::max(a, b));
    }
    QColor colour = m_look.toned(barColour(style::Drawn::toleranceField));
    painter.setPen(QPen(colour, 1));
    colour.setAlphaF(static_cast<float>(colour.alphaF() * fieldAlpha));
    painter.setBrush(colour);
    painter.drawRect(field);
}

void BarDrawing::paintHatches(QPainter& painter) const {
    const QColor line = m_look.palette.color(QPalette::Base);
    for (const BarPart& part : m_parts) {
        if (m_drawn.shape == Shape::boxes) {
            return;
        }
        const Hatch hatch = m_chart.series[part.series].hatch;
        if (part.slice.isEmpty()) {
            paintHatch(painter, part.rect, hatch, line);
        } else if (hatch != Hatch::none) {
            painter.save();
            painter.setClipPath(part.slice, Qt::IntersectClip);
            paintHatch(painter, part.rect, hatch, line);
            painter.restore();
        }
    }
}

/// Paints limits, the zero line and sums of the stacks.
void BarDrawing::paintMarks(QPainter& painter, const Layout& layout) const {
    const QRectF& area = layout.area.rect;
    const BarScale& scale = layout.scales.first;
    const auto across = [&](double value, const QPen& pen) {
        const double at = layout.area.at(m_drawn, scale, value);
        painter.setPen(pen);
        painter.drawLine(m_drawn.isLying ? QLineF(at, area.top(), at, area.bottom())
                                         : QLineF(area.left(), at, area.right(), at));
    };
    if (scale.below > 0 && scale.above > 0) {
        across(0, QPen(m_look.ink(), 1));
    }
    for (const BarLimit& limit : m_drawn.limits) {
        const QColor colour = limit.colour ? m_look.toned(limit.colour) : m_look.ink();
        across(limit.at, QPen(colour, 1.6, limit.pen, Qt::FlatCap));
    }
    const double width = 1.25 * layout.area.barShare(m_drawn) * layout.area.room(m_drawn);
    for (std::size_t c = 0; c < m_drawn.sums.size(); ++c) {
        const double at = layout.area.at(m_drawn, scale, m_drawn.sums[c]);
        const double middle = layout.area.middle(m_drawn, c);
        const QLineF mark = m_drawn.isLying
                                ? QLineF(at, middle - width / 2, at, middle + width / 2)
                                : QLineF(middle - width / 2, at, middle + width / 2, at);
        painter.setPen(
            QPen(m_look.palette.color(QPalette::Base), markWidth + 2, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(mark);
        painter.setPen(QPen(m_look.ink(), markWidth, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(mark);
    }
}

// --- numbers ------------------------------------------------------------------------------------

QString BarDrawing::totalText(std::size_t category) const {
    const bool isBoxes = m_drawn.shape == Shape::boxes;
    if (!m_drawn.hasTotals && m_drawn.sums.empty() && !isBoxes) {
        return {};
    }
    const QString text = m_drawn.numberText(!m_drawn.sums.empty() ? m_drawn.sums[category]
                                            : isBoxes             ? m_drawn.boxes[category].median
                                                                  : shownTotal(category));
    return m_drawn.isLowerBound(category) ? QStringLiteral("≥\u00a0") + text : text;
}

/// The place of a number, moved away from the lines of limits.
QRectF BarDrawing::beyondLimits(QRectF box, const Layout& layout, bool upwards) const {
    std::vector<double> lines;
    for (const BarLimit& limit : m_drawn.limits) {
        lines.push_back(layout.area.at(m_drawn, layout.scales.first, limit.at));
    }
    const bool isAscending = upwards == m_drawn.isLying; // on the screen, where y points down
    std::ranges::sort(lines);
    if (!isAscending) {
        std::ranges::reverse(lines);
    }
    for (const double at : lines) {
        if (m_drawn.isLying && box.left() - textGap < at && at < box.right() + textGap) {
            upwards ? box.moveLeft(at + textGap) : box.moveRight(at - textGap);
        } else if (!m_drawn.isLying && box.top() - 1 < at && at < box.bottom() + 1) {
            upwards ? box.moveBottom(at - 2) : box.moveTop(at + 2);
        }
    }
    return box;
}

/// The area of a category's bars and the mark of its sum.
QRectF BarDrawing::stackOf(std::size_t category, const Layout& layout) const {
    QRectF stack;
    for (const BarPart& part : m_parts) {
        stack = part.category == category ? stack | part.rect : stack;
    }
    if (!m_drawn.sums.empty()) {
        const double at = layout.area.at(m_drawn, layout.scales.first, m_drawn.sums[category]);
        stack |= m_drawn.isLying
                     ? QRectF(at, stack.top(), markWidth, stack.height())
                     : QRectF(stack.left(), at - markWidth, stack.width(), 2 * markWidth);
    }
    return stack;
}

/// Whether a part extends so far beyond its stack's sum that a number beyond the stack would not be
/// associated with the mark, or the numbers do not fit side by side.
bool BarDrawing::sumsNeedRows(const Layout& layout, const QStringList& texts,
                              const QFont& font) const {
    const QFontMetricsF metrics(font);
    for (std::size_t c = 0; c < m_drawn.sums.size() && !m_drawn.isLying; ++c) {
        const QRectF stack = stackOf(c, layout);
        const double at = layout.area.at(m_drawn, layout.scales.first, m_drawn.sums[c]);
        const double beyond = m_drawn.sums[c] < 0 ? stack.bottom() - at : at - stack.top();
        const double width = metrics.horizontalAdvance(texts[static_cast<qsizetype>(c)]);
        if (beyond > metrics.height() || width + textGap > layout.area.room(m_drawn)) {
            return true;
        }
    }
    return false;
}

/// Paints the sums in a row along the edge with more space; overlapping ones go into a second row.
void BarDrawing::paintSums(QPainter& painter, const Layout& layout, const QStringList& texts) {
    const QFontMetricsF metrics(painter.font());
    const QRectF& area = layout.area.rect;
    double above = area.height(), below = area.height();
    for (std::size_t c = 0; c < m_drawn.sums.size(); ++c) {
        const QRectF stack = stackOf(c, layout);
        above = std::min(above, stack.top() - area.top());
        below = std::min(below, area.bottom() - stack.bottom());
    }
    const bool isAbove = above >= below;
    for (std::size_t c = 0; c < m_drawn.sums.size(); ++c) {
        const QString& text = texts[static_cast<qsizetype>(c)];
        const double width = metrics.horizontalAdvance(text), height = metrics.height();
        QRectF box(layout.area.middle(m_drawn, c) - width / 2,
                   isAbove ? area.top() + 1 : area.bottom() - height - 1, width, height);
        if (!write(painter, box, text, true)) {
            box.translate(0, isAbove ? height : -height);
            write(painter, box, text, true);
        }
    }
}

/// Beyond the end of a stack; for sums, beyond all of it, below standing ones that are negative.
void BarDrawing::paintTotals(QPainter& painter, const Layout& layout) {
    QStringList texts;
    for (std::size_t c = 0; c < static_cast<std::size_t>(m_drawn.categories.size()); ++c) {
        texts << totalText(c);
    }
    const QFont font =
        m_drawn.isLying ? m_look.font : fontFor(texts, layout.area.room(m_drawn) - textGap - 1);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    const auto restored = qScopeGuard([&] { painter.setFont(m_look.font); });
    if (sumsNeedRows(layout, texts, font)) {
        paintSums(painter, layout, texts);
        return;
    }
    for (std::size_t c = 0; c < static_cast<std::size_t>(m_drawn.categories.size()); ++c) {
        const QString text = texts[static_cast<qsizetype>(c)];
        if (text.isEmpty()) {
            break;
        }
        const QRectF stack = stackOf(c, layout);
        const QSizeF size(metrics.horizontalAdvance(text), metrics.height());
        const QRectF all(QPointF(), layout.size);
        if (m_drawn.isLying) {
            const QRectF box(stack.right() + textGap, stack.center().y() - size.height() / 2,
                             size.width(), size.height());
            const QRectF clear = beyondLimits(box, layout, true);
            if (all.contains(box)) {
                write(painter, all.contains(clear) ? clear : box, text, true);
            }
        } else if (size.width() <= layout.area.room(m_drawn)) {
            const bool isBelow = !m_drawn.sums.empty() && m_drawn.sums[c] < 0;
            const QRectF under(stack.center().x() - size.width() / 2, stack.bottom() + 1,
                               size.width(), size.height());
            const QRectF low = beyondLimits(under, layout, false);
            if (isBelow && low.bottom() <= layout.area.rect.bottom()
                && write(painter, low, text, true)) {
                continue;
            }
            const QRectF top(stack.center().x() - size.width() / 2, stack.top() - size.height(),
                             size.width(), size.height());
            const QRectF clear = beyondLimits(top, layout, true);
            const QRectF above = clear.top() >= 0 ? clear : top;
            write(painter, above.top() >= 0 ? above : above.translated(0, 2 * size.height()), text,
                  true);
        }
    }
}

/// Within a sufficiently large part of a stack; beyond the end of a single bar, otherwise within.
void BarDrawing::paintNumbers(QPainter& painter, const Layout& layout) {
    const bool isStack = m_drawn.shape == Shape::stacked && m_drawn.series.size() > 1;
    const QRectF all(QPointF(), layout.size);
    for (const BarPart& part : m_parts) {
        if (m_drawn.shape == Shape::boxes) {
            return;
        }
        const double value = m_chart.value(part.series, part.category);
        if (value == 0 && (isStack || m_drawn.hasTotals)) {
            continue;
        }
        const QString text = m_chart.valueText(part.series, part.category);
        if (isStack && text == totalText(part.category)) { // the whole stack: stated beside it
            continue;
        }
        const QSizeF size(layout.metrics.horizontalAdvance(text), layout.metrics.height());
        QRectF within(QPointF(), size);
        within.moveCenter(part.rect.center());
        const QRectF room = m_drawn.isLying ? part.rect.adjusted(2, -textGap, -2, textGap)
                                            : part.rect.adjusted(-textGap, 2, textGap, -2);
        const bool fits = room.contains(within);
        if (isStack) {
            if (fits && (m_drawn.isLying || size.width() <= layout.area.room(m_drawn))) {
                write(painter, within, text, true);
            }
            continue;
        }
        if (m_drawn.hasTotals) {
            continue;
        }
        const double sign = value < 0 ? -1 : 1;
        QRectF beyond = within;
        if (m_drawn.isLying) {
            value < 0 ? beyond.moveRight(part.rect.left() - textGap)
                      : beyond.moveLeft(part.rect.right() + textGap);
        } else {
            beyond.moveCenter({beyond.center().x(), 0});
            sign > 0 ? beyond.moveBottom(part.rect.top() - 1)
                     : beyond.moveTop(part.rect.bottom() + 1);
        }
        const bool narrow =
            !m_drawn.isLying
            && size.width() > layout.area.room(m_drawn) / double(m_drawn.series.size()) - 1;
        if (narrow) {
            continue;
        }
        const QRectF clear = beyondLimits(beyond, layout, sign > 0);
        beyond = all.contains(clear) ? clear : beyond;
        if (!all.contains(beyond) || !write(painter, beyond, text, true)) {
            (void)(fits && write(painter, within, text, true));
        }
    }
}

void BarDrawing::paintSliceNumbers(QPainter& painter, const Layout& layout) {
    const QRectF& ring = layout.area.rect;
    const double all = m_drawn.total(0), line = layout.metrics.height();
    const QStringList lines = linesOf(m_drawn.centre);
    const double top = ring.center().y() - static_cast<double>(lines.size()) * line / 2;
    for (qsizetype i = 0; i < lines.size(); ++i) {
        const double width = layout.metrics.horizontalAdvance(lines[i]);
        if (width <= ChartArea::hole * ring.width()) {
            write(painter,
                  {ring.center().x() - width / 2, top + static_cast<double>(i) * line, width, line},
                  lines[i]);
        }
    }
    double done = 0;
    for (std::size_t i = 0; i < m_drawn.series.size() && all > 0; ++i) {
        const double value = m_drawn.value(i, 0);
        const double middle = (done + value / 2) / all * 2 * M_PI; // clockwise from the top
        done += value;
        if (value <= 0) {
            continue;
        }
        const QString text = m_drawn.numberText(value);
        const double width = layout.metrics.horizontalAdvance(text);
        const QPointF to(std::sin(middle), -std::cos(middle));
        QRectF box(0, 0, width, line);
        box.moveCenter(ring.center()
                       + QPointF(to.x() * (ring.width() / 2 + textGap + width / 2),
                                 to.y() * (ring.height() / 2 + textGap + line / 2)));
        write(painter, box, text);
    }
}

// --- axes ---------------------------------------------------------------------------------------

/// The largest font with which all texts fit, down to the least legible.
QFont BarDrawing::fontFor(const QStringList& texts, double room) const {
    constexpr double shrink = 0.95; // a font's widths do not scale evenly with its size
    const auto fits = [&](const QFont& font) {
        return std::ranges::all_of(
            texts, [&](const QString& text) { return widthOf(QFontMetricsF(font), text) <= room; });
    };
    QFont font = m_look.font;
    for (double size = 1; !fits(font) && size * shrink >= leastType;) {
        size *= shrink;
        font = enlarged(m_look.font, size);
    }
    return font;
}

void BarDrawing::paintCategories(QPainter& painter, const Layout& layout) {
    const QRectF& area = layout.area.rect;
    const double line = layout.metrics.height(), room = layout.area.room(m_drawn);
    const double most = std::max(room - textGap, 0.0); // under a standing bar
    const QFont font = fontFor(m_drawn.categories, m_drawn.isLying ? area.left() - textGap : most);
    const QFontMetricsF metrics(font);
    painter.setFont(font);
    double last = std::numeric_limits<double>::lowest(); // end of the previous one
    for (std::size_t c = 0; c < static_cast<std::size_t>(m_drawn.categories.size()); ++c) {
        const double middle = layout.area.middle(m_drawn, c);
        const QStringList lines = linesOf(m_drawn.categories[static_cast<qsizetype>(c)]);
        if (m_drawn.isLying) {
            if (middle - line / 2 < last - 1) {
                continue; // the rows are too low for separate names
            }
            const QRectF box(0, middle - line / 2, area.left() - textGap, line);
            const QString text = metrics.elidedText(lines.join(u' '), Qt::ElideRight, box.width());
            painter.setPen(m_look.ink());
            painter.drawText(box, Qt::AlignRight | Qt::AlignVCenter | Qt::TextDontClip, text);
            m_texts << text;
            last = box.bottom();
            continue;
        }
        const double width = std::min(widthOf(metrics, lines.join(u'\n')), most);
        if (middle - width / 2 < last || most < metrics.averageCharWidth() * 2) {
            continue;
        }
        for (qsizetype i = 0; i < lines.size(); ++i) {
            const QRectF box(middle - most / 2,
                             area.bottom() + textGap + static_cast<double>(i) * line, most, line);
            const QString text = metrics.elidedText(lines[i], Qt::ElideRight, most);
            painter.setPen(m_look.ink());
            painter.drawText(box, Qt::AlignHCenter | Qt::AlignTop | Qt::TextDontClip, text);
            m_texts << text;
        }
        last = middle + width / 2;
    }
    painter.setFont(m_look.font);
}

void BarDrawing::paintAxis(QPainter& painter, const Layout& layout, bool onSecond) {
    const QRectF& area = layout.area.rect;
    const BarScale& scale = onSecond ? layout.scales.second : layout.scales.first;
    const double line = layout.metrics.height();
    for (int tick = -scale.below; tick <= scale.above; ++tick) {
        const QString text = axisNumber(scale, tick);
        const double at = layout.area.at(m_drawn, scale, tick * scale.step);
        const double width = layout.metrics.horizontalAdvance(text);
        const QRectF box =
            m_drawn.isLying ? QRectF(at - width / 2, area.bottom() + textGap, width, line)
            : onSecond      ? QRectF(area.right() + textGap, at - line / 2, width, line)
                            : QRectF(area.left() - textGap - width, at - line / 2, width, line);
        write(painter, box, text);
    }
    paintAxisName(painter, layout, onSecond);
}

void BarDrawing::paintAxisName(QPainter& painter, const Layout& layout, bool onSecond) {
    const QRectF& area = layout.area.rect;
    const double line = layout.metrics.height();
    const QString name = onSecond ? m_drawn.secondAxisText() : m_drawn.axisText();
    painter.setPen(m_look.ink());
    if (m_drawn.isLying) {
        const double width = layout.metrics.horizontalAdvance(name);
        const double left = std::clamp(area.center().x() - width / 2, 0.0,
                                       std::max(layout.size.width() - width, 0.0));
        const QString text = layout.metrics.elidedText(name, Qt::ElideRight, layout.size.width());
        painter.drawText(QRectF(left, area.bottom() + textGap + line, width, line),
                         Qt::AlignLeft | Qt::AlignTop | Qt::TextDontClip, text);
        m_texts << text;
        return;
    }
    const QString text =
        layout.metrics.elidedText(name, Qt::ElideRight, layout.size.height() - 2 * textGap);
    const double width = layout.metrics.horizontalAdvance(text);
    const double middle = std::clamp(area.center().y(), width / 2,
                                     std::max(layout.size.height() - width / 2, width / 2));
    painter.save();
    painter.translate(onSecond ? layout.size.width() - line / 2 - 1 : line / 2 + 1, middle);
    painter.rotate(-90);
    painter.drawText(QRectF(-width / 2, -line / 2, width, line), Qt::AlignCenter | Qt::TextDontClip,
                     text);
    painter.restore();
    m_texts << text;
}

} // namespace sparkout
