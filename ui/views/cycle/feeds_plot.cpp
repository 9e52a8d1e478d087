// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/feeds_plot.h"

#include "ui/chart/painted_layer.h"
#include "ui/chart/plot_cursors.h"
#include "ui/chart/quantity_colour.h"
#include "ui/text/names.h"

#include <QMouseEvent>

#include <algorithm>
#include <iterator>

namespace sparkout {

namespace {

constexpr double leastTimes = 1e-6; ///< narrowest visible range, as a share of the cycle
}

CyclePlot::CyclePlot(QWidget* parent)
    : ChartPlot(parent)
    , m_momentLine(new HairLine(*this, HairLine::Role::moment))
    , m_hairLine(new HairLine(*this)) {
    setPlottingHints(QCP::phFastPolylines);
    setMouseTracking(true);
    onClick([this](const QPointF& at) {
        if (const auto place = placeAt(at)) {
            emit timeClicked(times().scale.time_s(place->x));
        }
    });
}

void CyclePlot::setMoment(std::optional<double> time_s) {
    m_moment_s = time_s;
    m_momentLine->setAt(time_s ? std::optional(times().scale.at(*time_s)) : std::nullopt);
}

// --- the visible times --------------------------------------------------------------------------

void CyclePlot::follow() {
    m_isFollowing = true;
    takeCharts();
    if (const CycleTimes& of = times(); cellCount() > 0 && of.to_s > of.from_s) {
        style::setSafeRange(across(), of.scale.at(of.from_s), of.scale.at(of.to_s));
    }
    fitValues();
    m_isFollowing = false;
    if (timeLabel() != m_label) { // another unit
        m_label = timeLabel();
        m_hairLine->setAt({});
    }
    setMoment(m_moment_s);
}

void CyclePlot::cellsBuilt() {
    if (cellCount() > 0) { // the axes of the other cells follow
        connect(&across(), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
                &CyclePlot::onTimesChanged);
    }
}

void CyclePlot::onTimesChanged(const QCPRange& range) {
    if (m_isFollowing) {
        return;
    }
    const CycleTimes& of = times();
    const double end = of.scale.at(of.end_s);
    const double size = std::clamp(range.size(), end * leastTimes, end);
    const double low = std::clamp(range.lower, 0.0, end - size);
    emit timesWanted(of.scale.time_s(low), of.scale.time_s(low + size));
}

void CyclePlot::showChoice() {
    follow();
}

QList<QCPAxis*> CyclePlot::movedAxes(QCPAxisRect& rect) const {
    return {rect.axis(QCPAxis::atBottom)};
}

// --- reading ------------------------------------------------------------------------------------

CursorSubject CyclePlot::cursorSubject() {
    return {[this] { return timeLabel(); },
            [this] { return QCPRange(0, times().scale.at(times().end_s)); },
            [this] { return readCurves(); }, [this](double x) { return times().scale.time_s(x); },
            [this](double time_s) { return times().scale.at(time_s); }};
}

void CyclePlot::onMouse(QMouseEvent* event) {
    if (event->buttons() != Qt::NoButton) {
        return;
    }
    const auto place = placeAt(event->position());
    m_hairLine->setAt(place ? std::optional(place->x) : std::nullopt);
    const BandLayer* const layer = place ? bands(*cellAt(event->position())) : nullptr;
    const Band* const band = layer ? layer->bandAt(place->x) : nullptr;
    setToolTip(band ? band->meaning : QString());
    ViewPlot::onMouse(event);
}

void CyclePlot::pointAway() {
    m_hairLine->setAt({});
    setToolTip({});
    ViewPlot::pointAway();
}

FeedsPlot::FeedsPlot(QWidget* parent) : CyclePlot(parent) {
    connect(this, &CyclePlot::timesWanted, this, &FeedsPlot::showTimes);
    setGrid([this] { return made(); });
}

ChartGrid FeedsPlot::made() const {
    ChartGrid grid = m_chart.grid(choice());
    for (std::size_t i = 0; i < grid.cells.size(); ++i) {
        if (const RowValues& row = m_values[i / grid.columns]; !row.left.empty()) {
            grid.cells[i].up.range = row.left;
            grid.cells[i].second.range = row.right;
        }
    }
    return grid;
}

void FeedsPlot::setRun(OutcomePtr outcome, const std::vector<int>& shown) {
    const bool sameGrid = !m_chart.isEmpty() && shown.size() == m_chart.columnCount()
                          && outcome->feeds.operation == series().operation;
    m_chart.setRun(std::move(outcome), shown);
    if (!sameGrid) {
        m_values = {};
    }
    const double end_s = series().end_s, from_s = visibleFrom_s(), to_s = visibleTo_s();
    const bool inside = to_s > from_s && from_s < end_s;
    showTimes(inside ? from_s : 0, inside ? std::min(to_s, end_s) : end_s);
    if (!sameGrid) {
        emit contentChanged();
        emit gridBuilt();
    }
}

void FeedsPlot::setAxis(CycleAxis axis) {
    m_chart.setAxis(axis);
    showTimes(visibleFrom_s(), visibleTo_s());
}

// --- visible range ------------------------------------------------------------------------------

void FeedsPlot::showTimes(double from_s, double to_s) {
    if (m_chart.isEmpty() || !(to_s > from_s)) {
        return;
    }
    const Detail detail = m_chart.detail();
    const FeedsChart::Steps steps = m_chart.steps();
    m_chart.setTimes(from_s, to_s);
    follow();
    if (detail != m_chart.detail() || steps != m_chart.steps()) {
        emit contentChanged();
    }
    emit timesChanged();
}

void FeedsPlot::fit() {
    m_values = {};
    showAll();
}

void FeedsPlot::cellsBuilt() {
    CyclePlot::cellsBuilt();
    for (std::size_t row = 0; row < cellCount() / std::max<std::size_t>(columns(), 1); ++row) {
        for (QCPAxis* axis : {&up(row * columns()), &second(row * columns())}) {
            connect(axis, QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
                    [this, row] { onValuesChanged(row); });
        }
    }
}

void FeedsPlot::onValuesChanged(std::size_t row) {
    if (!isFollowing()) {
        const QCPRange left = up(row * columns()).range(), right = second(row * columns()).range();
        m_values[row] = {{left.lower, left.upper}, {right.lower, right.upper}};
    }
}

PlotHistory::State FeedsPlot::visibleRange() const {
    PlotHistory::State state{visibleFrom_s(), visibleTo_s()};
    for (const RowValues& row : m_values) {
        state.insert(state.end(), {row.left.low, row.left.high, row.right.low, row.right.high});
    }
    return state;
}

void FeedsPlot::setVisibleRange(const PlotHistory::State& state) {
    if (m_chart.isEmpty() || state.size() != 2 + 4 * m_values.size()) {
        return;
    }
    for (std::size_t row = 0; row < m_values.size(); ++row) {
        const double* v = state.data() + 2 + 4 * row;
        m_values[row] = {{v[0], v[1]}, {v[2], v[3]}};
    }
    const double end_s = series().end_s;
    const double from_s = std::min(state[0], end_s);
    const bool inside = from_s < end_s;
    showTimes(inside ? from_s : 0, inside ? std::min(state[1], end_s) : end_s);
}

// --- reading and look ---------------------------------------------------------------------------

ReadCurves FeedsPlot::readCurves() const {
    ReadCurves curves = CyclePlot::readCurves();
    if (m_beside) {
        std::ranges::move(m_beside(), std::back_inserter(curves));
    }
    return curves;
}

LegendEntries FeedsPlot::legendEntries() const {
    LegendEntries entries = CyclePlot::legendEntries();
    if (entries.empty()) {
        return entries;
    }
    std::ranges::sort(entries, {}, &LegendEntry::key);
    const QColor grey = style::thinned(palette().color(QPalette::Text), 60);
    entries.push_back({grey, Qt::NoPen, tr("spread over the radii"), FeedsChart::spreadKey,
                       shows(FeedsChart::spreadKey)});
    for (const auto& [zone, step] : m_chart.steps()) {
        // The codes above the bands identify them in print without colours.
        const QString name = strokeStepName(strokeStep(zone, step));
        entries.push_back({FeedsChart::stepColour(zone, step, palette()), Qt::NoPen,
                           name.isEmpty() ? Names::stepMeaning(zone, step) : name});
    }
    return entries;
}

} // namespace sparkout
