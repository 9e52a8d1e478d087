// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/documents/passport_figures.h"

#include "ui/bars/bar_plot.h"
#include "ui/plot/chart_plot.h"
#include "ui/report/format/plot_figure.h"
#include "ui/views/batch/batch_charts.h"
#include "ui/views/batch/batch_text.h"
#include "ui/views/profiles/longitudinal_plot.h"
#include "ui/views/profiles/profiles_plot.h"
#include "ui/views/profiles/profiles_text.h"

#include <algorithm>

namespace sparkout::report {

namespace {

constexpr int histogramHeight = 240, alongHeight = 300, acrossHeight = 320;
constexpr int leastBarsHeight = 110, standingBarsHeight = 230;
constexpr std::size_t mostAcross = 4; ///< cross-sections side by side

std::vector<int> allOf(const ProfileSeries& series) {
    std::vector<int> all;
    for (std::size_t i = 0; i < series.profiles.size(); ++i) {
        all.push_back(static_cast<int>(i));
    }
    return all;
}

} // namespace

Figure PassportFigures::histograms(const BatchSummary& summary, const std::string& name) {
    const std::vector<std::size_t> shown = placesOf(summary, name, mostPlaces);
    QStringList values;
    for (const std::size_t i : shown) {
        const CharacteristicSummary& of = summary.characteristics[i];
        if (of.count > 0) {
            values << tr("%1: %2", "zone, range of values")
                          .arg(
                              BatchText::where(of.characteristic),
                              BatchText::range({of.least.value, of.most.value}, of.characteristic));
        }
    }
    const QString axis = BatchText::axis(summary.characteristics[shown.front()].characteristic);
    const QString caption = placesOf(summary, name).size() > shown.size()
                                ? tr("%1: number of parts, where the Ppk is lowest").arg(axis)
                                : tr("%1: number of parts").arg(axis);
    ChartPlot plot;
    setUpForPaper(plot, histogramHeight);
    plot.setGrid([&] { return BatchCharts::histograms(summary, name, true); });
    return plotFigure(plot, plot.legendEntries(), caption, values.join(QStringLiteral("; ")));
}

Figure PassportFigures::alongThePart(const Outcome& outcome) {
    using enum ProfileLine;
    const ProfileSeries series = makeProfileSeries(outcome.result, outcome.trajectory);
    LongitudinalPlot plot;
    setUpForPaper(plot, alongHeight);
    plot.setDiameters(true);
    plot.setHidden({blank});
    plot.setSeries(series, shaftSteps(outcome.result.project), {});
    plot.fit();
    return plotFigure(plot, plot.entriesOf({profile, spread, target, field, gauge}),
                      tr("Diameter along the part against the tolerance band"),
                      ProfilesText::summary(series, allOf(series)));
}

Figure PassportFigures::crossSections(const Outcome& outcome) {
    using enum ProfileLine;
    const ProfileSeries series = makeProfileSeries(outcome.result, outcome.trajectory);
    std::vector<int> shown = allOf(series);
    if (shown.size() > mostAcross) {
        shown = shownSections(static_cast<int>(shown.size()), gaugeProfile(outcome.result));
    }
    ProfilesPlot plot;
    setUpForPaper(plot, acrossHeight);
    plot.setHidden({blank});
    plot.setSeries(series, shown);
    plot.fit();
    return plotFigure(plot, plot.entriesOf({profile, target, leastSquares, field}),
                      tr("Cross-sections, deviations magnified"),
                      ProfilesText::summary(series, shown));
}

std::optional<Figure> PassportFigures::bars(OverviewChart which, BarChart chart) {
    return bars(OverviewCharts::title(which), std::move(chart));
}

std::optional<Figure> PassportFigures::bars(const QString& name, BarChart chart) {
    if (chart.empty()) {
        return {};
    }
    const QString caption =
        chart.remark.isEmpty() ? name : QStringLiteral("%1. %2").arg(name, chart.remark);
    const QString description = chart.description();
    BarPlot plot;
    setUpForPaper(plot, leastBarsHeight);
    plot.resize(figureWidth, std::max(BarDrawing::leastHeight(chart, plot.font()),
                                      chart.isLying ? leastBarsHeight : standingBarsHeight));
    plot.setChart(std::move(chart));
    return plotFigure(plot, plot.legendEntries(), caption, description);
}

} // namespace sparkout::report
