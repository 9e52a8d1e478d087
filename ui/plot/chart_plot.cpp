// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/chart_plot.h"

#include "ui/plot/number_ticker.h"
#include "ui/plot/painted_layer.h"

#include <QLineF>
#include <QMouseEvent>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

constexpr int lastNumberRoom = 20; ///< space beside a lying chart, for half of the last number
constexpr int chartTick = 5;       ///< [px]
constexpr int scaleWidth = 14;     ///< [px]
constexpr double outlineWidth = 1; ///< on either side of a line [px]

QCPScatterStyle markOfSeries(const ChartSeries& series, const QColor& colour, const QColor& edge) {
    using enum ChartSeries::Mark;
    using Style = QCPScatterStyle;
    const double size = series.markSize;
    switch (series.mark) {
    case none: break;
    case disc: return {Style::ssDisc, QPen(colour), colour, size};
    case square: return {Style::ssSquare, QPen(colour, 1.5), colour, size};
    case diamond: return {Style::ssDiamond, QPen(edge, 1.5), colour, size};
    case triangle: return {Style::ssTriangle, QPen(colour), colour, size};
    case ring: return {Style::ssCircle, QPen(colour, 2), Qt::NoBrush, size};
    case cross: return {Style::ssCross, QPen(colour, 2), Qt::NoBrush, size};
    case frame: return {Style::ssSquare, QPen(colour, 3), Qt::NoBrush, size};
    }
    return {};
}

/// Viridis: its lightness is uniform, so that it is readable without colours, too.
QCPColorGradient mapColours(bool dim) {
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

QCPGraph::LineStyle lineOfSeries(const ChartSeries& series) {
    switch (series.kind) {
    case ChartSeries::Kind::steps: return QCPGraph::lsStepLeft;
    case ChartSeries::Kind::points: return QCPGraph::lsNone;
    case ChartSeries::Kind::impulses: return QCPGraph::lsImpulse;
    default: return QCPGraph::lsLine;
    }
}

void setUpChartAxis(QCPAxis& axis, const ChartAxis& of) {
    axis.setLabel(of.label);
    axis.grid()->setVisible(of.hasGrid && !of.names);
    axis.setTickLength(of.names ? 0 : chartTick);
    const int ticks = axis.ticker()->tickCount(); // as many as have room
    style::setLogarithmic(axis, of.isLogarithmic);
    axis.setSubTicks(of.isLogarithmic);
    if (of.names) {
        const QSharedPointer<QCPAxisTickerText> names(new QCPAxisTickerText);
        for (qsizetype i = 0; i < of.names->size(); ++i) {
            names->addTick(static_cast<double>(i), of.names->at(i));
        }
        axis.setTicker(names);
    } else if (of.ticker) {
        axis.setTicker(of.ticker);
    } else if (of.isCounted) {
        axis.setTicker(QSharedPointer<QCPAxisTicker>(new WholeTicker));
    }
    axis.ticker()->setTickCount(ticks);
}

void fitChartAxis(QCPAxis& axis, const ChartAxis& of, const ChartSpan& span) {
    if (!span.empty()) {
        style::setRoomyRange(axis, span.low, span.high, of.room, of.leastRoom);
    }
}

} // namespace

class ChartPlot::ZoneLayer : public PaintedLayer {
public:
    ZoneLayer(QCPAxisRect& rect, const ChartZone& zone, const QColor& area, const QColor& edge)
        : PaintedLayer(rect, QStringLiteral("bands"), Edges::smooth)
        , m_zone(zone)
        , m_area(area)
        , m_edge(edge) {}

protected:
    void draw(QCPPainter* painter) override {
        for (const ChartSpan& range : m_zone.ranges) {
            drawRange(*painter, range);
        }
    }

private:
    void drawRange(QCPPainter& painter, const ChartSpan& range) const {
        const bool isUpright = m_zone.isUpright;
        const QCPAxis& axis = *m_rect->axis(isUpright ? QCPAxis::atBottom : QCPAxis::atLeft);
        const auto [first, last] =
            std::minmax({axis.coordToPixel(range.low), axis.coordToPixel(range.high)});
        const QRectF all = m_rect->rect();
        const double from = std::max(first, (isUpright ? all.left() : all.top()) - 1);
        const double to = std::min(last, (isUpright ? all.right() : all.bottom()) + 1);
        if (to < from) {
            return;
        }
        const QRectF box = isUpright ? QRectF(from, all.top(), to - from, all.height())
                                     : QRectF(all.left(), from, all.width(), to - from);
        painter.setPen(Qt::NoPen);
        painter.setBrush(m_area);
        painter.drawRect(box);
        paintHatch(painter, box, m_zone.hatch, m_edge);
        if (m_zone.hasEdges) {
            painter.setPen(QPen(m_edge, 1));
            painter.drawLine(QLineF(box.topLeft(), isUpright ? box.bottomLeft() : box.topRight()));
            painter.drawLine(
                QLineF(isUpright ? box.topRight() : box.bottomLeft(), box.bottomRight()));
        }
    }

    ChartZone m_zone;
    QColor m_area, m_edge;
};

ChartPlot::ChartPlot(QWidget* parent, int row) : ViewPlot(parent), m_rect(addRect(row)) {
    connect(this, &QCustomPlot::afterLayout, this, [this] {
        if (style::fitValueAxes(*m_rect, font())) {
            replot(rpQueuedReplot);
        }
    });
    for (const auto side : {QCPAxis::atLeft, QCPAxis::atBottom}) {
        connect(m_rect->axis(side), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
                &ChartPlot::followValues);
    }
    const auto clickPlace = [this](const QPointF& at) {
        if (const auto place = placeAt(at)) {
            emit placeClicked(place->x, place->y);
        }
    };
    onClick([this, clickPlace](const QPointF& at) {
        if (const auto found = pointAt(at)) {
            emit pointClicked(found->series, found->point);
        }
        clickPlace(at);
    });
    connect(this, &QCustomPlot::mousePress, this, [clickPlace](QMouseEvent* event) {
        if (event->button() == Qt::RightButton) { // opens the menu for this place
            clickPlace(event->position());
        }
    });
    built();
}

ChartPlot::~ChartPlot() = default;

QCPAxis& ChartPlot::across() const {
    return *m_rect->axis(m_chart.isLying ? QCPAxis::atLeft : QCPAxis::atBottom);
}

QCPAxis& ChartPlot::up() const {
    return *m_rect->axis(m_chart.isLying ? QCPAxis::atBottom : QCPAxis::atLeft);
}

QCPAxis& ChartPlot::second() const {
    return *m_rect->axis(m_chart.isLying ? QCPAxis::atTop : QCPAxis::atRight);
}

void ChartPlot::setChart(Maker make) {
    m_make = std::move(make);
    remake();
    fit();
}

void ChartPlot::remake() {
    setTexts();
    emit contentChanged();
}

void ChartPlot::setTexts() {
    if (m_make) {
        m_chart = m_make();
        setUpAxes();
        drawChart();
    }
}

void ChartPlot::fit() {
    fitChartAxis(across(), m_chart.across, m_chart.places());
    fitChartAxis(second(), m_chart.second, m_chart.values(true));
    fitValues();
}

void ChartPlot::fitValues() {
    fitChartAxis(up(), m_chart.up, m_chart.values());
}

// --- drawing ------------------------------------------------------------------------------------

QColor ChartPlot::colourOf(const ChartColour& colour) const {
    return style::dimmed(chartColour(colour, palette()), isDimmed());
}

QColor ChartPlot::areaOf(const ChartColour& colour, int alpha) const {
    return alpha == 255
               ? colourOf(colour)
               : style::dimmed(style::filling(chartColour(colour, palette()), alpha, palette()),
                               isDimmed());
}

QColor ChartPlot::outlineOf(const ChartSeries& series) const {
    return series.outline.isValid() ? style::dimmed(series.outline, isDimmed())
                                    : colourOf(series.colour);
}

QColor ChartPlot::ribbonOf(const ChartSeries& series) const {
    return style::dimmed(style::thinned(chartColour(series.colour, palette()), series.alpha),
                         isDimmed());
}

QCPScatterStyle ChartPlot::markOf(const ChartSeries& series) const {
    return markOfSeries(series, colourOf(series.colour), outlineOf(series));
}

QPen ChartPlot::penOf(QPen pen, const ChartColour& colour) const {
    pen.setColor(colourOf(colour));
    return pen;
}

void ChartPlot::setUpAxes() {
    setUpChartAxis(across(), m_chart.across);
    setUpChartAxis(up(), m_chart.up);
    setUpChartAxis(second(), m_chart.second);
    second().grid()->setVisible(false);
    across().setRangeReversed(m_chart.isLying != m_chart.across.isReversed);
    if (m_chart.isLying) {
        m_rect->setMinimumMargins(QMargins(0, 0, lastNumberRoom, 0));
    }
    for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) {
        QCPAxis& axis = *m_rect->axis(side);
        const bool isSecond = &axis == &second() && !m_chart.second.label.isEmpty();
        axis.setVisible(isSecond || m_chart.isFramed);
        axis.setTicks(isSecond);
        axis.setTickLabels(isSecond);
    }
    followValues();
}

void ChartPlot::followValues() {
    if (m_chart.perValue > 0) {
        second().setRange(up().range() * m_chart.perValue);
    }
}

void ChartPlot::drawChart() {
    clearPlottables();
    clearItems();
    m_zones.clear();
    m_stacked = nullptr;
    for (const ChartZone& zone : m_chart.zones) {
        if (shows(zone.key)) {
            m_zones.push_back(std::make_unique<ZoneLayer>(
                *m_rect, zone, areaOf(zone.colour, zone.alpha), colourOf(zone.colour)));
        }
    }
    if (m_chart.map) {
        drawMap(*m_chart.map);
    }
    using enum ChartSeries::Kind;
    const auto order = [](const ChartSeries& of) {
        return of.isArea() ? 0 : of.kind == line || of.kind == steps ? 1 : 2;
    };
    for (const int at : {0, 1, 2}) {
        for (const ChartSeries& series : m_chart.series) {
            if (shows(series.key) && order(series) == at) {
                drawSeries(series);
            }
        }
    }
    for (const ChartRule& rule : m_chart.rules) {
        if (shows(rule.key)) {
            addRule(*m_rect, rule.at, rule.isUpright)->setPen(penOf(rule.pen, rule.colour));
        }
    }
}

void ChartPlot::drawSeries(const ChartSeries& series) {
    if (series.kind == ChartSeries::Kind::bars) {
        drawBars(series);
    } else if (series.isArea()) {
        drawArea(series);
    } else if (series.kind == ChartSeries::Kind::path || series.kind == ChartSeries::Kind::ribbon) {
        drawPath(series);
    } else {
        QCPGraph* const graph = addGraphOf(series, series.points);
        graph->setLineStyle(lineOfSeries(series));
        graph->setScatterStyle(markOf(series));
    }
}

void ChartPlot::drawBars(const ChartSeries& series) {
    auto* const bars = new QCPBars(&across(), &up());
    bars->setWidth(series.barWidth);
    bars->setPen(Qt::NoPen);
    bars->setBrush(areaOf(series.colour, series.alpha));
    for (const XY& point : series.points) {
        bars->addData(point.x, point.y);
    }
}

void ChartPlot::drawArea(const ChartSeries& series) {
    const bool isBand = series.kind == ChartSeries::Kind::band;
    std::vector<XY> edge = series.points;
    for (std::size_t i = 0; !isBand && m_stacked && i < edge.size(); ++i) {
        edge[i].y += m_stacked->data()->at(static_cast<int>(i))->value;
    }
    QCPGraph* const below = isBand ? addGraphOf(series, series.lower) : m_stacked;
    QCPGraph* const upper = addGraphOf(series, edge);
    upper->setBrush(areaOf(series.colour, series.alpha));
    upper->setChannelFillGraph(below);
    if (isBand) {
        below->setPen(Qt::NoPen);
        upper->setPen(Qt::NoPen);
    } else {
        m_stacked = upper;
    }
}

QCPGraph* ChartPlot::addGraphOf(const ChartSeries& series, const std::vector<XY>& points) {
    QCPGraph* const graph = addGraph(&across(), series.onSecond ? &second() : &up());
    graph->setAdaptiveSampling(false);
    graph->setPen(penOf(series.pen, series.colour));
    QVector<QCPGraphData> drawn;
    for (const XY& point : points) {
        drawn.emplace_back(point.x, point.y);
    }
    graph->data()->set(drawn, series.kind != ChartSeries::Kind::points);
    return graph;
}

void ChartPlot::drawPath(const ChartSeries& series) {
    const auto add = [&](const QPen& pen) {
        auto* const path = new QCPCurve(&across(), &up());
        QVector<QCPCurveData> drawn;
        for (const XY& point : series.points) {
            drawn.emplace_back(static_cast<double>(drawn.size()), point.x, point.y);
        }
        path->data()->set(drawn, true);
        path->setPen(pen);
        return path;
    };
    QPen pen = penOf(series.pen, series.colour);
    if (series.kind == ChartSeries::Kind::ribbon) {
        pen.setColor(ribbonOf(series));
        pen.setCapStyle(Qt::FlatCap);
        pen.setJoinStyle(Qt::RoundJoin);
        add(pen)->setLayer(QStringLiteral("bands"));
        return;
    }
    if (series.outline.isValid()) {
        add(QPen(outlineOf(series), pen.widthF() + 2 * outlineWidth));
    }
    add(pen)->setScatterStyle(markOf(series));
}

void ChartPlot::addScale() {
    m_scale = new QCPColorScale(this);
    plotLayout()->addElement(0, 1, m_scale);
    m_scale->setType(QCPAxis::atRight);
    m_scale->setBarWidth(scaleWidth);
    m_scale->axis()->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker));
    m_scale->axis()->setNumberFormat(QStringLiteral("g"));
    m_scale->setRangeDrag(false);
    m_scale->setRangeZoom(false);
    auto* const together = new QCPMarginGroup(this);
    m_rect->setMarginGroup(QCP::msBottom | QCP::msTop, together);
    m_scale->setMarginGroup(QCP::msBottom | QCP::msTop, together);
}

void ChartPlot::drawMap(const ChartMap& map) {
    if (!m_scale) {
        addScale();
    }
    style::applyPalette(*m_scale->axis(), palette());
    m_scale->axis()->setTickLabelFont(font());
    m_scale->axis()->setLabelFont(font());
    m_scale->setLabel(map.label);
    auto* const drawn = new QCPColorMap(&across(), &up());
    drawn->setInterpolate(false);
    drawn->setTightBoundary(false);
    const int columns = static_cast<int>(map.columns);
    const int count = static_cast<int>(map.values.size());
    drawn->data()->setSize(columns, count / columns);
    drawn->data()->setRange({map.across.low, map.across.high}, {map.up.low, map.up.high});
    ChartSpan span;
    for (int i = 0; i < count; ++i) {
        const double value = map.values[static_cast<std::size_t>(i)];
        drawn->data()->setCell(i % columns, i / columns, value);
        span.add(value);
    }
    const double least = std::max({std::abs(span.low), std::abs(span.high), 1e-6}) * 1e-6;
    const QCPRange range = span.empty()          ? QCPRange(0, 1)
                           : span.size() < least ? QCPRange(span.low - least, span.high + least)
                                                 : QCPRange(span.low, span.high);
    const QCPColorGradient colours = mapColours(isDimmed());
    m_scale->setDataRange(range);
    m_scale->setGradient(colours);
    drawn->setColorScale(m_scale);
    drawn->setDataRange(range);
    drawn->setGradient(colours);
}

void ChartPlot::restyle() {
    ViewPlot::restyle();
    drawChart();
}

void ChartPlot::showChoice() {
    drawChart();
}

// --- what is shown ------------------------------------------------------------------------------

LegendEntries ChartPlot::legendEntries() const {
    LegendEntries entries;
    const auto add = [&entries](const LegendEntry& entry) {
        const auto same = std::ranges::find(entries, entry.key, &LegendEntry::key);
        if (!entry.text.isEmpty() && same == entries.end()) {
            entries.push_back(entry);
        }
    };
    for (const ChartSeries& of : m_chart.series) {
        const QColor colour = of.kind == ChartSeries::Kind::ribbon ? ribbonOf(of)
                              : of.outline.isValid()               ? ink()
                                                                   : colourOf(of.colour);
        LegendEntry entry = of.isLine() ? lineEntry(of.key, penOf(of.pen, of.colour), of.name)
                                        : areaEntry(of.key, colour, of.name);
        entry.swatch = of.swatch;
        entry.halo = of.isLine() && of.outline.isValid() ? outlineOf(of) : QColor();
        add(entry);
    }
    for (const ChartZone& of : m_chart.zones) {
        LegendEntry entry = areaEntry(of.key, areaOf(of.colour, of.alpha), of.name);
        entry.hatch = of.hatch;
        entry.hatchLine = colourOf(of.colour);
        add(entry);
    }
    for (const ChartRule& of : m_chart.rules) {
        add(lineEntry(of.key, penOf(of.pen, of.colour), of.name));
    }
    return entries;
}

CsvTable ChartPlot::table() const {
    ChartTable whole = m_chart.table ? m_chart.table() : ChartTable();
    CsvTable& cells = whole.cells;
    const auto meets = [](const QCPRange& seen, const ChartSpan& at) {
        return at.empty() || (at.high >= seen.lower && at.low <= seen.upper);
    };
    std::vector<std::vector<CsvCell>> rows;
    for (std::size_t i = 0; i < cells.rows.size(); ++i) {
        const ChartTable::Place place =
            i < whole.places.size() ? whole.places[i] : ChartTable::Place{};
        if (shows(place.key) && meets(across().range(), place.across)
            && meets(up().range(), place.up)) {
            rows.push_back(std::move(cells.rows[i]));
        }
    }
    cells.rows = std::move(rows);
    return std::move(cells);
}

ReadCurves ChartPlot::readCurves() const {
    ReadCurves curves;
    for (const ChartReading& reading : m_chart.readings) {
        if (shows(reading.key)) {
            curves.push_back(reading.curve);
        }
    }
    return curves;
}

QCPRange ChartPlot::readSpan() const {
    return m_chart.readSpan.empty() ? QCPRange()
                                    : QCPRange(m_chart.readSpan.low, m_chart.readSpan.high);
}

// --- the mouse ----------------------------------------------------------------------------------

QPointF ChartPlot::pixelOf(const XY& point) const {
    const double place = across().coordToPixel(point.x), value = up().coordToPixel(point.y);
    return m_chart.isLying ? QPointF(value, place) : QPointF(place, value);
}

std::optional<XY> ChartPlot::placeAt(const QPointF& at) const {
    const QPointF along = m_chart.isLying ? at.transposed() : at;
    return m_rect->rect().contains(at.toPoint())
               ? std::optional(XY{across().pixelToCoord(along.x()), up().pixelToCoord(along.y())})
               : std::nullopt;
}

std::optional<ChartPlot::Point> ChartPlot::pointAt(const QPointF& at) const {
    std::optional<Point> found;
    if (!m_rect->rect().contains(at.toPoint())) {
        return found;
    }
    double nearest = m_chart.reach;
    for (std::size_t of = 0; of < std::min(m_chart.pointed, m_chart.series.size()); ++of) {
        const ChartSeries& series = m_chart.series[of];
        for (std::size_t i = 0; shows(series.key) && i < series.points.size(); ++i) {
            const double away = QLineF(pixelOf(series.points[i]), at).length();
            if (away < nearest) {
                nearest = away;
                found = Point{of, i};
            }
        }
    }
    return found;
}

QString ChartPlot::valuesAt(const QPointF& at) const {
    if (m_chart.pointText) {
        const auto found = pointAt(at);
        return found ? m_chart.pointText(found->series, found->point) : QString();
    }
    const auto place = placeAt(at);
    if (place && m_chart.map) {
        return m_chart.map->text(place->x, place->y);
    }
    return m_chart.placeText && place ? m_chart.placeText(place->x) : QString();
}

} // namespace sparkout
