// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/margin_front_plot.h"

#include "ui/chart/plot_tools.h"
#include "ui/chart/quantity_colour.h"
#include "ui/text/number_text.h"
#include "ui/views/study/optimise_text.h"

#include <QAccessible>
#include <QKeyEvent>

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

// --- displayed cycles ---------------------------------------------------------------------------

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

using style::Drawn;

namespace {

constexpr double frontDot = 7, ownDot = 10, chosenRing = 15; ///< [px]
constexpr double nearCycle = 12; ///< [px] within which a click selects a cycle
constexpr double frontRoom = 0.08;
constexpr double frontPercent = 100;

TimedMargin timedMargin(const FoundCycle& found) {
    return {found.time_s, found.leastRelativeMargin};
}

} // namespace

MarginFrontPlot::MarginFrontPlot(QWidget* parent) : ChartPlot(parent) {
    connect(this, &ChartPlot::pointClicked, this,
            [this](std::size_t, std::size_t point) { emit cycleClicked(rowOf(*front()[point])); });
}

void MarginFrontPlot::setSearch(SearchOutcomePtr outcome, std::optional<TimedMargin> yours) {
    m_outcome = std::move(outcome);
    m_own = yours;
    m_chosen.reset();
    double longest_s = std::max(m_own ? m_own->time_s : 0, given_s().value_or(0));
    for (const FoundCycle* each : front()) {
        longest_s = std::max(longest_s, each->time_s);
    }
    m_unit = TimeUnit(longest_s);
    setChart([this] { return made(); });
}

void MarginFrontPlot::setChosen(const FoundCycle* found) {
    m_chosen = found ? std::optional(timedMargin(*found)) : std::nullopt;
    setAccessibleDescription(found && m_outcome ? described(*found) : QString());
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
    remake();
}

std::vector<const FoundCycle*> MarginFrontPlot::front() const {
    return m_outcome ? m_outcome->front() : std::vector<const FoundCycle*>();
}

std::optional<double> MarginFrontPlot::given_s() const {
    constexpr double usPerSecond = 1e6;
    return m_outcome && m_outcome->marginWithin_us
               ? std::optional(static_cast<double>(*m_outcome->marginWithin_us) / usPerSecond)
               : std::nullopt;
}

XY MarginFrontPlot::placeOf(const TimedMargin& of) const {
    return {m_unit.of(of.time_s), frontPercent * of.leastRelativeMargin};
}

LineChart MarginFrontPlot::made() const {
    LineChart chart;
    chart.across = {m_unit.titled(tr("Machining time")), {}, frontRoom, 1e-3};
    chart.up = {tr("Minimum margin, %"), {}, frontRoom, 1e-2};
    chart.table = [this] {
        ChartTable table{tableOf(m_outcome ? *m_outcome : SearchOutcome())};
        for (const FoundCycle* each : front()) {
            const XY at = placeOf(timedMargin(*each));
            table.places.push_back({{at.x, at.x}, {at.y, at.y}});
        }
        return table;
    };
    if (!hasFront()) {
        return chart;
    }
    // A step curve, since a margin applies until a longer time gives a larger one.
    ChartSeries curve{.key = frontKey,
                      .name = tr("maximum margin by time"),
                      .kind = ChartSeries::Kind::steps,
                      .colour = Drawn::quickestCycle,
                      .mark = ChartSeries::Mark::disc,
                      .markSize = frontDot};
    for (const FoundCycle* each : front()) {
        curve.points.push_back(placeOf(timedMargin(*each)));
    }
    chart.series = {std::move(curve)};
    if (m_own) {
        chart.series.push_back({.key = yoursKey,
                                .name = tr("your cycle"),
                                .kind = ChartSeries::Kind::points,
                                .colour = Drawn::yourCycle,
                                .points = {placeOf(*m_own)},
                                .mark = ChartSeries::Mark::diamond,
                                .markSize = ownDot});
    }
    if (m_chosen) {
        chart.series.push_back({.key = chosenKey,
                                .name = tr("cycle chosen"),
                                .kind = ChartSeries::Kind::points,
                                .points = {placeOf(*m_chosen)},
                                .mark = ChartSeries::Mark::ring,
                                .markSize = chosenRing,
                                .sight = InSight::never});
    }
    if (given_s()) {
        chart.rules = {{.at = m_unit.of(*given_s()),
                        .key = timeKey,
                        .name = tr("time given"),
                        .pen = linePen(1.5, Qt::DashLine),
                        .sight = InSight::always}};
    }
    chart.pointed = 1;
    chart.reach = nearCycle;
    chart.pointText = [this](std::size_t, std::size_t point) { return described(*front()[point]); };
    return chart;
}

std::size_t MarginFrontPlot::rowOf(const FoundCycle& found) const {
    return static_cast<std::size_t>(&found - m_outcome->found.data());
}

QString MarginFrontPlot::described(const FoundCycle& found) const {
    return tr("%1, margin %2 %: %3")
        .arg(OptimiseText::time(found.time_s), OptimiseText::percent(found.leastRelativeMargin),
             OptimiseText::found(found, m_outcome->project));
}

// --- keys ---------------------------------------------------------------------------------------

PlotTools& MarginFrontPlot::addTools(PlotSubject subject, Settings* settings) {
    PlotTools& tools = ChartPlot::addTools(std::move(subject), settings);
    installEventFilter(this); // installed last, so called before the navigation's
    return tools;
}

bool MarginFrontPlot::eventFilter(QObject* watched, QEvent* event) {
    if (watched == this && event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        const Qt::KeyboardModifiers modifiers = key->modifiers() & ~Qt::KeypadModifier;
        if (modifiers == Qt::NoModifier && onKey(key->key())) {
            event->accept();
            return true;
        }
    }
    return ChartPlot::eventFilter(watched, event);
}

const FoundCycle* MarginFrontPlot::beside(bool isLonger) const {
    const std::vector<const FoundCycle*> points = front();
    if (!m_chosen) {
        return isLonger ? points.front() : points.back();
    }
    const FoundCycle* found = nullptr;
    for (const FoundCycle* each : points) {
        if (isLonger && each->time_s > m_chosen->time_s) {
            return each;
        }
        if (!isLonger && each->time_s < m_chosen->time_s) {
            found = each;
        }
    }
    return found;
}

bool MarginFrontPlot::onKey(int key) {
    if (!hasFront()) {
        return false;
    }
    if (key == Qt::Key_Return || key == Qt::Key_Enter) {
        emit cycleEntered();
        return true;
    }
    if (key != Qt::Key_Left && key != Qt::Key_Right) {
        return false;
    }
    if (const FoundCycle* found = beside(key == Qt::Key_Right)) {
        emit cyclePointed(rowOf(*found));
        emit pointed(described(*found));
    }
    return true; // also at the ends
}

// --- table --------------------------------------------------------------------------------------

CsvTable MarginFrontPlot::tableOf(const SearchOutcome& outcome) {
    const std::vector<const FoundCycle*> points = outcome.front();
    const TimeUnit unit(points.empty() ? 0 : points.back()->time_s); // the quickest is first
    CsvTable table;
    table.header << unit.titled(tr("Time")) << tr("Margin, %") << tr("Stages") << tr("Cycle");
    for (const FoundCycle* each : points) {
        table.rows.push_back({unit.of(each->time_s), frontPercent * each->leastRelativeMargin,
                              double(each->cycle.stages.size()),
                              OptimiseText::found(*each, outcome.project)});
    }
    return table;
}

} // namespace sparkout
