// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/cycle/traces_plot.h"

#include "core/project/measured.h"
#include "core/units.h"
#include "ui/chart/quantity_colour.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"
#include "words/measured_words.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

TraceComparer::TraceComparer(QObject* parent) : QObject(parent) {}

void TraceComparer::compare(const OutcomePtr& outcome) {
    m_running = true;
    m_job.start([this, outcome](const std::stop_token& stop, const NewestJob::Post& post) {
        auto traces = std::make_shared<std::vector<TraceComparison>>(
            compareTraces(outcome->result.project, outcome->result.countsByStage, stop));
        post([this, outcome, found = TraceComparisonsPtr(std::move(traces))] {
            m_running = false;
            emit compared(found, outcome);
        });
    });
}

void TraceComparer::drop() {
    m_running = false;
    m_job.stop();
}

namespace {

using style::Drawn;

constexpr std::size_t mostTraceCells = 3; ///< side by side
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

/// A value at the time of a sample.
double sampleOf(const TraceComparison& trace, TracesPlot::Key key, std::size_t i) {
    switch (key) {
    case TracesPlot::measuredKey: return trace.measured[i];
    case TracesPlot::simulatedKey: return trace.predicted[i];
    case TracesPlot::differenceKey: break;
    }
    return (trace.measured[i] - trace.predicted[i]) * differenceFactor(trace.source);
}

constexpr std::array traceKeys{TracesPlot::measuredKey, TracesPlot::simulatedKey,
                               TracesPlot::differenceKey};
constexpr std::array drawnParts{Drawn::measuredValue, Drawn::simulatedValue,
                                Drawn::measuredDifference};

double rmsOf(const std::vector<const TraceComparison*>& group) {
    double squares = 0, count = 0;
    for (const TraceComparison* trace : group) {
        const auto n = static_cast<double>(trace->time_s.size());
        squares += trace->rms * trace->rms * n;
        count += n;
    }
    return count > 0 ? std::sqrt(squares / count) * differenceFactor(group.front()->source) : 0;
}

} // namespace

TracesPlot::TracesPlot(QWidget* parent) : CyclePlot(parent) {
    setGrid([this] { return made(); });
}

void TracesPlot::setTraces(TraceComparisonsPtr traces, const Project& project) {
    m_hasZones = project.operation->travels;
    m_traces = std::move(traces);
    follow();
    updateGeometry();
    emit contentChanged();
}

void TracesPlot::showTimes(const CycleTimes& times, const QString& timeLabel) {
    m_times = times;
    m_timeLabel = timeLabel;
    follow();
}

// --- the charts ---------------------------------------------------------------------------------

std::vector<TracesPlot::Group> TracesPlot::groups() const {
    std::vector<Group> groups;
    for (std::size_t i = 0; m_traces && i < m_traces->size(); ++i) {
        const TraceComparison& trace = (*m_traces)[i];
        const auto found = std::ranges::find_if(groups, [&trace](const Group& group) {
            return group.front()->source == trace.source && group.front()->place == trace.place;
        });
        if (found == groups.end()) {
            groups.push_back({&trace});
        } else {
            found->push_back(&trace);
        }
    }
    return groups;
}

ChartGrid TracesPlot::made() const {
    ChartGrid grid;
    for (const Group& group : groups()) {
        grid.cells.push_back(chartOf(group));
    }
    grid.columns = std::clamp<std::size_t>(grid.cells.size(), 1, mostTraceCells);
    if (!grid.cells.empty()) {
        grid.cells.front().table = [this] { return ChartTable{tableOf(), {}}; };
    }
    return grid;
}

LineChart TracesPlot::chartOf(const Group& group) const {
    const TraceComparison& first = *group.front();
    const QString unit = unitText(unitOf(first.source)), beside = differenceUnit(first.source);
    const QStringList names{tr("measured"), tr("simulated"), tr("measured minus simulated")};
    const QStringList groups{tr("measured"), tr("simulated"), tr("difference")};
    LineChart chart;
    chart.isFramed = true;
    chart.headings << tr("%1: RMS %2 %3", "measured quantity")
                          .arg(nameOf(first), Names::significant(rmsOf(group)), beside)
                   << QString(); // the legend and the axes name the rest
    chart.across.label = m_timeLabel;
    chart.up = {.label = unit, .room = tracePad};
    chart.second = {.label = tr("Δ, %1").arg(beside), .room = tracePad, .isSymmetric = true};
    for (const TraceComparison* trace : group) {
        for (std::size_t i = 0; i < traceKeys.size(); ++i) {
            const bool isDifference = traceKeys[i] == differenceKey; // centred on 0, to show a bias
            ChartSeries series{.key = traceKeys[i],
                               .name = names[static_cast<qsizetype>(i)],
                               .colour = drawnParts[i],
                               .pen = style::line(drawnParts[i], {}),
                               .onSecond = isDifference};
            for (std::size_t k = 0; k < trace->time_s.size(); ++k) {
                const double time_s = trace->time_s[k];
                if (time_s < 0 || time_s > m_times.end_s) {
                    continue; // before or after the cycle
                }
                const double value = sampleOf(*trace, traceKeys[i], k);
                series.points.push_back({m_times.scale.at(time_s), value});
                if (shows(traceKeys[i]) && isInSight(time_s)) {
                    (isDifference ? chart.second : chart.up).range.add(value);
                }
            }
            if (trace == &first) {
                chart.read(
                    series,
                    tr("%1, %2", "quantity, unit").arg(nameOf(first), isDifference ? beside : unit),
                    Digits::significant);
                chart.readings.back().curve.group = groups[static_cast<qsizetype>(i)];
            }
            chart.series.push_back(std::move(series));
        }
    }
    if (chart.up.range.size() == 0) { // a constant
        const double around = std::abs(chart.up.range.high) + 1e-9;
        chart.up.range = {chart.up.range.low - around, chart.up.range.high + around};
    }
    chart.placeText = [this, &first, traces = m_traces, readings = chart.readings](double x) {
        return textAt(first, readings, x);
    };
    return chart;
}

bool TracesPlot::isInSight(double time_s) const {
    return time_s >= m_times.from_s && time_s <= m_times.to_s;
}

// --- words and numbers --------------------------------------------------------------------------

QString TracesPlot::nameOf(const TraceComparison& trace) const {
    const QString name = quantityOf(trace.source);
    if (!trace.place) {
        return name;
    }
    const QString place = m_hasZones ? Names::zone(static_cast<Zone>(*trace.place))
                                     : Names::zone(Zone::section, *trace.place);
    return tr("%1, %2", "quantity, zone").arg(name, place);
}

CsvTable TracesPlot::tableOf() const {
    CsvTable table;
    table.byPlace = true;
    table.ownUnits = true;
    table.header = {tr("measured quantity"), m_timeLabel};
    const QStringList names{tr("measured"), tr("simulated"), tr("measured minus simulated")};
    for (std::size_t i = 0; i < traceKeys.size(); ++i) {
        if (shows(traceKeys[i])) {
            table.header << names[static_cast<qsizetype>(i)];
        }
    }
    table.header << tr("unit") << tr("unit of the difference");
    for (const Group& group : groups()) {
        for (const TraceComparison* trace : group) {
            for (std::size_t i = 0; i < trace->time_s.size(); ++i) {
                const double time_s = trace->time_s[i];
                if (!isInSight(time_s)) {
                    continue;
                }
                std::vector<CsvCell> row{nameOf(*trace), m_times.scale.at(time_s)};
                for (const Key key : traceKeys) {
                    if (shows(key)) {
                        row.emplace_back(sampleOf(*trace, key, i));
                    }
                }
                row.emplace_back(unitText(unitOf(trace->source)));
                row.emplace_back(differenceUnit(trace->source));
                table.rows.push_back(std::move(row));
            }
        }
    }
    return table;
}

QString TracesPlot::textAt(const TraceComparison& trace, const std::vector<ChartReading>& readings,
                           double x) const {
    const auto value = [&](std::size_t i) { return readings[i].curve.at(x); };
    if (!value(0)) {
        return tr("%1: nothing measured at %2 = %3", "quantity, axis, place")
            .arg(nameOf(trace), m_timeLabel, statedPlace(x));
    }
    return tr("%1 at %2 = %3: measured %4 %7, simulated %5 %7, difference %6 %8",
              "quantity, axis, place, values, units")
        .arg(nameOf(trace), m_timeLabel, statedPlace(x), Names::significant(*value(0), 4),
             Names::significant(*value(1), 4), Names::significant(*value(2)),
             unitText(unitOf(trace.source)), differenceUnit(trace.source));
}

// --- look ---------------------------------------------------------------------------------------

void TracesPlot::takeLook(bool font) {
    CyclePlot::takeLook(font);
    if (font) {
        updateGeometry();
    }
}

QSize TracesPlot::minimumSizeHint() const {
    if (isEmpty()) {
        return {0, 0};
    }
    const QFontMetrics metrics(font());
    const int line = metrics.height();
    const int numbers = metrics.horizontalAdvance(QStringLiteral("−0.000"));
    const auto rows = static_cast<int>((cellCount() + columns() - 1) / columns());
    const int beside = 2 * (numbers + line + besideTrace), above = 3 * line + 4 * aroundTrace;
    return {static_cast<int>(columns()) * (legibleTrace.width() + beside),
            rows * (legibleTrace.height() + above)};
}

} // namespace sparkout
