// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/feeds/traces_plot.h"

#include "core/project/measured.h"
#include "core/units.h"
#include "ui/plot/hair_line.h"
#include "ui/plot/plot_cursors.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_line.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "words/measured_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

using style::Drawn;

constexpr int mostTraceCells = 3;
constexpr QSize legibleTrace(120, 80);
constexpr double tracePad = 0.06; ///< margin, as a share of the visible values
constexpr int besideTrace = 16;   ///< beside the numbers and the name of an axis
constexpr int aroundTrace = 10;   ///< above and below a plot, besides its lines of text

QString quantityOf(FitSource source) {
    return QCoreApplication::translate("Measured", wordsOf(source).text);
}

/// Differences of sizes are micrometres.
double differenceFactor(FitSource source) {
    return source == FitSource::size ? units::umPerMm : 1;
}

QString differenceUnit(FitSource source) {
    return unitText(source == FitSource::size ? "µm" : unitOf(source));
}

/// Interpolates between samples; empty outside them.
std::optional<double> betweenSamples(const std::vector<double>& times,
                                     const std::vector<double>& values, double time_s) {
    if (times.empty() || time_s < times.front() || time_s > times.back()) {
        return {};
    }
    const auto after = std::ranges::upper_bound(times, time_s);
    if (after == times.begin() || after == times.end()) {
        return after == times.end() ? values.back() : values.front();
    }
    const auto i = static_cast<std::size_t>(after - times.begin());
    const double span = times[i] - times[i - 1];
    const double share = span > 0 ? (time_s - times[i - 1]) / span : 1;
    return values[i - 1] + share * (values[i] - values[i - 1]);
}

std::optional<double> traceValue(const TraceComparison& trace, TracesPlot::Key key, double time_s) {
    const auto measured = betweenSamples(trace.time_s, trace.measured, time_s);
    const auto simulated = betweenSamples(trace.time_s, trace.predicted, time_s);
    if (!measured || !simulated) {
        return {};
    }
    switch (key) {
    case TracesPlot::measuredKey: return measured;
    case TracesPlot::simulatedKey: return simulated;
    case TracesPlot::differenceKey: break;
    }
    return (*measured - *simulated) * differenceFactor(trace.source);
}

constexpr std::array traceKeys{TracesPlot::measuredKey, TracesPlot::simulatedKey,
                               TracesPlot::differenceKey};
constexpr std::array drawnParts{Drawn::measuredValue, Drawn::simulatedValue,
                                Drawn::measuredDifference};

} // namespace

TracesPlot::TracesPlot(QWidget* parent)
    : ViewPlot(parent)
    , m_momentLine(new HairLine(*this, HairLine::Role::moment))
    , m_hairLine(new HairLine(*this)) {
    setPlottingHints(QCP::phFastPolylines);
    setMouseTracking(true);
    onClick([this](const QPointF& at) {
        if (const Cell* cell = cellAt(at)) {
            emit timeClicked(
                m_scale.time_s(cell->rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x())));
        }
    });
    connect(this, &QCustomPlot::afterLayout, this, &TracesPlot::afterLayouting);
    built();
}

// --- building -----------------------------------------------------------------------------------

void TracesPlot::setTraces(TraceComparisonsPtr traces, const Project& project) {
    m_hasZones = project.operation->hasZones;
    m_traces = std::move(traces);
    build();
    fill();
    showTimes(m_scale, m_from_s, m_to_s, m_timeLabel);
}

void TracesPlot::build() {
    clearGraphs();
    m_cells.clear();
    plotLayout()->clear();
    plotLayout()->setRowSpacing(0);
    for (std::size_t i = 0; m_traces && i < m_traces->size(); ++i) {
        addCell((*m_traces)[i]);
    }
    label();
    showChoice();
    restyle();
    updateGeometry();
    emit contentChanged();
}

int TracesPlot::columns() const {
    return std::clamp(static_cast<int>(m_cells.size()), 1, mostTraceCells);
}

void TracesPlot::addCell(const TraceComparison& trace) {
    auto cell = std::ranges::find_if(m_cells, [&](const Cell& one) {
        return one.source == trace.source && one.place == trace.place;
    });
    if (cell == m_cells.end()) {
        const int index = static_cast<int>(m_cells.size());
        const int row = 2 * (index / mostTraceCells), column = index % mostTraceCells;
        auto* header = new QCPTextElement(this);
        plotLayout()->addElement(row, column, header);
        plotLayout()->setRowStretchFactor(row, 0.001);
        QCPAxisRect* rect = addRect(row + 1, column);
        QCPAxis* const right = rect->axis(QCPAxis::atRight);
        right->setVisible(true);
        right->grid()->setVisible(false);
        rect->axis(QCPAxis::atTop)->setVisible(true);
        rect->axis(QCPAxis::atTop)->setTicks(false);
        connect(rect->axis(QCPAxis::atBottom),
                QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
                [this](const QCPRange& range) {
                    if (!m_linking) {
                        // Pan and zoom stay within the cycle.
                        const double end = m_scale.at(m_end_s);
                        const double size = std::clamp(range.size(), end * 1e-6, end);
                        const double low = std::clamp(range.lower, 0.0, end - size);
                        emit timesWanted(m_scale.time_s(low), m_scale.time_s(low + size));
                    }
                });
        m_cells.push_back({trace.source, trace.place, header, rect, {}});
        cell = m_cells.end() - 1;
    }
    QCPAxis* const times = cell->rect->axis(QCPAxis::atBottom);
    Lines lines{&trace, {}};
    for (std::size_t i = 0; i < traceKeys.size(); ++i) {
        const bool isDifference = traceKeys[i] == differenceKey;
        lines.graphs[i] =
            addGraph(times, cell->rect->axis(isDifference ? QCPAxis::atRight : QCPAxis::atLeft));
    }
    cell->lines.push_back(lines);
}

QCPGraph* TracesPlot::curve(std::size_t cell, Key key) const {
    return m_cells.at(cell).lines.front().graphs.at(static_cast<std::size_t>(key - measuredKey));
}

// --- what is in sight ---------------------------------------------------------------------------

void TracesPlot::showTimes(const CycleScale& scale, double from_s, double to_s,
                           const QString& timeLabel) {
    m_scale = scale;
    m_from_s = from_s;
    m_to_s = to_s;
    m_timeLabel = timeLabel;
    if (isEmpty() || !(to_s > from_s)) {
        return;
    }
    m_linking = true;
    for (const Cell& cell : m_cells) {
        QCPAxis* const times = cell.rect->axis(QCPAxis::atBottom);
        style::setSafeRange(*times, scale.at(from_s), scale.at(to_s));
        times->setLabel(timeLabel);
    }
    m_linking = false;
    fill();
    scaleValues();
    setMoment(m_moment_s);
}

void TracesPlot::setMoment(std::optional<double> time_s) {
    m_moment_s = time_s;
    m_momentLine->setAt(time_s ? std::optional(m_scale.at(*time_s)) : std::nullopt);
}

void TracesPlot::fill() {
    for (const Cell& cell : m_cells) {
        const double factor = differenceFactor(cell.source);
        for (const Lines& lines : cell.lines) {
            std::array<QVector<QCPGraphData>, 3> points;
            const TraceComparison& trace = *lines.trace;
            for (std::size_t i = 0; i < trace.time_s.size(); ++i) {
                const double time_s = trace.time_s[i];
                if (time_s < 0 || time_s > m_end_s) {
                    continue; // before or after the cycle
                }
                const double x = m_scale.at(time_s);
                points[0].push_back({x, trace.measured[i]});
                points[1].push_back({x, trace.predicted[i]});
                points[2].push_back({x, (trace.measured[i] - trace.predicted[i]) * factor});
            }
            for (std::size_t i = 0; i < points.size(); ++i) {
                lines.graphs[i]->data()->set(points[i], true);
            }
        }
    }
}

void TracesPlot::scaleValues() {
    for (const Cell& cell : m_cells) {
        const QCPRange times = cell.rect->axis(QCPAxis::atBottom)->range();
        for (const auto side : {QCPAxis::atLeft, QCPAxis::atRight}) {
            double low = std::numeric_limits<double>::max();
            double high = std::numeric_limits<double>::lowest();
            for (const Lines& lines : cell.lines) {
                for (std::size_t i = 0; i < traceKeys.size(); ++i) {
                    const bool isHere =
                        (traceKeys[i] == differenceKey) == (side == QCPAxis::atRight);
                    bool found = false;
                    const QCPRange range =
                        lines.graphs[i]->getValueRange(found, QCP::sdBoth, times);
                    if (isHere && found && shows(traceKeys[i])) {
                        low = std::min(low, range.lower);
                        high = std::max(high, range.upper);
                    }
                }
            }
            if (low > high) {
                continue;
            }
            if (side == QCPAxis::atRight) { // centred on zero, to show a bias
                high = std::max({std::abs(low), std::abs(high), 1e-9});
                low = -high;
            }
            const double pad = high > low ? (high - low) * tracePad : std::abs(high) + 1e-9;
            style::setSafeRange(*cell.rect->axis(side), low - pad, high + pad);
        }
    }
}

void TracesPlot::showChoice() {
    for (const Cell& cell : m_cells) {
        for (const Lines& lines : cell.lines) {
            for (std::size_t i = 0; i < traceKeys.size(); ++i) {
                lines.graphs[i]->setVisible(shows(traceKeys[i]));
            }
        }
    }
    scaleValues();
}

QList<QCPAxis*> TracesPlot::movedAxes(QCPAxisRect& rect) const {
    return {rect.axis(QCPAxis::atBottom)};
}

// --- words and numbers --------------------------------------------------------------------------

QString TracesPlot::nameOf(const Cell& cell) const {
    const QString name = quantityOf(cell.source);
    if (!cell.place) {
        return name;
    }
    const QString place = m_hasZones ? Names::zone(static_cast<Zone>(*cell.place))
                                     : Names::zone(Zone::section, *cell.place);
    return tr("%1, %2", "quantity, zone").arg(name, place);
}

double TracesPlot::rmsOf(const Cell& cell) const {
    double squares = 0, count = 0;
    for (const Lines& lines : cell.lines) {
        const auto n = static_cast<double>(lines.trace->time_s.size());
        squares += lines.trace->rms * lines.trace->rms * n;
        count += n;
    }
    return count > 0 ? std::sqrt(squares / count) * differenceFactor(cell.source) : 0;
}

QString TracesPlot::heading(std::size_t index) const {
    const Cell& cell = m_cells.at(index);
    return tr("%1: RMS %2 %3", "measured quantity")
        .arg(nameOf(cell), Names::significant(rmsOf(cell)), differenceUnit(cell.source));
}

void TracesPlot::label() {
    for (std::size_t i = 0; i < m_cells.size(); ++i) {
        const Cell& cell = m_cells[i];
        cell.header->setText(heading(i));
        cell.rect->axis(QCPAxis::atLeft)->setLabel(unitText(unitOf(cell.source)));
        cell.rect->axis(QCPAxis::atRight)->setLabel(tr("Δ, %1").arg(differenceUnit(cell.source)));
    }
}

void TracesPlot::setTexts() {
    label();
}

LegendEntries TracesPlot::legendEntries() const {
    if (isEmpty()) {
        return {};
    }
    const QStringList names{tr("measured"), tr("simulated"), tr("measured less simulated")};
    LegendEntries entries;
    for (std::size_t i = 0; i < traceKeys.size(); ++i) {
        entries.push_back(lineEntry(traceKeys[i], style::line(drawnParts[i], toned(drawnParts[i])),
                                    names[static_cast<qsizetype>(i)]));
    }
    return entries;
}

CsvTable TracesPlot::table() const {
    CsvTable table;
    table.byPlace = true;
    table.ownUnits = true;
    table.header = {tr("measured quantity"), m_timeLabel};
    const QStringList names{tr("measured"), tr("simulated"), tr("measured less simulated")};
    for (std::size_t i = 0; i < traceKeys.size(); ++i) {
        if (shows(traceKeys[i])) {
            table.header << names[static_cast<qsizetype>(i)];
        }
    }
    table.header << tr("unit") << tr("unit of the difference");
    for (const Cell& cell : m_cells) {
        for (const Lines& lines : cell.lines) {
            const TraceComparison& trace = *lines.trace;
            for (std::size_t i = 0; i < trace.time_s.size(); ++i) {
                const double time_s = trace.time_s[i];
                if (time_s < m_from_s || time_s > m_to_s) {
                    continue;
                }
                std::vector<CsvCell> row{nameOf(cell), m_scale.at(time_s)};
                for (const Key key : traceKeys) {
                    if (shows(key)) {
                        row.emplace_back(traceValue(trace, key, time_s).value_or(0));
                    }
                }
                row.emplace_back(unitText(unitOf(cell.source)));
                row.emplace_back(differenceUnit(cell.source));
                table.rows.push_back(std::move(row));
            }
        }
    }
    return table;
}

ReadCurves TracesPlot::readCurves() const {
    ReadCurves curves;
    const QStringList groups{tr("measured"), tr("simulated"), tr("difference")};
    for (const Cell& cell : m_cells) {
        const TraceComparison* const trace = cell.lines.front().trace;
        for (std::size_t i = 0; i < traceKeys.size(); ++i) {
            if (!shows(traceKeys[i])) {
                continue;
            }
            const QString unit = traceKeys[i] == differenceKey ? differenceUnit(cell.source)
                                                               : unitText(unitOf(cell.source));
            curves.push_back({groups[static_cast<qsizetype>(i)],
                              tr("%1, %2", "quantity, unit").arg(nameOf(cell), unit),
                              Digits::significant, [this, trace, key = traceKeys[i]](double x) {
                                  return traceValue(*trace, key, m_scale.time_s(x));
                              }});
        }
    }
    return curves;
}

CursorSubject TracesPlot::cursorSubject() {
    return {[this] { return m_timeLabel; }, [this] { return QCPRange(0, m_scale.at(m_end_s)); },
            [this] { return readCurves(); }, [this](double x) { return m_scale.time_s(x); },
            [this](double time_s) { return m_scale.at(time_s); }};
}

// --- reading ------------------------------------------------------------------------------------

const TracesPlot::Cell* TracesPlot::cellAt(const QPointF& at) const {
    const auto found = std::ranges::find_if(
        m_cells, [&](const Cell& cell) { return cell.rect->rect().contains(at.toPoint()); });
    return found == m_cells.end() ? nullptr : &*found;
}

QString TracesPlot::valuesAt(const QPointF& at) const {
    const Cell* const cell = cellAt(at);
    if (!cell) {
        return {};
    }
    const double x = cell->rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x());
    const TraceComparison& trace = *cell->lines.front().trace;
    const double time_s = m_scale.time_s(x);
    const auto measured = traceValue(trace, measuredKey, time_s);
    if (!measured) {
        return tr("%1: nothing measured at %2 = %3", "quantity, axis, place")
            .arg(nameOf(*cell), m_timeLabel, statedPlace(x));
    }
    const QString unit = unitText(unitOf(cell->source));
    return tr("%1 at %2 = %3: measured %4 %7, simulated %5 %7, difference %6 %8",
              "quantity, axis, place, values, units")
        .arg(nameOf(*cell), m_timeLabel, statedPlace(x), Names::significant(*measured, 4),
             Names::significant(*traceValue(trace, simulatedKey, time_s), 4),
             Names::significant(*traceValue(trace, differenceKey, time_s)), unit,
             differenceUnit(cell->source));
}

void TracesPlot::onMouse(QMouseEvent* event) {
    const Cell* const cell = cellAt(event->position());
    m_hairLine->setAt(cell ? std::optional(
                          cell->rect->axis(QCPAxis::atBottom)->pixelToCoord(event->position().x()))
                           : std::nullopt);
    ViewPlot::onMouse(event);
}

void TracesPlot::pointAway() {
    m_hairLine->setAt({});
    ViewPlot::pointAway();
}

// --- look ---------------------------------------------------------------------------------------

void TracesPlot::restyle() {
    ViewPlot::restyle();
    for (const Cell& cell : m_cells) {
        cell.header->setFont(font());
        cell.header->setTextColor(ink());
        for (const Lines& lines : cell.lines) {
            for (std::size_t i = 0; i < traceKeys.size(); ++i) {
                lines.graphs[i]->setPen(style::line(drawnParts[i], toned(drawnParts[i])));
            }
        }
    }
}

void TracesPlot::takeLook(bool font) {
    restyle();
    if (font) {
        updateGeometry();
    }
}

void TracesPlot::afterLayouting() {
    bool changed = false;
    for (const Cell& cell : m_cells) {
        changed = style::fitValueAxes(*cell.rect, font()) || changed;
    }
    if (changed) {
        replot(QCustomPlot::rpQueuedReplot);
    }
}

QSize TracesPlot::minimumSizeHint() const {
    if (isEmpty()) {
        return {0, 0};
    }
    const QFontMetrics metrics(font());
    const int line = metrics.height();
    const int numbers = metrics.horizontalAdvance(QStringLiteral("−0.000"));
    const int rows = (static_cast<int>(m_cells.size()) + mostTraceCells - 1) / mostTraceCells;
    const int beside = 2 * (numbers + line + besideTrace), above = 3 * line + 4 * aroundTrace;
    return {columns() * (legibleTrace.width() + beside), rows * (legibleTrace.height() + above)};
}

} // namespace sparkout
