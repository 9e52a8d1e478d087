// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/surface_bars.h"

#include "core/study/run_comparison.h"
#include "ui/bars/bar_plot.h"
#include "ui/kit/hatch.h"
#include "ui/kit/metrics.h"
#include "ui/plot/legend_strip.h"
#include "ui/session/surface_edits.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QVBoxLayout>

#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

constexpr double noNumber = std::numeric_limits<double>::quiet_NaN();
constexpr int barDigits = 3;

} // namespace

SurfaceBars::SurfaceBars(QWidget* parent)
    : QWidget(parent), m_legend(new LegendStrip(this)), m_plot(new BarPlot(this)) {
    m_plot->setObjectName(QStringLiteral("surfaceBars"));
    m_plot->setLeads(true);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    column->addWidget(m_legend);
    column->addWidget(m_plot);
    connect(m_plot, &ViewPlot::contentChanged, this, &SurfaceBars::showLegend);
    connect(m_plot, &BarPlot::entered, this,
            [this](std::size_t, std::size_t surface) { emit surfaceWanted(surface); });
    connect(m_legend, &LegendStrip::toggled, m_plot, &BarPlot::toggleCurve);
    connect(m_legend, &LegendStrip::onlyAsked, m_plot, &BarPlot::showOnly);
}

BarChart SurfaceBars::chartOf(const SetupState& state, const std::vector<SurfaceStatus>& statuses) {
    BarChart chart;
    chart.shape = BarChart::Shape::grouped;
    chart.what = tr("Surface");
    chart.axis = tr("Cycle time");
    chart.secondAxis = tr("Margin");
    chart.secondUnit = QStringLiteral("%");
    chart.number = [](double value) { return Names::significant(value, barDigits); };
    chart.secondNumber = [](double value) {
        return Names::fixed(value, std::abs(value) < 10 ? 1 : 0);
    };
    chart.series = {{tr("cycle time"), barColour(style::Drawn::yourCycle), hatchAt(0), {}},
                    {tr("minimum margin"),
                     barColour(style::Drawn::everyRequirementHolds),
                     hatchAt(1),
                     {},
                     true}};
    for (std::size_t i = 0; i < statuses.size(); ++i) {
        const SurfaceStatus& status = statuses[i];
        chart.categories << printableText(SurfaceEdits::nameOf(state, i));
        chart.series[0].values.push_back(status.ran() ? status.time_s : noNumber);
        const auto least = leastMargin(status.requirements);
        chart.series[1].values.push_back(least ? 100 * least->relativeMargin : noNumber);
    }
    chart.fitTimeUnit();
    chart.remark = tr("Margin: that of the requirement nearest to its limit of those that are "
                      "decided, below 0 where one fails.");
    return chart;
}

void SurfaceBars::setPart(const SetupState& state, const std::vector<SurfaceStatus>& statuses) {
    m_plot->setChart(chartOf(state, statuses));
    m_plot->setAccessibleDescription(m_plot->chart().description());
    m_plot->setMinimumHeight(BarDrawing::leastHeight(m_plot->chart(), m_plot->font()));
    m_plot->setToolTip(m_plot->chart().remark);
    showLegend();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void SurfaceBars::showLegend() {
    m_legend->setEntries(m_plot->legendEntries());
}

void SurfaceBars::retranslate() {
    m_plot->setAccessibleName(tr("The surfaces compared, as bars"));
}

} // namespace sparkout
