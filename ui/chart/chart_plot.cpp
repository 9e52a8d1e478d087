// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/chart_plot.h"

#include "ui/chart/chart_matrix.h"
#include "ui/chart/painted_layer.h"
#include "ui/chart/view_plot.h"

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
constexpr double logarithmicFloor = 1e-12; ///< lower end of bars on a logarithmic axis
constexpr double leastSeparate = 6;        ///< width of a bar with a gap beside it [px]

/// Bars with a gap of one pixel, where they meet; narrow ones form an area of one colour, each at
/// least a pixel wide.
class SeparateBars : public QCPBars {
public:
    using QCPBars::QCPBars;

protected:
    void draw(QCPPainter* painter) override {
        const double whole = width();
        const double pixels = std::abs(keyAxis()->coordToPixel(whole) - keyAxis()->coordToPixel(0));
        const bool isNarrow = pixels < leastSeparate;
        setPen(isNarrow ? QPen(brush().color(), 1) : QPen(Qt::NoPen));
        setWidth(isNarrow ? whole : whole * (1 - 1 / pixels));
        QCPBars::draw(painter);
        setWidth(whole);
    }
};

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

ChartPlot::ChartPlot(QWidget* parent, int row) : ViewPlot(parent) {
    m_cells.push_back({addRect(row)});
    connect(this, &QCustomPlot::afterLayout, this, [this] {
        bool isChanged = false;
        for (std::size_t i = 0; !m_matrix && i < cellCount(); ++i) {
            isChanged = style::fitValueAxes(cell(i), font()) || isChanged;
        }
        if (isChanged) {
            replot(rpQueuedReplot);
        }
    });
    follow(cell());
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

QCPTextElement* ChartPlot::heading(std::size_t cell) const {
    return m_cells[cell].heading;
}

BandLayer* ChartPlot::bands(std::size_t cell) const {
    return m_cells[cell].bands.get();
}

QCPAxis& ChartPlot::across(std::size_t cell) const {
    return *m_cells[cell].rect->axis(chart(cell).isLying ? QCPAxis::atLeft : QCPAxis::atBottom);
}

QCPAxis& ChartPlot::up(std::size_t cell) const {
    return *m_cells[cell].rect->axis(chart(cell).isLying ? QCPAxis::atBottom : QCPAxis::atLeft);
}

QCPAxis& ChartPlot::second(std::size_t cell) const {
    return *m_cells[cell].rect->axis(chart(cell).isLying ? QCPAxis::atTop : QCPAxis::atRight);
}

void ChartPlot::setChart(Maker make) {
    m_make = [make = std::move(make)] {
        ChartGrid grid;
        grid.cells.push_back(make());
        return grid;
    };
    remake();
    fit();
}

void ChartPlot::setGrid(GridMaker make) {
    m_make = std::move(make);
    m_builtColumns = 0;
    remake();
    fit();
}

void ChartPlot::remake() {
    setTexts();
    emit contentChanged();
}

void ChartPlot::setTexts() {
    takeCharts();
    followValues();
}

void ChartPlot::takeCharts() {
    if (!m_make) {
        return;
    }
    m_grid = m_make();
    if (m_cells.size() != m_grid.cells.size() || m_builtColumns != m_grid.columns) {
        build();
    }
    for (std::size_t i = 0; i < cellCount(); ++i) {
        setUpAxes(i);
    }
    if (m_caption) {
        m_caption->setText(m_grid.caption);
    }
    if (m_matrix) {
        m_matrix->setUp();
    }
    colourAxes();
    tieSecond();
    drawCharts();
}

void ChartPlot::fit() {
    fitPlaces();
    fitValues();
}

void ChartPlot::fitPlaces() {
    for (std::size_t i = 0; i < cellCount(); ++i) {
        fitChartAxis(across(i), chart(i).across, chart(i).places());
        m_fittedPlaces = across().range();
    }
}

void ChartPlot::fitValues() {
    m_isFitting = true;
    for (std::size_t i = 0; i < cellCount(); ++i) {
        fitChartAxis(second(i), chart(i).second, chart(i).values(true));
        fitChartAxis(up(i), chart(i).up, chart(i).values());
        m_fittedValues = up().range();
    }
    m_isFitting = false;
    followValues();
}

void ChartPlot::refit() {
    if (cellCount() > 0 && m_fittedPlaces.value_or(across().range()) == across().range()) {
        fitPlaces();
    }
    if (hasFittedValues()) {
        fitValues();
    }
}

bool ChartPlot::hasFittedValues() const {
    return cellCount() > 0 && m_fittedValues.value_or(up().range()) == up().range();
}

// --- the cells ----------------------------------------------------------------------------------

void ChartPlot::build() {
    clearPlottables();
    clearItems();
    m_zones.clear();
    m_cells.clear();
    m_matrix.reset();
    m_scale = nullptr;
    plotLayout()->clear();
    auto* const layout = new QCPLayoutGrid;
    layout->setRowSpacing(0);
    plotLayout()->setRowSpacing(0);
    plotLayout()->addElement(0, 0, layout);
    std::vector<QCPAxisRect*> rects;
    std::vector<LineChart>& charts = m_grid.cells;
    for (std::size_t first = 0; first < charts.size(); first += m_grid.columns) {
        const std::size_t end = std::min(first + m_grid.columns, charts.size());
        std::vector<QCPAxisRect*> ofRow;
        const int row = layout->rowCount();
        const bool isHeaded = !charts[first].headings.isEmpty();
        for (std::size_t i = first; i < end; ++i) {
            const int column = static_cast<int>(i - first);
            Cell cell{addRect(isHeaded ? row + 1 : row, column, layout)};
            if (isHeaded) {
                cell.heading = new QCPTextElement(this);
                layout->addElement(row, column, cell.heading);
                layout->setRowStretchFactor(row, 0.001);
            }
            follow(*cell.rect);
            ofRow.push_back(cell.rect);
            m_cells.push_back(std::move(cell));
        }
        if (m_grid.sharesValues) {
            for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight}) {
                tie(ofRow, side);
                const QCPAxisRect* outer = side == QCPAxis::atLeft ? ofRow.front() : ofRow.back();
                connect(outer->axis(side), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged),
                        this, &ChartPlot::followValues);
            }
        }
        rects.insert(rects.end(), ofRow.begin(), ofRow.end());
    }
    tie(rects, QCPAxis::atBottom);
    m_caption = m_grid.caption.isEmpty() ? nullptr : new QCPTextElement(this);
    if (m_caption) {
        plotLayout()->addElement(1, 0, m_caption);
        plotLayout()->setRowStretchFactor(1, 0.001);
    }
    m_builtColumns = m_grid.columns;
    m_fittedPlaces.reset();
    m_fittedValues.reset();
    if (m_grid.sharesValues && !m_cells.empty()) {
        m_matrix = std::make_unique<ChartMatrix>(*this);
    }
    ViewPlot::restyle();
    styleTexts();
    cellsBuilt();
}

void ChartPlot::follow(const QCPAxisRect& rect) {
    for (const auto side : {QCPAxis::atLeft, QCPAxis::atBottom}) {
        connect(rect.axis(side), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
                &ChartPlot::tieSecond);
    }
}

void ChartPlot::styleTexts() {
    const auto look = [this](QCPTextElement* text) {
        if (text) {
            text->setFont(font());
            text->setTextColor(palette().color(QPalette::Text));
        }
    };
    look(m_caption);
    for (const Cell& cell : m_cells) {
        look(cell.heading);
    }
}

/// Makes room for the numbers of the outer axes.
void ChartPlot::followValues() {
    if (m_matrix && !m_isFitting) {
        m_matrix->fit();
    }
}

void ChartPlot::resizeEvent(QResizeEvent* event) {
    if (event->size().isEmpty()) {
        return; // there is nothing to paint on
    }
    followValues();
    ViewPlot::resizeEvent(event);
}

QSize ChartPlot::minimumSizeHint() const {
    return m_matrix ? m_matrix->leastSize() : ViewPlot::minimumSizeHint();
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

void ChartPlot::setUpAxes(std::size_t cell) {
    const LineChart& of = chart(cell);
    QCPAxisRect& rect = *m_cells[cell].rect;
    setUpChartAxis(across(cell), of.across);
    setUpChartAxis(up(cell), of.up);
    setUpChartAxis(second(cell), of.second);
    second(cell).grid()->setVisible(false);
    across(cell).setRangeReversed(of.isLying != of.across.isReversed);
    if (of.isLying) {
        rect.setMinimumMargins(QMargins(0, 0, lastNumberRoom, 0));
    }
    for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) {
        QCPAxis& axis = *rect.axis(side);
        const bool isSecond = &axis == &second(cell) && !of.second.label.isEmpty();
        axis.setVisible(isSecond || of.isFramed);
        axis.setTicks(isSecond);
        axis.setTickLabels(isSecond);
    }
    if (QCPTextElement* const text = heading(cell)) {
        text->setText(of.headings.value(0));
    }
}

/// The colours of the value axes; the palette has set that of texts for all.
void ChartPlot::colourAxes() {
    for (std::size_t i = 0; i < cellCount(); ++i) {
        const auto colourAxis = [this](QCPAxis& axis, const ChartAxis& of) {
            axis.setLabelColor(chartColour(of.colour, palette()));
            axis.setTickLabelColor(axis.labelColor());
        };
        colourAxis(up(i), chart(i).up);
        colourAxis(second(i), chart(i).second);
    }
}

void ChartPlot::tieSecond() {
    for (std::size_t i = 0; i < cellCount(); ++i) {
        if (chart(i).perValue > 0) {
            second(i).setRange(up(i).range() * chart(i).perValue);
        }
    }
}

void ChartPlot::drawCharts() {
    clearPlottables();
    clearItems();
    m_zones.clear();
    for (std::size_t i = 0; i < cellCount(); ++i) {
        m_stacked = nullptr;
        drawCell(i);
    }
}

void ChartPlot::drawCell(std::size_t cell) {
    const LineChart& of = chart(cell);
    std::unique_ptr<BandLayer>& bands = m_cells[cell].bands;
    if (!bands && !of.bands.empty()) {
        bands = std::make_unique<BandLayer>(m_cells[cell].rect, of.namesBands);
    }
    if (bands) {
        bands->setBands(of.bands);
    }
    for (const ChartZone& zone : of.zones) {
        if (shows(zone.key)) {
            m_zones.push_back(std::make_unique<ZoneLayer>(
                *m_cells[cell].rect, zone, areaOf(zone.colour, zone.alpha), colourOf(zone.colour)));
        }
    }
    if (of.map) {
        drawMap(cell, *of.map);
    }
    using enum ChartSeries::Kind;
    const auto order = [](const ChartSeries& series) {
        return series.isArea() ? 0 : series.kind == line || series.kind == steps ? 1 : 2;
    };
    for (const int at : {0, 1, 2}) {
        for (const ChartSeries& series : of.series) {
            if (shows(series.key) && order(series) == at) {
                drawSeries(cell, series);
            }
        }
    }
    for (const ChartRule& rule : of.rules) {
        if (shows(rule.key)) {
            addRule(*m_cells[cell].rect, rule.at, rule.isUpright)
                ->setPen(penOf(rule.pen, rule.colour));
        }
    }
}

void ChartPlot::drawSeries(std::size_t cell, const ChartSeries& series) {
    if (series.kind == ChartSeries::Kind::bars) {
        drawBars(cell, series);
    } else if (series.isArea()) {
        drawArea(cell, series);
    } else if (series.kind == ChartSeries::Kind::path || series.kind == ChartSeries::Kind::ribbon) {
        drawPath(cell, series);
    } else {
        QCPGraph* const graph = addGraphOf(cell, series, series.points);
        graph->setLineStyle(lineOfSeries(series));
        graph->setScatterStyle(markOf(series));
    }
}

void ChartPlot::drawBars(std::size_t cell, const ChartSeries& series) {
    auto* const bars = new SeparateBars(&across(cell), &up(cell));
    bars->setAntialiased(false);
    bars->setWidth(series.barWidth);
    const bool isLogarithmic = chart(cell).up.isLogarithmic;
    bars->setBaseValue(isLogarithmic ? logarithmicFloor : 0);
    bars->setBrush(areaOf(series.colour, series.alpha));
    for (const XY& point : series.points) {
        bars->addData(point.x, isLogarithmic ? std::max(point.y, logarithmicFloor) : point.y);
    }
}

void ChartPlot::drawArea(std::size_t cell, const ChartSeries& series) {
    const bool isBand = series.kind == ChartSeries::Kind::band;
    std::vector<XY> edge = series.points;
    for (std::size_t i = 0; !isBand && m_stacked && i < edge.size(); ++i) {
        edge[i].y += m_stacked->data()->at(static_cast<int>(i))->value;
    }
    QCPGraph* const below = isBand ? addGraphOf(cell, series, series.lower) : m_stacked;
    QCPGraph* const upper = addGraphOf(cell, series, edge);
    upper->setBrush(areaOf(series.colour, series.alpha));
    upper->setChannelFillGraph(below);
    if (isBand) {
        below->setPen(Qt::NoPen);
        upper->setPen(Qt::NoPen);
    } else {
        m_stacked = upper;
    }
}

QCPGraph* ChartPlot::addGraphOf(std::size_t cell, const ChartSeries& series,
                                const std::vector<XY>& points) {
    QCPGraph* const graph = addGraph(&across(cell), series.onSecond ? &second(cell) : &up(cell));
    // Of many points on one pixel only the extremes are drawn.
    graph->setAdaptiveSampling(series.isLine() || series.kind == ChartSeries::Kind::band);
    graph->setPen(penOf(series.pen, series.colour));
    QVector<QCPGraphData> drawn;
    for (const XY& point : points) {
        drawn.emplace_back(point.x, point.y);
    }
    graph->data()->set(drawn, series.kind != ChartSeries::Kind::points);
    return graph;
}

void ChartPlot::drawPath(std::size_t cell, const ChartSeries& series) {
    const auto add = [&](const QPen& pen) {
        auto* const path = new QCPCurve(&across(cell), &up(cell));
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

void ChartPlot::addScale(std::size_t cell) {
    m_scale = new QCPColorScale(this);
    plotLayout()->addElement(0, 1, m_scale);
    m_scale->setType(QCPAxis::atRight);
    m_scale->setBarWidth(scaleWidth);
    m_scale->axis()->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker));
    m_scale->axis()->setNumberFormat(QStringLiteral("g"));
    m_scale->setRangeDrag(false);
    m_scale->setRangeZoom(false);
    auto* const together = new QCPMarginGroup(this);
    m_cells[cell].rect->setMarginGroup(QCP::msBottom | QCP::msTop, together);
    m_scale->setMarginGroup(QCP::msBottom | QCP::msTop, together);
}

void ChartPlot::drawMap(std::size_t cell, const ChartMap& map) {
    if (!m_scale) {
        addScale(cell);
    }
    style::applyPalette(*m_scale->axis(), palette());
    m_scale->axis()->setTickLabelFont(font());
    m_scale->axis()->setLabelFont(font());
    m_scale->setLabel(map.label);
    auto* const drawn = new QCPColorMap(&across(cell), &up(cell));
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
    colourAxes();
    styleTexts();
    drawCharts();
    if (m_matrix) {
        m_matrix->restyle();
    }
}

void ChartPlot::showChoice() {
    drawCharts();
}

// --- displayed charts ---------------------------------------------------------------------------

LegendEntries ChartPlot::legendEntries() const {
    LegendEntries entries;
    const auto add = [&entries](const LegendEntry& entry) {
        const auto same = std::ranges::find(entries, entry.key, &LegendEntry::key);
        if (!entry.text.isEmpty() && same == entries.end()) {
            entries.push_back(entry);
        }
    };
    for (const LineChart& chart : m_grid.cells) {
        for (const ChartSeries& of : chart.series) {
            const QColor colour = of.kind == ChartSeries::Kind::ribbon ? ribbonOf(of)
                                  : of.outline.isValid()               ? ink()
                                                                       : colourOf(of.colour);
            LegendEntry entry = of.isLine() ? lineEntry(of.key, penOf(of.pen, of.colour), of.name)
                                            : areaEntry(of.key, colour, of.name);
            entry.swatch = of.swatch;
            entry.halo = of.isLine() && of.outline.isValid() ? outlineOf(of) : QColor();
            add(entry);
        }
        for (const ChartZone& of : chart.zones) {
            LegendEntry entry = areaEntry(of.key, areaOf(of.colour, of.alpha), of.name);
            entry.hatch = of.hatch;
            entry.hatchLine = colourOf(of.colour);
            add(entry);
        }
        for (const ChartRule& of : chart.rules) {
            add(lineEntry(of.key, penOf(of.pen, of.colour), of.name));
        }
    }
    return entries;
}

CsvTable ChartPlot::table() const {
    const bool isKnown = !m_grid.cells.empty() && chart().table;
    ChartTable whole = isKnown ? chart().table() : ChartTable();
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
    for (const LineChart& chart : m_grid.cells) {
        for (const ChartReading& reading : chart.readings) {
            if (shows(reading.key)) {
                curves.push_back(reading.curve);
            }
        }
    }
    return curves;
}

QCPRange ChartPlot::readSpan() const {
    const ChartSpan& span = chart().readSpan;
    return span.empty() ? QCPRange() : QCPRange(span.low, span.high);
}

// --- the mouse ----------------------------------------------------------------------------------

QPointF ChartPlot::pixelOf(const XY& point) const {
    const double place = across().coordToPixel(point.x), value = up().coordToPixel(point.y);
    return chart().isLying ? QPointF(value, place) : QPointF(place, value);
}

std::optional<std::size_t> ChartPlot::cellAt(const QPointF& at) const {
    const auto found = std::ranges::find_if(
        m_cells, [&at](const Cell& cell) { return cell.rect->rect().contains(at.toPoint()); });
    return found == m_cells.end() ? std::nullopt
                                  : std::optional<std::size_t>(found - m_cells.begin());
}

std::optional<XY> ChartPlot::placeAt(const QPointF& at) const {
    const auto cell = cellAt(at);
    if (!cell) {
        return std::nullopt;
    }
    const QPointF along = chart(*cell).isLying ? at.transposed() : at;
    return XY{across(*cell).pixelToCoord(along.x()), up(*cell).pixelToCoord(along.y())};
}

std::optional<ChartPlot::Point> ChartPlot::pointAt(const QPointF& at) const {
    std::optional<Point> found;
    if (cellAt(at) != 0U) {
        return found;
    }
    double nearest = chart().reach;
    for (std::size_t of = 0; of < std::min(chart().pointed, chart().series.size()); ++of) {
        const ChartSeries& series = chart().series[of];
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
    if (!m_cells.empty() && chart().pointText) {
        const auto found = pointAt(at);
        return found ? chart().pointText(found->series, found->point) : QString();
    }
    const auto cell = cellAt(at);
    if (!cell) {
        return {};
    }
    const XY place = *placeAt(at);
    const LineChart& of = chart(*cell);
    return of.map         ? of.map->text(place.x, place.y)
           : of.placeText ? of.placeText(place.x)
                          : QString();
}

} // namespace sparkout
