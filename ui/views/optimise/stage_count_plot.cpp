// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/optimise/stage_count_plot.h"

#include "ui/plot/quantity_colour.h"
#include "ui/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

StageCountPlot::StageCountPlot(QWidget* parent) : BarPlot(parent) {}

void StageCountPlot::setSearch(SearchOutcomePtr outcome, std::optional<double> before_s) {
    m_outcome = std::move(outcome);
    m_before_s = before_s;
    setChart(makeChart());
}

BarChart StageCountPlot::makeChart() const {
    BarChart chart;
    if (!m_outcome || m_outcome->numbers.empty()) {
        return chart;
    }
    chart.shape = BarChart::Shape::grouped;
    chart.what = tr("Stages");
    chart.axis = tr("Machining time");
    using style::Drawn;
    const QString best =
        m_outcome->marginWithin_us ? tr("cycle with the maximum margin") : tr("quickest cycle");
    BarSeries quickest{best, barColour(Drawn::quickestCycle), hatchAt(0), {}};
    BarSeries proven{tr("none is below"), barColour(Drawn::lowerBound), hatchAt(1), {}};
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (const SearchedNumber& number : m_outcome->numbers) {
        chart.categories << tr("%n stage(s)", nullptr, number.stages);
        const bool bounded = number.status == SearchStatus::stopped && number.bound_s > 0;
        quickest.values.push_back(number.best_s.value_or(none));
        proven.values.push_back(bounded ? number.bound_s : none);
    }
    const bool hasBounds =
        std::ranges::any_of(proven.values, [](double value) { return std::isfinite(value); });
    chart.series.push_back(std::move(quickest));
    if (hasBounds) {
        chart.series.push_back(std::move(proven));
    }
    if (m_before_s) {
        chart.limits.push_back(
            {*m_before_s, tr("your cycle"), Qt::DashLine, barColour(Drawn::yourCycle)});
    }
    if (isKnownLimit(m_outcome->limit.time_s)) {
        chart.limits.push_back({m_outcome->limit.time_s, tr("stepless limit"), Qt::DotLine,
                                barColour(Drawn::steplessLimit)});
    }
    chart.fitTimeUnit();
    return chart;
}

// --- what is shown ------------------------------------------------------------------------------

CsvTable StageCountPlot::table() const {
    return tableOf(m_outcome ? *m_outcome : SearchOutcome());
}

CsvTable StageCountPlot::tableOf(const SearchOutcome& outcome) {
    const bool isLimited = isKnownLimit(outcome.limit.time_s);
    double longest_s = isLimited ? outcome.limit.time_s : 0;
    for (const SearchedNumber& number : outcome.numbers) {
        longest_s = std::max({longest_s, number.best_s.value_or(0), number.bound_s});
    }
    const TimeUnit unit(longest_s);
    CsvTable table;
    table.header << tr("Stages") << unit.titled(tr("Time of the quickest cycle"))
                 << unit.titled(tr("None is below")) << unit.titled(tr("Stepless limit"));
    for (const SearchedNumber& number : outcome.numbers) {
        table.rows.push_back({double(number.stages),
                              number.best_s ? CsvCell(unit.of(*number.best_s)) : CsvCell(),
                              unit.of(number.bound_s),
                              isLimited ? CsvCell(unit.of(outcome.limit.time_s)) : CsvCell()});
    }
    return table;
}

/// Explains a number of stages without a bar.
QString StageCountPlot::valuesAt(const QPointF& at) const {
    const int category = drawing().categoryAt(at);
    if (!m_outcome || category < 0) {
        return {};
    }
    const SearchedNumber& number = m_outcome->numbers.at(static_cast<std::size_t>(category));
    if (number.best_s) {
        return BarPlot::valuesAt(at);
    }
    return tr("%1: no cycle was found that meets every requirement")
        .arg(tr("%n stage(s)", nullptr, number.stages));
}

/// Redraws everything, since the chart contains texts.
void StageCountPlot::setTexts() {
    BarPlot::setTexts();
    setChart(makeChart());
}

} // namespace sparkout
