// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/sweep_map.h"

#include "ui/kit/theme.h"
#include "ui/plot/number_ticker.h"
#include "ui/views/sweep/contour_lines.h"

#include <QMouseEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

using style::Drawn;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double mapSignSize = 8, mapChosenSize = 13, mapPresentSize = 12; ///< [px]
constexpr int cellsPerPoint = 4; ///< for the uneven steps of whole numbers
constexpr int scaleWidth = 14;   ///< [px]
constexpr double uneven = 1e-6;  ///< relative to a step; larger deviations are not rounding

/// Viridis: its lightness is uniform, so that it is readable without colours, too.
QCPColorGradient sweepColours(bool dim) {
    constexpr std::array<QRgb, 9> stops{0x440154, 0x472d7b, 0x3b528b, 0x2c728e, 0x21918c,
                                        0x28ae80, 0x5ec962, 0xaddc30, 0xfde725};
    QCPColorGradient gradient;
    gradient.clearColorStops();
    for (std::size_t i = 0; i < stops.size(); ++i) {
        gradient.setColorStopAt(static_cast<double>(i) / (stops.size() - 1),
                                style::dimmed(QColor(stops[i]), dim));
    }
    gradient.setColorInterpolation(QCPColorGradient::ciRGB);
    gradient.setNanHandling(QCPColorGradient::nhTransparent);
    return gradient;
}

/// Cells of equal width along an axis, each with its point of the sweep.
struct Cells {
    double low = 0, high = 0; ///< middles of the first and the last cell
    std::vector<std::size_t> points;
};

Cells cellsOf(const std::vector<double>& places) {
    Cells cells{places.front(), places.back(), {}};
    const double step = (cells.high - cells.low) / static_cast<double>(places.size() - 1);
    bool even = true;
    for (std::size_t i = 0; i < places.size(); ++i) {
        even =
            even && std::abs(places[i] - cells.low - static_cast<double>(i) * step) < uneven * step;
    }
    const std::size_t count = even ? places.size() : places.size() * cellsPerPoint;
    for (std::size_t c = 0; c < count; ++c) {
        const double at =
            cells.low
            + (cells.high - cells.low) * static_cast<double>(c) / static_cast<double>(count - 1);
        const auto nearest =
            std::ranges::min_element(places, {}, [at](double p) { return std::abs(p - at); });
        cells.points.push_back(static_cast<std::size_t>(nearest - places.begin()));
    }
    return cells;
}

} // namespace

SweepMap::SweepMap(QWidget* parent)
    : ViewPlot(parent)
    , m_rect(addRect())
    , m_map(new QCPColorMap(across(), up()))
    , m_scale(new QCPColorScale(this)) {
    m_map->setInterpolate(false);
    m_map->setTightBoundary(false);
    plotLayout()->addElement(0, 1, m_scale);
    m_scale->setType(QCPAxis::atRight);
    m_scale->setBarWidth(scaleWidth);
    m_scale->axis()->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker));
    m_scale->setRangeDrag(false);
    m_scale->setRangeZoom(false);
    m_map->setColorScale(m_scale);
    auto* const together = new QCPMarginGroup(this);
    m_rect->setMarginGroup(QCP::msBottom | QCP::msTop, together);
    m_scale->setMarginGroup(QCP::msBottom | QCP::msTop, together);
    for (QCPCurve** contour : {&m_limitHalo, &m_limit, &m_holdsHalo, &m_holds}) {
        *contour = addCurve(*m_rect);
    }
    setKeyed(SweepShown::limitKey, {m_limitHalo, m_limit});
    setKeyed(SweepShown::holdsKey, {m_holdsHalo, m_holds});
    m_refused = addMarks(SweepShown::refusedKey);
    m_notReached = addMarks(SweepShown::notReachedKey);
    m_present = addMarks(SweepShown::presentKey);
    m_chosenMark = addMarks(SweepShown::chosenKey);
    connect(this, &QCustomPlot::afterLayout, this, [this] {
        if (style::fitValueAxes(*m_rect, font())) {
            replot(rpQueuedReplot);
        }
    });
    const auto choose = [this](const QPointF& at) {
        if (const auto point = pointAt(at)) {
            emit pointChosen(*point);
        }
    };
    onClick(choose);
    connect(this, &QCustomPlot::mousePress, this, [choose](QMouseEvent* event) {
        if (event->button() == Qt::RightButton) { // opens the menu for this point
            choose(event->position());
        }
    });
    built();
}

QCPGraph* SweepMap::addMarks(int key) {
    QCPGraph* const graph = addLine(*m_rect);
    graph->setLineStyle(QCPGraph::lsNone);
    graph->setAdaptiveSampling(false);
    setKeyed(key, {graph});
    return graph;
}

void SweepMap::setSweep(SweepShown shown) {
    m_shown = std::move(shown);
    for (QCPCurve* curve : {m_limitHalo, m_limit, m_holdsHalo, m_holds}) {
        curve->data()->clear();
    }
    m_map->data()->clear();
    if (!empty()) {
        across()->setTicker(QSharedPointer<SweepTicker>::create(m_shown.scaleOf(0)));
        up()->setTicker(QSharedPointer<SweepTicker>::create(m_shown.scaleOf(1)));
        fillCells();
        fillContours();
    }
    fillMarks();
    contentSet();
}

void SweepMap::setMarks(SweepShown shown) {
    m_shown = std::move(shown);
    fillMarks();
    emit contentChanged(); // the legend names the marks
}

double SweepMap::worstShown(std::size_t point) const {
    const auto worst = worstAt(m_shown.result->points[point], m_shown.entry);
    return worst ? m_shown.shownAt(point, *worst) : nan;
}

void SweepMap::fillCells() {
    const Cells columns = cellsOf(m_shown.placesOf(0)), rows = cellsOf(m_shown.placesOf(1));
    m_map->data()->setSize(static_cast<int>(columns.points.size()),
                           static_cast<int>(rows.points.size()));
    m_map->data()->setRange({columns.low, columns.high}, {rows.low, rows.high});
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (std::size_t x = 0; x < columns.points.size(); ++x) {
        for (std::size_t y = 0; y < rows.points.size(); ++y) {
            const double value =
                worstShown(m_shown.result->index(columns.points[x], rows.points[y]));
            m_map->data()->setCell(static_cast<int>(x), static_cast<int>(y), value);
            if (std::isfinite(value)) {
                low = std::min(low, value);
                high = std::max(high, value);
            }
        }
    }
    const double least = std::max({std::abs(low), std::abs(high), 1e-6}) * 1e-6;
    m_map->setDataRange(low > high           ? QCPRange(0, 1)
                        : high - low < least ? QCPRange(low - least, high + least)
                                             : QCPRange(low, high));
}

void SweepMap::fillContours() {
    const SweepResult& sweep = *m_shown.result;
    const std::vector<double> columns = m_shown.placesOf(0), rows = m_shown.placesOf(1);
    const auto draw = [&](QCPCurve& halo, QCPCurve& curve, const auto& at) {
        int t = 0;
        for (const QLineF& piece : zeroLines(columns, rows, at)) {
            for (QCPCurve* of : {&halo, &curve}) {
                of->addData(t, piece.x1(), piece.y1());
                of->addData(t + 1, piece.x2(), piece.y2());
                of->addData(t + 2, nan, nan); // a gap
            }
            t += 3;
        }
    };
    draw(*m_limitHalo, *m_limit, [&](std::size_t i, std::size_t j) {
        const SweepPoint& point = sweep.points[sweep.index(i, j)];
        const auto worst = worstAt(point, m_shown.entry);
        return worst ? point.values[*worst].margin : nan;
    });
    draw(*m_holdsHalo, *m_holds, [&](std::size_t i, std::size_t j) {
        const SweepPoint& point = sweep.points[sweep.index(i, j)];
        for (std::size_t q = 0; q < point.values.size(); ++q) {
            if (sweep.quantities[q].name == "least_margin") {
                return point.values[q].value;
            }
        }
        return nan;
    });
}

std::vector<ChartSeries> SweepMap::signs() const {
    return empty() ? std::vector<ChartSeries>()
                   : m_shown.statusMarks(mapSignSize,
                                         [this](std::size_t i) { return m_shown.placeOf(i, 1); });
}

void SweepMap::fillMarks() {
    for (QCPGraph* marks : {m_refused, m_notReached, m_present, m_chosenMark}) {
        marks->data()->clear();
    }
    if (empty()) {
        return;
    }
    for (const ChartSeries& of : signs()) {
        for (const XY& at : of.points) {
            (of.key == SweepShown::refusedKey ? m_refused : m_notReached)->addData(at.x, at.y);
        }
    }
    const auto x = m_shown.presentPlace(0), y = m_shown.presentPlace(1);
    if (x && y) {
        m_present->addData(*x, *y);
    }
    if (m_shown.chosen) {
        m_chosenMark->addData(m_shown.placeOf(*m_shown.chosen, 0),
                              m_shown.placeOf(*m_shown.chosen, 1));
    }
}

/// Shows all cells.
void SweepMap::fit() {
    if (empty()) {
        return;
    }
    for (const std::size_t input : {std::size_t{0}, std::size_t{1}}) {
        const std::vector<double> places = m_shown.placesOf(input);
        const double from = places.front(), to = places.back();
        const double half = (to - from) / static_cast<double>(2 * (places.size() - 1));
        style::setSafeRange(input == 0 ? *across() : *up(), from - half, to + half);
    }
}

// --- the mouse ----------------------------------------------------------------------------------

std::optional<std::size_t> SweepMap::pointAt(const QPointF& pixel) const {
    if (empty() || !m_rect->rect().contains(pixel.toPoint())) {
        return std::nullopt;
    }
    return m_shown.pointNear(across()->pixelToCoord(pixel.x()), up()->pixelToCoord(pixel.y()));
}

QPointF SweepMap::pixelOf(std::size_t point) const {
    return {across()->coordToPixel(m_shown.placeOf(point, 0)),
            up()->coordToPixel(m_shown.placeOf(point, 1))};
}

QString SweepMap::valuesAt(const QPointF& at) const {
    const auto point = pointAt(at);
    return point ? m_shown.textOf(*point) : QString();
}

CsvTable SweepMap::table() const {
    if (empty()) {
        return {};
    }
    return SweepShown::tableOf(*m_shown.result, m_shown.entry.quantities, [this](std::size_t i) {
        return across()->range().contains(m_shown.placeOf(i, 0))
               && up()->range().contains(m_shown.placeOf(i, 1));
    });
}

// --- look and words -----------------------------------------------------------------------------

void SweepMap::restyle() {
    ViewPlot::restyle();
    QCPAxis& axis = *m_scale->axis();
    style::applyPalette(axis, palette());
    axis.setTickLabelFont(font());
    axis.setLabelFont(font());
    axis.setNumberFormat(QStringLiteral("g"));
    m_map->setGradient(sweepColours(isDimmed()));
    for (QCPCurve* halo : {m_limitHalo, m_holdsHalo}) {
        halo->setPen(QPen(style::dimmed(onMap::dark, isDimmed()), 4));
    }
    m_limit->setPen(QPen(style::dimmed(onMap::light, isDimmed()), 2));
    m_holds->setPen(QPen(style::dimmed(onMap::accent, isDimmed()), 2));
    const QColor stuck = toned(Drawn::sizeNotReached);
    m_refused->setScatterStyle(QCPScatterStyle(
        QCPScatterStyle::ssCross, QPen(toned(Drawn::refused), 2), Qt::NoBrush, mapSignSize));
    m_notReached->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssTriangle, QPen(stuck), stuck, mapSignSize));
    m_present->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDiamond, QPen(onMap::dark, 1.5),
                                               onMap::light, mapPresentSize));
    m_chosenMark->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssSquare, QPen(ink(), 3), Qt::NoBrush, mapChosenSize));
}

void SweepMap::setTexts() {
    if (!empty()) {
        across()->setLabel(SweepText::inputAxis(m_shown.result->inputs[0]));
        up()->setLabel(SweepText::inputAxis(m_shown.result->inputs[1]));
        m_scale->axis()->setLabel(SweepText::axis(*m_shown.result, m_shown.entry, m_shown.margins));
    }
}

LegendEntries SweepMap::legendEntries() const {
    LegendEntries entries;
    if (empty()) {
        return entries;
    }
    if (!m_limit->data()->isEmpty()) {
        entries.push_back(
            lineEntry(SweepShown::limitKey, m_limit->pen(), tr("limit of this result")));
        entries.back().halo = m_limitHalo->pen().color();
    }
    if (!m_holds->data()->isEmpty()) {
        entries.push_back(
            lineEntry(SweepShown::holdsKey, m_holds->pen(), tr("requirements met: edge")));
        entries.back().halo = m_holdsHalo->pen().color();
    }
    if (!m_present->data()->isEmpty()) {
        entries.push_back(areaEntry(SweepShown::presentKey, palette().color(QPalette::Text),
                                    tr("current values")));
        entries.back().swatch = Swatch::rhombus;
    }
    if (!m_chosenMark->data()->isEmpty()) {
        entries.push_back(areaEntry(
            SweepShown::chosenKey, m_chosenMark->scatterStyle().pen().color(), tr("chosen point")));
        entries.back().swatch = Swatch::square;
    }
    for (const ChartSeries& of : signs()) {
        entries.push_back(areaEntry(of.key, toned(std::get<Drawn>(of.colour)), of.name));
    }
    return entries;
}

} // namespace sparkout
