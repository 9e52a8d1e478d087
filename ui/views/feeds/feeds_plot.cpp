// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feeds/feeds_plot.h"

#include "ui/plot/feed_text.h"
#include "ui/plot/hair_line.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/quantity_line.h"
#include "ui/text/names.h"

#include <algorithm>
#include <iterator>

namespace sparkout {

namespace {

constexpr double valuesPad = 0.06; ///< margin, as a share of the visible values
constexpr float spreadAlpha = 0.25F;

} // namespace

FeedsPlot::FeedsPlot(QWidget* parent)
    : ViewPlot(parent)
    , m_grid(*this, m_chart)
    , m_momentLine(new HairLine(*this, HairLine::Role::moment))
    , m_hairLine(new HairLine(*this)) {
    setPlottingHints(QCP::phFastPolylines);
    setMouseTracking(true);
    onClick([this](const QPointF& at) {
        if (const QCPAxisRect* rect = axisRectAt(at); rect && !m_chart.isEmpty()) {
            emit timeClicked(scale().time_s(rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x())));
        }
    });
    setBuilt();
}

void FeedsPlot::setRun(OutcomePtr outcome, const std::vector<int>& shown) {
    const bool sameGrid = !m_chart.isEmpty() && shown.size() == m_chart.columnCount()
                          && outcome->feeds.operation == series().operation;
    const QString axis = timeLabel();
    m_chart.setRun(std::move(outcome), shown);
    if (!sameGrid) {
        buildGrid();
        retranslate();
        emit gridBuilt();
    } else if (timeLabel() != axis) {
        showScale();
    }
    const double end_s = series().end_s, from_s = visibleFrom_s(), to_s = visibleTo_s();
    const bool inside = to_s > from_s && from_s < end_s;
    showTimes(inside ? from_s : 0, inside ? std::min(to_s, end_s) : end_s);
}

void FeedsPlot::setAxis(CycleAxis axis) {
    m_chart.setAxis(axis);
    showScale();
    showTimes(visibleFrom_s(), visibleTo_s());
}

void FeedsPlot::showScale() {
    m_hairLine->setAt({});
    setMoment(m_moment_s);
    m_grid.label();
}

void FeedsPlot::setMoment(std::optional<double> time_s) {
    m_moment_s = time_s;
    m_momentLine->setAt(time_s ? std::optional(scale().at(*time_s)) : std::nullopt);
}

// --- building -----------------------------------------------------------------------------------

void FeedsPlot::buildGrid() {
    m_curves.clear();
    m_grid.build();
    for (std::size_t i = 0; i < m_chart.columnCount(); ++i) {
        addCurves(i);
    }
    m_values = {};
    linkAxes();
    showChoice();
    emit contentChanged();
    restyle();
}

void FeedsPlot::addCurves(std::size_t column) {
    const auto add = [&](std::size_t row, QCPAxis::AxisType side,
                         std::initializer_list<Quantity> quantities) {
        for (const Quantity quantity : quantities) {
            addCurve(column, quantity, m_grid.columns()[column].rects[row]->axis(side));
        }
    };
    add(0, QCPAxis::atLeft, {Quantity::actual, Quantity::programmed});
    add(1, QCPAxis::atRight, {Quantity::came, Quantity::left});
    add(1, QCPAxis::atLeft, {Quantity::actualSum, Quantity::programmedSum});
    if (m_chart.hasAxialFeed()) {
        add(2, QCPAxis::atRight, {Quantity::force});
        add(2, QCPAxis::atLeft, {Quantity::axialFeed});
    } else {
        add(2, QCPAxis::atLeft, {Quantity::force});
    }
}

void FeedsPlot::addCurve(std::size_t column, Quantity quantity, QCPAxis* value) {
    const auto add = [&](Edge edge) {
        QCPGraph* graph = addGraph(value->axisRect()->axis(QCPAxis::atBottom), value);
        m_curves.push_back({column, quantity, edge, graph});
        return graph;
    };
    if (FeedsChart::hasSpread(quantity)) {
        QCPGraph* low = add(Edge::low);
        add(Edge::high)->setChannelFillGraph(low);
    }
    add(Edge::mean);
}

void FeedsPlot::linkAxes() {
    const auto changed = QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged);
    for (const QCPAxisRect* rect : axisRects()) {
        connect(rect->axis(QCPAxis::atBottom), changed, this, &FeedsPlot::onTimesChanged);
        for (const auto type : {QCPAxis::atLeft, QCPAxis::atRight}) {
            QCPAxis* axis = rect->axis(type);
            connect(axis, changed, this,
                    [this, axis](const QCPRange& range) { onValuesChanged(axis, range); });
        }
    }
}

QCPGraph* FeedsPlot::curve(int column, Quantity quantity, Edge edge) const {
    const auto found = std::ranges::find_if(m_curves, [&](const Curve& c) {
        return static_cast<int>(c.column) == column && c.quantity == quantity && c.edge == edge;
    });
    return found == m_curves.end() ? nullptr : found->graph;
}

// --- what is in sight ---------------------------------------------------------------------------

void FeedsPlot::showTimes(double from_s, double to_s) {
    if (m_chart.isEmpty() || !(to_s > from_s)) {
        return;
    }
    const Detail detail = m_chart.detail();
    const FeedsChart::Steps steps = m_chart.steps();
    m_chart.setTimes(from_s, to_s);
    m_linking = true;
    for (const QCPAxisRect* rect : axisRects()) {
        style::setSafeRange(*rect->axis(QCPAxis::atBottom), scale().at(from_s), scale().at(to_s));
    }
    m_linking = false;
    fill();
    fillBands();
    scaleValues();
    if (detail != m_chart.detail()) {
        m_grid.label();
    }
    if (detail != m_chart.detail() || steps != m_chart.steps()) {
        emit contentChanged();
    }
    emit timesChanged();
}

void FeedsPlot::onTimesChanged(const QCPRange& range) {
    if (m_linking) {
        return;
    }
    // Pan and zoom stay within the cycle, and wider than a thousandth of a revolution.
    const double end = scale().at(series().end_s);
    const double size = std::clamp(range.size(), end * 1e-6, end);
    const double low = std::clamp(range.lower, 0.0, end - size);
    showTimes(scale().time_s(low), scale().time_s(low + size));
}

void FeedsPlot::onValuesChanged(QCPAxis* axis, const QCPRange& range) {
    if (m_linking) {
        return;
    }
    m_linking = true;
    for (std::size_t row = 0; row < FeedsGrid::rowCount; ++row) {
        const bool here = std::ranges::any_of(m_grid.columns(), [&](const auto& column) {
            return column.rects[row] == axis->axisRect();
        });
        if (!here) {
            continue;
        }
        for (const FeedsGrid::Column& column : m_grid.columns()) {
            column.rects[row]->axis(axis->axisType())->setRange(range);
        }
        const QCPAxisRect* first = m_grid.columns().front().rects[row];
        m_values[row] = {true, first->axis(QCPAxis::atLeft)->range(),
                         first->axis(QCPAxis::atRight)->range()};
    }
    m_linking = false;
    m_grid.fit();
}

PlotHistory::State FeedsPlot::visibleRange() const {
    PlotHistory::State state{visibleFrom_s(), visibleTo_s()};
    for (const RowValues& row : m_values) {
        const RowValues v = row.own ? row : RowValues{};
        state.insert(state.end(),
                     {v.own ? 1.0 : 0.0, v.left.lower, v.left.upper, v.right.lower, v.right.upper});
    }
    return state;
}

void FeedsPlot::setVisibleRange(const PlotHistory::State& state) {
    constexpr std::size_t perRow = 5;
    if (m_chart.isEmpty() || state.size() != 2 + perRow * FeedsGrid::rowCount) {
        return;
    }
    m_linking = true;
    for (std::size_t row = 0; row < FeedsGrid::rowCount; ++row) {
        const double* v = state.data() + 2 + perRow * row;
        m_values[row] = {v[0] > 0, QCPRange(v[1], v[2]), QCPRange(v[3], v[4])};
        for (const FeedsGrid::Column& column : m_grid.columns()) {
            if (m_values[row].own) {
                column.rects[row]->axis(QCPAxis::atLeft)->setRange(m_values[row].left);
                column.rects[row]->axis(QCPAxis::atRight)->setRange(m_values[row].right);
            }
        }
    }
    m_linking = false;
    const double end_s = series().end_s;
    const double from_s = std::min(state[0], end_s);
    const bool inside = from_s < end_s;
    showTimes(inside ? from_s : 0, inside ? std::min(state[1], end_s) : end_s);
}

QList<QCPAxis*> FeedsPlot::movedAxes(QCPAxisRect& rect) const {
    return {rect.axis(QCPAxis::atBottom)};
}

// --- filling ------------------------------------------------------------------------------------

void FeedsPlot::fill() {
    for (const Curve& c : m_curves) {
        QVector<QCPGraphData> points;
        for (const XY& p : m_chart.line(c.column, c.quantity, c.edge)) {
            points.push_back({p.x, p.y});
        }
        c.graph->data()->set(points, true);
    }
}

std::vector<Band> FeedsPlot::stepBands(std::size_t column) const {
    std::vector<Band> bands;
    for (const StepSpan& span : m_chart.stepsOf(column)) {
        const Place& place = span.place;
        const QString name = Names::step(place.step);
        const QString meaning = tr("%1: %2").arg(name, Names::stepMeaning(place.zone, place.step));
        bands.push_back({scale().at(span.start_s),
                         scale().at(span.end_s),
                         stepColour(place.zone, place.step, palette()),
                         name,
                         {},
                         meaning});
    }
    return bands;
}

std::vector<Band> FeedsPlot::stageBands() const {
    std::vector<Band> bands;
    for (const StageSpan& span : series().stages) {
        const bool odd = span.stage % 2 == 1;
        const QColor colour = style::filling(
            style::colour(odd ? style::Drawn::oddStage : style::Drawn::evenStage, palette()),
            odd ? 28 : 38, palette());
        const QString name = tr("stage %1").arg(span.stage);
        bands.push_back({scale().at(span.start_s), scale().at(span.end_s), colour, name,
                         tr("st. %1", "stage, short").arg(span.stage), name});
    }
    return bands;
}

void FeedsPlot::fillBands() {
    for (std::size_t i = 0; i < m_chart.columnCount(); ++i) {
        const std::vector<Band> bands = m_chart.showsSteps() ? stepBands(i) : stageBands();
        for (BandLayer* layer : m_grid.columns()[i].bands) {
            layer->setBands(bands);
        }
    }
}

void FeedsPlot::showChoice() {
    for (const Curve& c : m_curves) {
        c.graph->setVisible(shows(FeedsChart::keyOf(c.quantity))
                            && (c.edge == Edge::mean || shows(FeedsChart::spreadKey)));
    }
    scaleValues();
}

void FeedsPlot::scaleRow(std::size_t row, QCPAxis::AxisType type, double low, double high) {
    const double pad = high > low ? (high - low) * valuesPad : 1;
    for (const FeedsGrid::Column& column : m_grid.columns()) {
        if (!m_values[row].own) {
            style::setSafeRange(*column.rects[row]->axis(type), low - (low == 0 ? 0 : pad),
                                high + pad);
        }
    }
}

void FeedsPlot::scaleValues() {
    const auto extremes = [this](std::initializer_list<Quantity> quantities) {
        return m_chart.extremes(quantities, choice());
    };
    m_linking = true;
    const auto feed = extremes({Quantity::programmed, Quantity::actual});
    scaleRow(0, QCPAxis::atLeft, std::min(0.0, feed.first), feed.second);
    const auto sums = extremes({Quantity::programmedSum, Quantity::actualSum});
    scaleRow(1, QCPAxis::atLeft, detail() == Detail::stroke ? 0 : sums.first, sums.second);
    const auto radii = extremes({Quantity::came, Quantity::left});
    scaleRow(1, QCPAxis::atRight, radii.first, radii.second);
    const double force = extremes({Quantity::force}).second;
    if (m_chart.hasAxialFeed()) {
        scaleRow(2, QCPAxis::atLeft, 0, extremes({Quantity::axialFeed}).second);
        scaleRow(2, QCPAxis::atRight, 0, force);
    } else {
        scaleRow(2, QCPAxis::atLeft, 0, force);
    }
    m_linking = false;
    m_grid.fit();
}

// --- reading ------------------------------------------------------------------------------------

ReadCurves FeedsPlot::readCurves() const {
    ReadCurves curves;
    for (const Curve& c : m_curves) {
        if (c.edge == Edge::mean && shows(FeedsChart::keyOf(c.quantity))) {
            curves.push_back(m_chart.readCurve(c.column, c.quantity));
        }
    }
    if (m_beside) {
        std::ranges::move(m_beside(), std::back_inserter(curves));
    }
    return curves;
}

CursorSubject FeedsPlot::cursorSubject() {
    return {[this] { return timeLabel(); },
            [this] { return QCPRange(0, scale().at(series().end_s)); },
            [this] { return readCurves(); }, [this](double x) { return scale().time_s(x); },
            [this](double time_s) { return scale().at(time_s); }};
}

void FeedsPlot::onMouse(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) {
        return;
    }
    for (std::size_t i = 0; i < m_grid.columns().size(); ++i) {
        const FeedsGrid::Column& column = m_grid.columns()[i];
        for (std::size_t row = 0; row < FeedsGrid::rowCount; ++row) {
            const QCPAxisRect* rect = column.rects[row];
            if (!rect->rect().contains(event->pos())) {
                continue;
            }
            const double x = rect->axis(QCPAxis::atBottom)->pixelToCoord(event->pos().x());
            m_hairLine->setAt(x);
            emit pointed(feedText(m_chart.points(i), scale().time_s(x), series(),
                                  detail() == Detail::stroke));
            const Band* band = column.bands[row]->bandAt(x);
            emit pointedBand(band ? band->meaning : QString());
            return;
        }
    }
    pointAway();
}

void FeedsPlot::pointAway() {
    m_hairLine->setAt({});
    ViewPlot::pointAway();
    emit pointedBand({});
}

// --- look ---------------------------------------------------------------------------------------

QColor FeedsPlot::colourOf(Quantity quantity) const {
    return toned(style::drawnAs(quantity));
}

QColor FeedsPlot::stepColour(Zone zone, Step step, const QPalette& palette) {
    const auto index = static_cast<std::size_t>(strokeStep(zone, step));
    return style::thinned(tone(style::stepOfStroke(index, palette), palette),
                          style::isDark(palette) ? 75 : 85);
}

void FeedsPlot::restyle() {
    ViewPlot::restyle();
    for (const Curve& c : m_curves) {
        QColor colour = colourOf(c.quantity);
        if (c.edge == Edge::mean) {
            c.graph->setPen(style::line(style::drawnAs(c.quantity), colour));
        } else {
            colour.setAlphaF(colour.alphaF() * spreadAlpha);
            c.graph->setPen(Qt::NoPen);
            c.graph->setBrush(c.edge == Edge::high ? QBrush(colour) : QBrush(Qt::NoBrush));
        }
    }
    m_grid.restyle();
    fillBands();
}

void FeedsPlot::takeLook(bool) {
    if (!m_chart.isEmpty()) {
        restyle();
        m_grid.fit();
    }
}

void FeedsPlot::setTexts() {
    m_grid.label();
    fillBands();
}

void FeedsPlot::resizeEvent(QResizeEvent* event) {
    m_grid.fit();
    ViewPlot::resizeEvent(event);
}

LegendEntries FeedsPlot::legendEntries() const {
    LegendEntries entries;
    if (m_chart.isEmpty()) {
        return entries;
    }
    for (const Quantity quantity : {Quantity::programmed, Quantity::actual, Quantity::came,
                                    Quantity::left, Quantity::axialFeed, Quantity::force}) {
        if (quantity != Quantity::axialFeed || m_chart.hasAxialFeed()) {
            entries.push_back(lineEntry(FeedsChart::keyOf(quantity),
                                        style::line(style::drawnAs(quantity), colourOf(quantity)),
                                        quantityName(quantity)));
        }
    }
    const QColor grey = style::thinned(palette().color(QPalette::Text), 60);
    entries.push_back({grey, Qt::NoPen, tr("spread over the radii"), FeedsChart::spreadKey,
                       shows(FeedsChart::spreadKey)});
    for (const auto& [zone, step] : m_chart.steps()) {
        // The codes above the bands identify them in print without colours.
        const QString name = strokeStepName(strokeStep(zone, step));
        entries.push_back({stepColour(zone, step, palette()), Qt::NoPen,
                           name.isEmpty() ? Names::stepMeaning(zone, step) : name});
    }
    return entries;
}

} // namespace sparkout
