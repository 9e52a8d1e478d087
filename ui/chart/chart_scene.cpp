// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/chart_scene.h"

#include "ui/chart/view_plot.h"

#include <QBarCategoryAxis>
#include <QBarSeries>
#include <QBarSet>
#include <QBoxPlotSeries>
#include <QBoxSet>
#include <QChart>
#include <QGraphicsLayout>
#include <QHorizontalBarSeries>
#include <QHorizontalStackedBarSeries>
#include <QLegend>
#include <QPainter>
#include <QPieSeries>
#include <QPieSlice>
#include <QStackedBarSeries>
#include <QValueAxis>

#include <algorithm>
#include <array>
#include <cmath>

namespace sparkout {

namespace {

struct Span {
    double low = 0, high = 0;

    void take(double value) {
        if (std::isfinite(value)) {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    }
};

constexpr double numberRoom = 0.12; ///< beyond the bars, relative to the range

bool hasNumbersBeyond(const BarChart& chart) {
    return chart.hasTotals || !chart.sums.empty() || chart.shape != BarChart::Shape::stacked
           || chart.series.size() == 1;
}

Span spanOf(const BarChart& chart, bool onSecond) {
    Span span;
    const auto categories = static_cast<std::size_t>(chart.categories.size());
    for (std::size_t category = 0; category < categories; ++category) {
        Span stack;
        for (std::size_t i = 0; i < chart.series.size(); ++i) {
            const double value = chart.value(i, category);
            if (chart.series[i].onSecond != onSecond || !std::isfinite(value)) {
                continue;
            }
            span.take(value);
            (value < 0 ? stack.low : stack.high) += value;
        }
        if (chart.shape == BarChart::Shape::stacked) {
            span.take(stack.low);
            span.take(stack.high);
        }
    }
    if (onSecond) {
        span.high += numberRoom * (span.high - span.low);
        return span;
    }
    for (const BarBox& box : chart.boxes) {
        span.take(box.least);
        span.take(box.most);
    }
    for (const double sum : chart.sums) {
        span.take(sum);
    }
    const double lowest = span.low; // lowest value of the bars
    for (const BarLimit& limit : chart.limits) {
        span.take(limit.at);
    }
    if (chart.band) {
        span.take(chart.band->low);
        span.take(chart.band->high);
    }
    if (chart.most) {
        span.high = std::min(span.high, *chart.most);
    }
    if (hasNumbersBeyond(chart)) {
        const double room = numberRoom * (span.high - span.low);
        span.high += room;
        span.low = lowest < 0 ? std::min(span.low, lowest - room) : span.low;
    }
    return span;
}

double roundStep(double span, int steps) {
    const double rough = span / std::max(steps, 1);
    const double power = std::pow(10, std::floor(std::log10(rough)));
    for (const double round : std::array{1.0, 2.0, 5.0}) {
        if (round * power >= rough * (1 - 1e-9)) {
            return round * power;
        }
    }
    return 10 * power;
}

BarScale scaleOf(const Span& span, int steps) {
    BarScale scale;
    const double size = span.high - span.low;
    if (!(size > 0) || !std::isfinite(size)) {
        return scale;
    }
    scale.step = roundStep(size, steps);
    const auto count = [&scale](double value) {
        return static_cast<int>(std::ceil(value / scale.step * (1 - 1e-9)));
    };
    scale.below = std::max(count(-span.low), 0);
    scale.above = std::max(count(span.high), 0);
    return scale;
}

} // namespace

double BarScale::clamped(double value) const {
    return std::isfinite(value) ? std::clamp(value, low(), high()) : 0;
}

double BarScale::share(double value) const {
    return (clamped(value) - low()) / (high() - low());
}

BarScales scalesOf(const BarChart& chart, int steps) {
    BarScales scales{scaleOf(spanOf(chart, false), steps), scaleOf(spanOf(chart, true), steps)};
    scales.first.below = scales.second.below = std::max(scales.first.below, scales.second.below);
    scales.first.above = scales.second.above = std::max(scales.first.above, scales.second.above);
    return scales;
}

namespace {

using Shape = BarChart::Shape;

constexpr int lineAlpha = 150, gridAlpha = 35;

QAbstractBarSeries* makeBars(const BarChart& chart) {
    if (chart.shape == Shape::stacked) {
        return chart.isLying ? static_cast<QAbstractBarSeries*>(new QHorizontalStackedBarSeries)
                             : new QStackedBarSeries;
    }
    return chart.isLying ? static_cast<QAbstractBarSeries*>(new QHorizontalBarSeries)
                         : new QBarSeries;
}

/// A value as its bar is drawn. A stack is cut as a whole, by the axis.
double drawnValue(const BarChart& chart, const BarScale& scale, double value) {
    return !std::isfinite(value) ? 0 : chart.shape == Shape::stacked ? value : scale.clamped(value);
}

/// The bars of a series from the bottom on: Qt Charts puts the first of lying ones there.
QList<double> drawnValues(const BarChart& chart, const BarScales& scales, std::size_t series) {
    const BarScale& scale = chart.series[series].onSecond ? scales.second : scales.first;
    QList<double> values;
    for (std::size_t c = 0; c < static_cast<std::size_t>(chart.categories.size()); ++c) {
        values << drawnValue(chart, scale, chart.value(series, c));
    }
    if (chart.isLying) {
        std::ranges::reverse(values);
    }
    return values;
}

/// Whether changing the values one by one would be slower than rebuilding the chart.
bool isLarge(const BarChart& chart) {
    constexpr std::size_t manyBars = 40;
    return chart.series.size() * static_cast<std::size_t>(chart.categories.size()) > manyBars;
}

bool hasSecond(const BarChart& chart) {
    return std::ranges::any_of(chart.series, &BarSeries::onSecond);
}

} // namespace

QColor ChartLook::toned(const BarColour& colour) const {
    return style::dimmed(colour(palette), isDimmed);
}

QColor ChartLook::ink() const {
    return style::dimmed(palette.color(QPalette::Text), isDimmed);
}

// --- positions ----------------------------------------------------------------------------------

double ChartArea::room(const BarChart& chart) const {
    const auto categories = static_cast<double>(std::max<qsizetype>(chart.categories.size(), 1));
    return (chart.isLying ? rect.height() : rect.width()) / categories;
}

double ChartArea::barShare(const BarChart& chart) const {
    const double bars =
        chart.shape == Shape::grouped ? static_cast<double>(chart.series.size()) : 1;
    return std::min(most, widest * std::max(bars, 1.0) / std::max(room(chart), 1.0));
}

double ChartArea::middle(const BarChart& chart, std::size_t category) const {
    const double start = chart.isLying ? rect.top() : rect.left();
    return start + (static_cast<double>(category) + 0.5) * room(chart);
}

double ChartArea::at(const BarChart& chart, const BarScale& scale, double value) const {
    const double share = scale.share(value);
    return chart.isLying ? rect.left() + share * rect.width()
                         : rect.bottom() - share * rect.height();
}

QRectF ChartArea::bar(const BarChart& chart, const BarScale& scale, std::size_t category,
                      double from, double to, double middleOf, double width) const {
    const double a = at(chart, scale, from), b = at(chart, scale, to);
    const double across = middle(chart, category) + middleOf - width / 2;
    return chart.isLying ? QRectF(std::min(a, b), across, std::abs(b - a), width)
                         : QRectF(across, std::min(a, b), width, std::abs(b - a));
}

// --- building -----------------------------------------------------------------------------------

ChartScene::ChartScene() = default;
ChartScene::~ChartScene() = default;

bool ChartScene::isAlike(const BarChart& chart) const {
    return m_chart && m_shown.shape == chart.shape && m_shown.isLying == chart.isLying
           && m_shown.categories.size() == chart.categories.size()
           && m_shown.boxes.size() == chart.boxes.size()
           && std::ranges::equal(m_shown.series, chart.series, {}, &BarSeries::onSecond,
                                 &BarSeries::onSecond);
}

/// For a chart of the same structure.
bool ChartScene::hasValuesOf(const BarChart& chart) const {
    const auto isSame = [](double a, double b) {
        return a == b || (std::isnan(a) && std::isnan(b));
    };
    return std::ranges::equal(m_shown.series, chart.series,
                              [&isSame](const BarSeries& a, const BarSeries& b) {
                                  return std::ranges::equal(a.values, b.values, isSame);
                              });
}

void ChartScene::build(const BarChart& chart, const BarScales& scales) {
    m_series.clear();
    m_scene.clear(); // with the chart, its series and axes
    m_values = m_secondValues = nullptr;
    m_categories = nullptr;
    m_chart = new QChart;
    m_scene.addItem(m_chart);
    m_chart->setAnimationOptions(QChart::NoAnimation);
    m_chart->setBackgroundVisible(false);
    m_chart->setMargins(QMargins());
    m_chart->layout()->setContentsMargins(0, 0, 0, 0);
    m_chart->legend()->hide();
    if (chart.shape == Shape::ring) {
        auto* slices = new QPieSeries;
        slices->setHoleSize(ChartArea::hole);
        slices->setPieSize(1);
        for (std::size_t i = 0; i < chart.series.size(); ++i) {
            slices->append(QString::number(i), 1);
        }
        m_chart->addSeries(slices);
        m_series << slices;
        return;
    }
    buildAxes(chart);
    if (chart.shape == Shape::boxes) {
        auto* boxes = new QBoxPlotSeries;
        for (std::size_t i = 0; i < chart.boxes.size(); ++i) {
            boxes->append(new QBoxSet(QString::number(i)));
        }
        m_chart->addSeries(boxes);
        boxes->attachAxis(m_categories);
        boxes->attachAxis(m_values);
        m_series << boxes;
        return;
    }
    for (const bool onSecond : {false, true}) {
        if (std::ranges::count(chart.series, onSecond, &BarSeries::onSecond) > 0) {
            buildBars(chart, scales, onSecond);
        }
    }
}

void ChartScene::buildAxes(const BarChart& chart) {
    auto* categories = new QBarCategoryAxis;
    QStringList names; // unique, as Qt Charts requires
    for (qsizetype i = 0; i < chart.categories.size(); ++i) {
        names << QString::number(i);
    }
    categories->append(names);
    m_categories = categories;
    m_values = new QValueAxis;
    const auto add = [this](QAbstractAxis* axis, Qt::Alignment side) {
        axis->setLabelsVisible(false);
        m_chart->addAxis(axis, side);
    };
    add(m_categories, chart.isLying ? Qt::AlignLeft : Qt::AlignBottom);
    add(m_values, chart.isLying ? Qt::AlignBottom : Qt::AlignLeft);
    m_categories->setGridLineVisible(false);
    if (hasSecond(chart)) {
        m_secondValues = new QValueAxis;
        add(m_secondValues, Qt::AlignRight);
        m_secondValues->setGridLineVisible(false); // that of the first
    }
}

/// With their values: a set in a chart repeats the layout for every value.
void ChartScene::buildBars(const BarChart& chart, const BarScales& scales, bool onSecond) {
    QAbstractBarSeries* const bars = makeBars(chart);
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        if (chart.series[i].onSecond == onSecond) {
            auto* set = new QBarSet(chart.series[i].name);
            set->append(drawnValues(chart, scales, i));
            bars->append(set);
        }
    }
    m_chart->addSeries(bars);
    bars->attachAxis(m_categories);
    bars->attachAxis(onSecond ? m_secondValues : m_values);
    m_series << bars;
}

// --- values and colours -------------------------------------------------------------------------

void ChartScene::show(const BarChart& chart, const BarScales& scales, const ChartLook& look) {
    if (!isAlike(chart) || (isLarge(chart) && !hasValuesOf(chart))) {
        build(chart, scales);
    }
    m_shown = chart;
    fill(chart, scales);
    colour(chart, look);
}

void ChartScene::fill(const BarChart& chart, const BarScales& scales) {
    if (chart.shape == Shape::ring) {
        const QList<QPieSlice*> slices = static_cast<QPieSeries*>(m_series[0])->slices();
        for (std::size_t i = 0; i < chart.series.size(); ++i) {
            slices[static_cast<qsizetype>(i)]->setValue(chart.value(i, 0));
        }
        return;
    }
    const auto range = [](QValueAxis& axis, const BarScale& scale) {
        axis.setRange(scale.low(), scale.high());
        axis.setTickCount(scale.below + scale.above + 1);
    };
    range(*m_values, scales.first);
    if (m_secondValues) {
        range(*m_secondValues, scales.second);
    }
    if (chart.shape == Shape::boxes) {
        const QList<QBoxSet*> boxes = static_cast<QBoxPlotSeries*>(m_series[0])->boxSets();
        for (std::size_t i = 0; i < chart.boxes.size(); ++i) {
            const BarBox& box = chart.boxes[i];
            QBoxSet& set = *boxes[static_cast<qsizetype>(i)];
            set.setValue(QBoxSet::LowerExtreme, box.least);
            set.setValue(QBoxSet::LowerQuartile, box.low);
            set.setValue(QBoxSet::Median, box.median);
            set.setValue(QBoxSet::UpperQuartile, box.high);
            set.setValue(QBoxSet::UpperExtreme, box.most);
        }
        return;
    }
    std::array<int, 2> next{}; // of the sets of either axis
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const bool onSecond = chart.series[i].onSecond;
        const std::size_t axis = onSecond ? 1 : 0;
        const qsizetype place = onSecond && m_series.size() > 1 ? 1 : 0;
        QBarSet& set =
            *static_cast<QAbstractBarSeries*>(m_series[place])->barSets()[next.at(axis)++];
        const QList<double> values = drawnValues(chart, scales, i);
        for (int at = 0; at < static_cast<int>(values.size()); ++at) {
            if (set.at(at) != values[at]) {
                set.replace(at, values[at]);
            }
        }
    }
}

void ChartScene::colour(const BarChart& chart, const ChartLook& look) {
    const QPen edge(look.palette.color(QPalette::Base), 1);
    if (chart.shape == Shape::ring) {
        const QList<QPieSlice*> slices = static_cast<QPieSeries*>(m_series[0])->slices();
        for (std::size_t i = 0; i < chart.series.size(); ++i) {
            slices[static_cast<qsizetype>(i)]->setBrush(look.toned(chart.series[i].colour));
            slices[static_cast<qsizetype>(i)]->setPen(edge);
        }
        return;
    }
    QColor line = look.palette.color(QPalette::Text), grid = line;
    line.setAlpha(lineAlpha);
    grid.setAlpha(gridAlpha);
    for (QAbstractAxis* axis :
         std::initializer_list<QAbstractAxis*>{m_categories, m_values, m_secondValues}) {
        if (axis) {
            axis->setLinePen(QPen(line, 1));
            axis->setGridLinePen(QPen(grid, 1));
        }
    }
    if (chart.shape == Shape::boxes) {
        auto& boxes = *static_cast<QBoxPlotSeries*>(m_series[0]);
        boxes.setPen(QPen(look.ink(), 1.4));
        const QList<QBoxSet*> sets = boxes.boxSets();
        for (std::size_t i = 0; i < chart.boxes.size(); ++i) {
            sets[static_cast<qsizetype>(i)]->setBrush(look.toned(chart.colourOfBox(i)));
        }
        return;
    }
    std::array<int, 2> next{};
    for (const BarSeries& of : chart.series) {
        const std::size_t axis = of.onSecond ? 1 : 0;
        const qsizetype place = of.onSecond && m_series.size() > 1 ? 1 : 0;
        QBarSet& set =
            *static_cast<QAbstractBarSeries*>(m_series[place])->barSets()[next.at(axis)++];
        set.setBrush(look.toned(of.colour));
        set.setPen(edge);
    }
}

void ChartScene::paint(QPainter& painter, const QSizeF& size, const ChartArea& area) {
    m_scene.setSceneRect(QRectF(QPointF(), size));
    m_chart->resize(size);
    m_chart->setPlotArea(area.rect);
    for (QAbstractSeries* of : m_series) {
        if (auto* bars = qobject_cast<QAbstractBarSeries*>(of)) {
            bars->setBarWidth(area.barShare(m_shown));
        } else if (auto* boxes = qobject_cast<QBoxPlotSeries*>(of)) {
            boxes->setBoxWidth(area.barShare(m_shown));
        }
    }
    m_chart->layout()->invalidate(); // the plot area alone would not move the axes
    m_chart->layout()->activate();
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing,
                          m_shown.shape == Shape::ring || m_shown.shape == Shape::boxes);
    m_scene.render(&painter, QRectF(QPointF(), size), QRectF(QPointF(), size),
                   Qt::IgnoreAspectRatio);
    painter.restore();
}

} // namespace sparkout
