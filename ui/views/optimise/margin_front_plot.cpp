// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/optimise/margin_front_plot.h"

#include "core/units.h"
#include "ui/plot/plot_tools.h"
#include "ui/views/optimise/optimise_text.h"

#include <QAccessible>
#include <QKeyEvent>
#include <QLineF>

#include <algorithm>
#include <utility>

namespace sparkout {

using style::Drawn;

namespace {

constexpr double frontDot = 7, ownDot = 10, chosenRing = 15; ///< [px]
constexpr double nearCycle = 12;                             ///< [px] a cycle is meant within
constexpr double frontRoom = 0.08;
constexpr double frontPercent = 100;

double given_s(const SearchOutcome& outcome) {
    constexpr double usPerSecond = 1e6;
    return static_cast<double>(*outcome.marginWithin_us) / usPerSecond;
}

} // namespace

MarginFrontPlot::MarginFrontPlot(QWidget* parent)
    : ViewPlot(parent)
    , m_rect(addRect())
    , m_curve(addLine(*m_rect))
    , m_yours(addLine(*m_rect))
    , m_chosen(addLine(*m_rect))
    , m_time(addRule(*m_rect, 0)) {
    m_curve->setLineStyle(QCPGraph::lsStepLeft); // a margin stands until a longer time has more
    m_curve->setAdaptiveSampling(false);
    m_yours->setLineStyle(QCPGraph::lsNone);
    m_chosen->setLineStyle(QCPGraph::lsNone);
    connect(this, &QCustomPlot::afterLayout, this, [this] {
        if (style::fitValueAxes(*m_rect, font())) {
            replot(rpQueuedReplot);
        }
    });
    setKeyed(frontKey, {m_curve});
    setKeyed(yoursKey, {m_yours});
    setKeyed(chosenKey, {m_chosen});
    setKeyed(timeKey, {m_time});
    onClick([this](const QPointF& at) {
        if (const FoundCycle* found = cycleAt(at)) {
            emit cycleClicked(rowOf(*found));
        }
    });
    built();
}

void MarginFrontPlot::setSearch(SearchOutcomePtr outcome, std::optional<TimedMargin> yours) {
    m_outcome = std::move(outcome);
    m_own = yours;
    m_chosen->data()->clear();
    m_chosen_s.reset();
    m_unit = TimeUnit(longest_s());
    fill();
    contentSet();
}

double MarginFrontPlot::longest_s() const {
    double longest_s = m_own ? m_own->time_s : 0;
    if (m_outcome) {
        for (const FoundCycle* each : m_outcome->front()) {
            longest_s = std::max(longest_s, each->time_s);
        }
    }
    return showsTime() ? std::max(longest_s, given_s(*m_outcome)) : longest_s;
}

void MarginFrontPlot::setChosen(const FoundCycle* found) {
    m_chosen->data()->clear();
    m_chosen_s.reset();
    if (found) {
        m_chosen_s = found->time_s;
        m_chosen->addData(m_unit.of(found->time_s), frontPercent * found->leastRelativeMargin);
    }
    setAccessibleDescription(found && m_outcome ? described(*found) : QString());
    QAccessibleEvent changed(this, QAccessible::DescriptionChanged);
    QAccessible::updateAccessibility(&changed);
    emit contentChanged();
}

void MarginFrontPlot::fill() {
    m_curve->data()->clear();
    m_yours->data()->clear();
    if (!m_outcome) {
        return;
    }
    for (const FoundCycle* each : m_outcome->front()) {
        m_curve->addData(m_unit.of(each->time_s), frontPercent * each->leastRelativeMargin);
    }
    if (m_own && hasFront()) {
        m_yours->addData(m_unit.of(m_own->time_s), frontPercent * m_own->leastRelativeMargin);
    }
    const double at = showsTime() ? m_unit.of(given_s(*m_outcome)) : 0;
    m_time->point1->setCoords(at, 0);
    m_time->point2->setCoords(at, 1);
}

void MarginFrontPlot::showTime() {
    m_time->setVisible(showsTime() && hasFront() && shows(timeKey));
}

void MarginFrontPlot::showChoice() {
    ViewPlot::showChoice();
    showTime();
}

void MarginFrontPlot::fit() {
    if (!hasFront()) {
        return;
    }
    bool found = false;
    const QCPRange times = m_curve->getKeyRange(found), margins = m_curve->getValueRange(found);
    double first = times.lower, last = times.upper, least = margins.lower, most = margins.upper;
    if (m_own) {
        first = std::min(first, m_unit.of(m_own->time_s));
        last = std::max(last, m_unit.of(m_own->time_s));
        least = std::min(least, frontPercent * m_own->leastRelativeMargin);
        most = std::max(most, frontPercent * m_own->leastRelativeMargin);
    }
    if (showsTime()) {
        last = std::max(last, m_unit.of(given_s(*m_outcome)));
    }
    style::setRoomyRange(*across(), first, last, frontRoom, 1e-3);
    style::setRoomyRange(*up(), least, most, frontRoom, 1e-2);
}

QPointF MarginFrontPlot::pixelOf(std::size_t n) const {
    const auto at = m_curve->data()->at(static_cast<int>(n));
    return {across()->coordToPixel(at->key), up()->coordToPixel(at->value)};
}

const FoundCycle* MarginFrontPlot::cycleAt(const QPointF& at) const {
    if (!m_outcome || !shows(frontKey)) {
        return nullptr;
    }
    const FoundCycle* found = nullptr;
    double nearest = nearCycle;
    for (const FoundCycle* each : m_outcome->front()) {
        const QPointF point(across()->coordToPixel(m_unit.of(each->time_s)),
                            up()->coordToPixel(frontPercent * each->leastRelativeMargin));
        if (const double away = QLineF(point, at).length(); away < nearest) {
            nearest = away;
            found = each;
        }
    }
    return found;
}

std::size_t MarginFrontPlot::rowOf(const FoundCycle& found) const {
    return static_cast<std::size_t>(&found - m_outcome->found.data());
}

QString MarginFrontPlot::described(const FoundCycle& found) const {
    return tr("%1, margin %2 %: %3")
        .arg(OptimiseText::time(found.time_s), OptimiseText::percent(found.leastRelativeMargin),
             OptimiseText::found(found, m_outcome->project));
}

QString MarginFrontPlot::valuesAt(const QPointF& at) const {
    const FoundCycle* const found = cycleAt(at);
    return found ? described(*found) : QString();
}

// --- keys ---------------------------------------------------------------------------------------

PlotTools& MarginFrontPlot::addTools(PlotSubject subject, Settings* settings) {
    PlotTools& tools = ViewPlot::addTools(std::move(subject), settings);
    installEventFilter(this); // last, hence before the navigation's
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
    return ViewPlot::eventFilter(watched, event);
}

const FoundCycle* MarginFrontPlot::beside(bool isLonger) const {
    const std::vector<const FoundCycle*> points = m_outcome->front(); // the quickest first
    if (!m_chosen_s) {
        return isLonger ? points.front() : points.back();
    }
    const FoundCycle* found = nullptr;
    for (const FoundCycle* each : points) {
        if (isLonger && each->time_s > *m_chosen_s) {
            return each;
        }
        if (!isLonger && each->time_s < *m_chosen_s) {
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
    return true; // at an end too
}

// --- table, look and words ----------------------------------------------------------------------

CsvTable MarginFrontPlot::tableOf(const SearchOutcome& outcome) {
    CsvTable table;
    table.header << tr("Time, min") << tr("Margin, %") << tr("Stages") << tr("Cycle");
    for (const FoundCycle* each : outcome.front()) {
        table.rows.push_back(
            {each->time_s / units::secondsPerMinute, frontPercent * each->leastRelativeMargin,
             double(each->cycle.stages.size()), OptimiseText::found(*each, outcome.project)});
    }
    return table;
}

CsvTable MarginFrontPlot::table() const {
    CsvTable table = tableOf(m_outcome ? *m_outcome : SearchOutcome());
    std::erase_if(table.rows, [this](const std::vector<CsvCell>& row) {
        const double time_s = std::get<double>(row[0]) * units::secondsPerMinute;
        return !across()->range().contains(m_unit.of(time_s))
               || !up()->range().contains(std::get<double>(row[1]));
    });
    return table;
}

void MarginFrontPlot::restyle() {
    ViewPlot::restyle();
    const QColor front = toned(Drawn::quickestCycle), own = toned(Drawn::yourCycle);
    m_curve->setPen(QPen(front, 1.5));
    m_curve->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(front), front, frontDot));
    m_yours->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDiamond, QPen(own, 1.5), own, ownDot));
    m_chosen->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(ink(), 2), Qt::NoBrush, chosenRing));
    m_time->setPen(QPen(ink(), 1.5, Qt::DashLine));
}

LegendEntries MarginFrontPlot::legendEntries() const {
    if (!hasFront()) {
        return {};
    }
    LegendEntries entries{lineEntry(frontKey, m_curve->pen(), tr("maximum margin by time"))};
    if (m_yours->dataCount() > 0) {
        entries.push_back(
            areaEntry(yoursKey, m_yours->scatterStyle().pen().color(), tr("your cycle")));
    }
    if (m_chosen->dataCount() > 0) {
        entries.push_back(
            areaEntry(chosenKey, m_chosen->scatterStyle().pen().color(), tr("cycle chosen")));
    }
    if (showsTime()) {
        entries.push_back(lineEntry(timeKey, m_time->pen(), tr("time given")));
    }
    return entries;
}

void MarginFrontPlot::setTexts() {
    across()->setLabel(m_unit.titled(tr("Machining time")));
    up()->setLabel(tr("Minimum margin, %"));
}

} // namespace sparkout
