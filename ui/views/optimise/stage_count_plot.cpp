// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/optimise/stage_count_plot.h"

#include "core/units.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/views/optimise/optimise_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

constexpr std::array countsDrawn{style::Drawn::quickestCycle, style::Drawn::lowerBound,
                                 style::Drawn::yourCycle, style::Drawn::steplessLimit};
constexpr std::array countPens{Qt::SolidLine, Qt::NoPen, Qt::DashLine, Qt::DotLine};
constexpr double beside = 0.5; ///< of the first and last number of stages, drawn [stages]

double inMinutes(double time_s) {
    return time_s / units::secondsPerMinute;
}

} // namespace

StageCountPlot::StageCountPlot(QWidget* parent) : ViewPlot(parent) {
    setNotAntialiasedElements(QCP::aeAll);
    setAntialiasedElements(QCP::aePlottables | QCP::aeScatters);
    m_rect = addRect();
    QSharedPointer<QCPAxisTickerFixed> whole(new QCPAxisTickerFixed);
    whole->setTickStep(1);
    m_rect->axis(QCPAxis::atBottom)->setTicker(whole);
    for (std::size_t key = 0; key < m_curves.size(); ++key) {
        m_curves[key] = addLine(*m_rect);
        setKeyed(static_cast<int>(key), {m_curves[key]});
    }
    m_curves[proven]->setLineStyle(QCPGraph::lsNone);
    built();
}

void StageCountPlot::setSearch(SearchOutcomePtr outcome, std::optional<double> before_s) {
    m_outcome = std::move(outcome);
    m_before_s = before_s;
    fill();
    showChoice();
    fit();
    emit contentChanged();
}

void StageCountPlot::fill() {
    for (QCPGraph* curve : m_curves) {
        curve->data()->clear();
    }
    if (!m_outcome || m_outcome->numbers.empty()) {
        return;
    }
    for (const SearchedNumber& number : m_outcome->numbers) {
        if (number.search.best && number.holds) {
            m_curves[quickest]->addData(number.stages, inMinutes(number.search.best->time_s));
        }
        if (number.search.status == SearchStatus::stopped && number.search.bound_s > 0) {
            m_curves[proven]->addData(number.stages, inMinutes(number.search.bound_s));
        }
    }
    const auto [first, last] = std::ranges::minmax(m_outcome->numbers, {}, &SearchedNumber::stages);
    const auto across = [&, from = first.stages - beside,
                         to = last.stages + beside](Key key, double time_s) {
        m_curves[key]->addData(from, inMinutes(time_s));
        m_curves[key]->addData(to, inMinutes(time_s));
    };
    if (m_before_s) {
        across(before, *m_before_s);
    }
    if (std::isfinite(m_outcome->limit_s) && m_outcome->limit_s > 0) {
        across(limit, m_outcome->limit_s);
    }
}

void StageCountPlot::fit() {
    double from = 1, to = 1, most = 0;
    for (const QCPGraph* curve : m_curves) {
        for (const QCPGraphData& point : *curve->data()) {
            from = std::min(from, point.key);
            to = std::max(to, point.key);
            most = std::max(most, point.value);
        }
    }
    style::setSafeRange(*m_rect->axis(QCPAxis::atBottom), std::min(from, 1 - beside),
                        std::max(to, 1 + beside));
    style::setSafeRange(*m_rect->axis(QCPAxis::atLeft), 0, most > 0 ? 1.08 * most : 1);
}

// --- what is shown ------------------------------------------------------------------------------

QString StageCountPlot::name(Key key) {
    switch (key) {
    case quickest: return tr("quickest cycle");
    case proven: return tr("none is below");
    case before: return tr("your cycle");
    case limit: break;
    }
    return tr("stepless limit");
}

LegendEntries StageCountPlot::legendEntries() const {
    LegendEntries entries;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        if (!m_curves[i]->data()->isEmpty()) {
            entries.push_back(lineEntry(static_cast<int>(i),
                                        {toned(countsDrawn[i]), 1, countPens[i]},
                                        name(static_cast<Key>(i))));
        }
    }
    return entries;
}

CsvTable StageCountPlot::table() const {
    return tableOf(m_outcome ? *m_outcome : SearchOutcome());
}

CsvTable StageCountPlot::tableOf(const SearchOutcome& outcome) {
    CsvTable table;
    table.header << tr("Stages") << tr("Quickest cycle, min") << tr("None is below, min")
                 << tr("Stepless limit, min");
    for (const SearchedNumber& number : outcome.numbers) {
        const bool found = number.search.best && number.holds;
        table.rows.push_back({double(number.stages),
                              found ? CsvCell(inMinutes(number.search.best->time_s)) : CsvCell(),
                              inMinutes(number.search.bound_s), inMinutes(outcome.limit_s)});
    }
    return table;
}

QString StageCountPlot::valuesAt(const QPointF& at) const {
    const int stages =
        static_cast<int>(std::lround(m_rect->axis(QCPAxis::atBottom)->pixelToCoord(at.x())));
    if (!m_outcome || !m_rect->rect().contains(at.toPoint())) {
        return {};
    }
    const auto& numbers = m_outcome->numbers;
    const auto number = std::ranges::find(numbers, stages, &SearchedNumber::stages);
    if (number == numbers.end()) {
        return {};
    }
    const QString who = tr("%n stage(s)", nullptr, stages);
    return number->search.best && number->holds
               ? tr("%1: %2 min").arg(who, OptimiseText::minutes(number->search.best->time_s))
               : tr("%1: no cycle was found that holds every requirement").arg(who);
}

// --- look and words -----------------------------------------------------------------------------

void StageCountPlot::restyle() {
    ViewPlot::restyle();
    constexpr double thick = 2, point = 8;
    for (std::size_t i = 0; i < m_curves.size(); ++i) {
        m_curves[i]->setPen(QPen(toned(countsDrawn[i]), thick, countPens[i]));
    }
    const auto scatter = [&](Key key, QCPScatterStyle::ScatterShape shape) {
        const QColor colour = m_curves[key]->pen().color();
        m_curves[key]->setScatterStyle(QCPScatterStyle(shape, QPen(colour, thick), colour, point));
    };
    scatter(quickest, QCPScatterStyle::ssDisc);
    scatter(proven, QCPScatterStyle::ssTriangle);
}

void StageCountPlot::setTexts() {
    m_rect->axis(QCPAxis::atBottom)->setLabel(tr("Number of stages"));
    m_rect->axis(QCPAxis::atLeft)->setLabel(tr("Machining time, min"));
}

} // namespace sparkout
