// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/constraints/constraints_plot.h"

#include "core/units.h"
#include "ui/plot/hair_line.h"
#include "ui/plot/number_ticker.h"
#include "ui/plot/plot_style.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"

#include <QMouseEvent>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <tuple>

namespace sparkout {

namespace {

using style::Hue;
using units::umPerMm;

constexpr double lowest_um = 1e-6;    ///< drawn in place of 0, which has no logarithm
constexpr double feedHeadroom = 1.15; ///< above the highest value
constexpr double limitsInSight = 3;   ///< times the deepest cut, of limits that rise beyond
constexpr double decades = 1e-4;      ///< of the deepest cut, in sight at most
constexpr double forbidden_um = 1e6;  ///< far above all plots
constexpr int forbiddenAlpha = 34;
constexpr double markSize = 13, cutSize = 3.5, exceededSize = 6;

/// Of the limits, in their order; those beyond look like the last.
constexpr std::tuple<Hue, Qt::PenStyle> limitPens[] = {{Hue::vermilion, Qt::DashLine},
                                                       {Hue::orange, Qt::DashDotLine},
                                                       {Hue::green, Qt::DashLine},
                                                       {Hue::sky, Qt::DashDotDotLine},
                                                       {Hue::purple, Qt::DotLine}};

void setPoints(QCPGraph& graph, const LimitPoints& points) {
    QVector<double> x, y;
    for (const LimitPoint& point : points) {
        x << point.stock_mm * umPerMm;
        y << std::max(point.depth_mm * umPerMm, lowest_um);
    }
    graph.setData(x, y, true);
}

} // namespace

ConstraintsPlot::ConstraintsPlot(QWidget* parent) : ViewPlot(parent) {
    setNotAntialiasedElements(QCP::aeFills | QCP::aeGrid | QCP::aeAxes);
    build();
    restyle();
    retranslate();
    m_moment = new HairLine(*this, HairLine::Role::moment);
    connect(this, &QCustomPlot::afterLayout, this, &ConstraintsPlot::placeMark);
    connect(this, &QCustomPlot::mouseMove, this, &ConstraintsPlot::onMouse);
    setBuilt();
}

QCPGraph* ConstraintsPlot::addLine() {
    QCPGraph* graph = addGraph(stockAxis(), feedAxis());
    graph->removeFromLegend();
    graph->setSelectable(QCP::stNone);
    graph->setAdaptiveSampling(false);
    return graph;
}

void ConstraintsPlot::build() {
    plotLayout()->clear();
    m_rect = new QCPAxisRect(this, true);
    plotLayout()->addElement(0, 0, m_rect);
    m_rect->setMinimumMargins(QMargins(0, 6, 14, 0));
    for (QCPAxis* axis : m_rect->axes()) {
        style::setUpAxis(*axis);
    }
    for (const auto side : {QCPAxis::atTop, QCPAxis::atRight}) {
        m_rect->axis(side)->setVisible(true);
        m_rect->axis(side)->setTicks(false);
    }
    stockAxis()->setRangeReversed(true);
    m_ceiling = addLine();
    m_stepless = addLine();
    m_stepless->setChannelFillGraph(m_ceiling);
    for (const ConstraintKind kind : depthLimitKinds()) {
        m_limits[kind] = addLine();
    }
    for (QCPCurve** curve : {&m_actual, &m_exceeded, &m_mark}) {
        *curve = new QCPCurve(stockAxis(), feedAxis());
        (*curve)->removeFromLegend();
        (*curve)->setSelectable(QCP::stNone);
    }
    m_exceeded->setLineStyle(QCPCurve::lsNone);
    m_mark->setLineStyle(QCPCurve::lsNone);
    m_markText = new QCPItemText(this);
    m_markText->setSelectable(false);
    m_markText->setClipToAxisRect(true);
    m_markText->position->setAxisRect(m_rect);
    m_markText->position->setAxes(stockAxis(), feedAxis());
    m_markText->position->setType(QCPItemPosition::ptPlotCoords);
    m_markText->setPadding(QMargins(10, 6, 10, 6));
    connect(feedAxis(), QOverload<const QCPRange&>::of(&QCPAxis::rangeChanged), this,
            &ConstraintsPlot::contentChanged); // the legend names what is out of sight
}

const LimitGroup* ConstraintsPlot::shownGroup() const {
    return m_outcome && m_group >= 0 ? &m_outcome->limits.groups[static_cast<std::size_t>(m_group)]
                                     : nullptr;
}

void ConstraintsPlot::setRun(OutcomePtr outcome, int group) {
    const bool same = m_outcome && m_group == group && !m_fitNext;
    m_fitNext = false;
    m_outcome = std::move(outcome);
    m_group = group;
    fill();
    feedAxis()->setLabel(feedLabel());
    if (same) {
        refit();
    } else {
        fit();
    }
    emit contentChanged();
}

void ConstraintsPlot::fill() {
    const LimitGroup* group = shownGroup();
    for (const auto& [kind, graph] : m_limits) {
        const bool shown = group && !LimitNames::isGuess(kind, m_outcome->result.project);
        setPoints(*graph, shown ? limitCurve(m_outcome->limits, *group, kind) : LimitPoints());
    }
    const LimitPoints stepless = group ? steplessLimit(m_outcome->limits, *group) : LimitPoints();
    setPoints(*m_stepless, stepless);
    LimitPoints ceiling;
    if (!stepless.empty()) {
        ceiling = {{stepless.front().stock_mm, forbidden_um / umPerMm},
                   {stepless.back().stock_mm, forbidden_um / umPerMm}};
    }
    setPoints(*m_ceiling, ceiling);
    fillCuts(group ? *group : LimitGroup());
    fillMark();
    show();
}

void ConstraintsPlot::fillCuts(const LimitGroup& group) {
    QVector<double> x, y, aboveX, aboveY;
    for (const LimitedCut& cut : group.cuts) {
        const double stock_um = cut.stock_mm * umPerMm, depth_um = cut.depth_mm * umPerMm;
        x << stock_um;
        y << std::max(depth_um, lowest_um);
        if (cut.usage > 1) {
            aboveX << stock_um;
            aboveY << depth_um;
        }
    }
    m_actual->setData(x, y);
    m_exceeded->setData(aboveX, aboveY);
}

void ConstraintsPlot::setMarked(const std::optional<ConstraintResult>& requirement) {
    m_requirement = requirement;
    fillMark();
}

void ConstraintsPlot::fillMark() {
    m_markedCut.reset();
    const LimitGroup* group = shownGroup();
    if (group && m_requirement) {
        m_markedCut = limitedCutOf(m_outcome->result, m_outcome->trajectory, *m_requirement);
        if (m_markedCut && limitGroupAt(m_outcome->limits, m_markedCut->place) != m_group) {
            m_markedCut.reset();
        }
    } else if (group && group->worst.depth_mm > 0 && m_stepless->dataCount() > 0) {
        m_markedCut = group->worst;
    }
    m_mark->data()->clear();
    if (m_markedCut) {
        m_mark->addData(m_markedCut->stock_mm * umPerMm,
                        std::max(m_markedCut->depth_mm * umPerMm, lowest_um));
        m_markText->position->setCoords(m_markedCut->stock_mm * umPerMm,
                                        m_markedCut->depth_mm * umPerMm);
    }
    m_markText->setText(markText());
    m_markText->setVisible(m_markedCut.has_value());
}

/// The text stands on the side of the mark that has room.
void ConstraintsPlot::placeMark() {
    style::fitValueAxes(*m_rect, font());
    if (!m_markedCut) {
        return;
    }
    const QPointF at(stockAxis()->coordToPixel(m_markedCut->stock_mm * umPerMm),
                     feedAxis()->coordToPixel(m_markedCut->depth_mm * umPerMm));
    const bool right = at.x() < m_rect->rect().center().x();
    const bool below = at.y() < m_rect->rect().center().y();
    m_markText->setPositionAlignment((right ? Qt::AlignLeft : Qt::AlignRight)
                                     | (below ? Qt::AlignTop : Qt::AlignBottom));
}

void ConstraintsPlot::setMoment(std::optional<double> stock_mm) {
    m_moment->setAt(stock_mm ? std::optional(*stock_mm * umPerMm) : std::nullopt);
}

std::optional<double> ConstraintsPlot::moment_um() const {
    return m_moment->at();
}

QCPGraph* ConstraintsPlot::limit(ConstraintKind kind) const {
    const auto found = m_limits.find(kind);
    return found != m_limits.end() && found->second->dataCount() > 0 ? found->second : nullptr;
}

/// What is chosen in the legend.
void ConstraintsPlot::show() {
    for (const auto& [kind, graph] : m_limits) {
        graph->setVisible(m_choice.shows(static_cast<int>(kind)));
    }
    m_stepless->setVisible(m_choice.shows(steplessKey));
    m_ceiling->setVisible(m_choice.shows(steplessKey));
    m_actual->setVisible(m_choice.shows(actualKey));
    m_exceeded->setVisible(m_choice.shows(actualKey));
}

double ConstraintsPlot::highestCut() const {
    double highest = 0;
    for (const QCPCurveData& point : *m_actual->data()) {
        highest = std::max(highest, point.value);
    }
    return highest;
}

/// What is to be seen of the feeds: the cuts, and always some of the limit.
double ConstraintsPlot::highestFeed() const {
    const double cut = highestCut();
    bool found = false;
    const QCPRange limit = m_stepless->getValueRange(found);
    if (!found) {
        return cut > 0 ? cut : 1;
    }
    return cut > 0
               ? std::max(cut, std::min(limit.upper, std::max(limitsInSight * cut, limit.lower)))
               : limit.upper;
}

void ConstraintsPlot::fit() {
    fitStock();
    fitFeeds();
}

/// Each axis nobody has zoomed, so that one run has one picture, whether an edit or its undo led
/// to it; and the stock's where nothing of the cycle would be left of it.
void ConstraintsPlot::refit() {
    const QCPRange stock = stockAxis()->range();
    const LimitSeries& series = m_outcome->limits;
    if (stock == m_fittedStock || series.deepest_mm * umPerMm < stock.lower
        || series.least_mm * umPerMm > stock.upper) {
        fitStock();
    }
    if (feedAxis()->range() == m_fittedFeeds) {
        fitFeeds();
    }
}

void ConstraintsPlot::fitStock() {
    const LimitSeries* series = m_outcome ? &m_outcome->limits : nullptr;
    const double from = series ? series->least_mm * umPerMm : 0;
    const double to = series ? series->deepest_mm * umPerMm : 1;
    const double border = 0.02 * (to - from);
    style::setSafeRange(*stockAxis(), from - border, to + border);
    m_fittedStock = stockAxis()->range();
}

void ConstraintsPlot::fitFeeds() {
    const double high = highestFeed();
    bool found = false;
    const QCPRange limit = m_stepless->getValueRange(found);
    if (feedAxis()->scaleType() == QCPAxis::stLogarithmic) {
        double least = found ? std::min(high, limit.lower) : high;
        for (const QCPCurveData& point : *m_actual->data()) {
            least = std::min(least, point.value);
        }
        const double top = std::max(high, found ? limit.upper : 0) * 2;
        style::setSafeRange(*feedAxis(), std::clamp(least / 2, high * decades, top / 10), top);
    } else {
        style::setSafeRange(*feedAxis(), 0, high * feedHeadroom);
    }
    m_fittedFeeds = feedAxis()->range();
}

void ConstraintsPlot::setLogarithmic(bool on) {
    feedAxis()->setScaleType(on ? QCPAxis::stLogarithmic : QCPAxis::stLinear);
    feedAxis()->setTicker(on ? QSharedPointer<QCPAxisTicker>(new QCPAxisTickerLog)
                             : QSharedPointer<QCPAxisTicker>(new NumberTicker));
    feedAxis()->setSubTicks(on);
    fit();
}

void ConstraintsPlot::choose(int key, bool only) {
    if (only) {
        m_choice.only(key, legendEntries());
    } else {
        m_choice.toggle(key);
    }
    show();
    emit contentChanged();
    replot();
}

void ConstraintsPlot::toggleCurve(int key) {
    choose(key, false);
}

void ConstraintsPlot::showOnly(int key) {
    choose(key, true);
}

// --- look ---------------------------------------------------------------------------------------

QPen ConstraintsPlot::penOf(int key) const {
    const auto pen = [this](Hue hue, double width, Qt::PenStyle dashes) {
        return QPen(style::dimmed(style::colour(hue, palette()), isDimmed()), width, dashes);
    };
    if (key == actualKey) {
        return pen(Hue::blue, 1.6, Qt::SolidLine);
    }
    if (key == steplessKey) {
        return {style::dimmed(palette().color(QPalette::Text), isDimmed()), 3, Qt::SolidLine};
    }
    const std::vector<ConstraintKind> kinds = depthLimitKinds();
    const auto place = static_cast<std::size_t>(
        std::ranges::find(kinds, static_cast<ConstraintKind>(key)) - kinds.begin());
    const auto [hue, dashes] = limitPens[std::min(place, std::size(limitPens) - 1)];
    return pen(hue, 1.6, dashes);
}

LegendEntries ConstraintsPlot::legendEntries() const {
    LegendEntries entries;
    const auto add = [&](int key, const QString& name) {
        const QPen pen = penOf(key);
        entries.push_back({pen.color(), pen.style(), name, key, m_choice.shows(key)});
    };
    if (!shownGroup()) {
        return entries;
    }
    add(actualKey, tr("actual feed"));
    if (m_stepless->dataCount() > 0) {
        add(steplessKey, tr("stepless limit, forbidden above"));
    }
    for (const ConstraintKind kind : depthLimitKinds()) {
        const QCPGraph* graph = limit(kind);
        if (!graph) {
            continue;
        }
        bool found = false;
        const double least = graph->getValueRange(found).lower;
        const QString name = LimitNames::limit(kind);
        add(static_cast<int>(kind),
            least > feedAxis()->range().upper
                ? tr("%1 (above the plot: from %2 µm)").arg(name, Names::significant(least))
                : name);
    }
    return entries;
}

void ConstraintsPlot::restyle() {
    style::applyPalette(*this, palette());
    for (QCPAxis* axis : m_rect->axes()) {
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
    }
    for (const auto& [kind, graph] : m_limits) {
        graph->setPen(penOf(static_cast<int>(kind)));
    }
    QColor forbidden = style::colour(Hue::vermilion, palette());
    forbidden.setAlpha(isDimmed() ? forbiddenAlpha / 3 : forbiddenAlpha);
    m_stepless->setPen(penOf(steplessKey));
    m_stepless->setBrush(forbidden);
    m_ceiling->setPen(Qt::NoPen);
    const QPen actual = penOf(actualKey);
    m_actual->setPen(actual);
    m_actual->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDisc, actual.color(), actual.color(), cutSize));
    const QColor alarm = style::dimmed(style::colour(Hue::vermilion, palette()), isDimmed());
    m_exceeded->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssSquare, alarm, alarm, exceededSize));
    const QColor text = style::dimmed(palette().color(QPalette::Text), isDimmed());
    m_mark->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(text, 2), Qt::NoBrush, markSize));
    QColor paper = palette().color(QPalette::Base);
    paper.setAlpha(200);
    m_markText->setBrush(paper);
    m_markText->setColor(text);
    m_markText->setFont(font());
}

/// A cut is a revolution's where the wheel plunges or stands, else a stroke's.
QString ConstraintsPlot::feedLabel() const {
    const LimitGroup* group = shownGroup();
    const bool stroke =
        group && !group->standing && m_outcome->result.project.operation->countsStrokes;
    return stroke ? tr("Actual feed, µm per pass") : tr("Actual feed, µm per revolution");
}

void ConstraintsPlot::setTexts() {
    stockAxis()->setLabel(tr("Stock left after the cut, µm"));
    feedAxis()->setLabel(feedLabel());
    m_markText->setText(markText());
}

} // namespace sparkout
