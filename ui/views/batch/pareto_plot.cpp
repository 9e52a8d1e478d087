// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/batch/pareto_plot.h"

#include "ui/plot/number_ticker.h"
#include "ui/plot/plot_style.h"
#include "ui/plot/quantity_colour.h"
#include "ui/text/names.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr double barShare = 0.7;       ///< of a row
constexpr double roomBeside = 1.05;    ///< beside the longest bar
constexpr double sharePointSize = 6;   ///< [px]
constexpr double whole = 100;          ///< [%]
constexpr std::size_t leastCauses = 5; ///< a single cause is no wall

} // namespace

ParetoPlot::ParetoPlot(QWidget* parent) : ViewPlot(parent) {
    m_rect = addRect();
    m_rect->setMinimumMargins(QMargins(0, 0, 20, 0));
    QCPAxis* const rows = m_rect->axis(QCPAxis::atLeft);
    rows->setRangeReversed(true); // from the top
    rows->grid()->setVisible(false);
    rows->setTickLength(0);
    QCPAxis* const shares = m_rect->axis(QCPAxis::atTop);
    shares->setVisible(true);
    shares->setTickLabels(true);
    shares->setTicks(true);
    m_rect->axis(QCPAxis::atBottom)->setTicker(QSharedPointer<WholeTicker>::create());
    m_bars = new QCPBars(rows, m_rect->axis(QCPAxis::atBottom));
    m_bars->setWidth(barShare);
    m_sum = addGraph(rows, shares);
    m_sum->setAdaptiveSampling(false);
    setKeyed(partsKey, {m_bars});
    setKeyed(sumKey, {m_sum});
    built();
}

const std::vector<RejectCause>& ParetoPlot::causes() const {
    static const std::vector<RejectCause> none;
    return m_outcome ? m_outcome->summary.causes : none;
}

double ParetoPlot::sumAt(std::size_t row) const {
    double upTo = 0, all = 0;
    for (std::size_t i = 0; i < causes().size(); ++i) {
        const auto count = static_cast<double>(causes()[i].count);
        all += count;
        upTo += i <= row ? count : 0;
    }
    return whole * upTo / all;
}

void ParetoPlot::setBatch(BatchOutcomePtr outcome) {
    m_outcome = std::move(outcome);
    QVector<double> rows, counts, sums;
    for (std::size_t i = 0; i < causes().size(); ++i) {
        rows << static_cast<double>(i);
        counts << static_cast<double>(causes()[i].count);
        sums << sumAt(i);
    }
    m_bars->setData(rows, counts, true);
    m_sum->setData(rows, sums, true);
    contentSet();
}

void ParetoPlot::fit() {
    const double most = empty() ? 1 : static_cast<double>(causes().front().count);
    const auto rows = static_cast<double>(std::max(causes().size(), leastCauses));
    style::setSafeRange(*m_rect->axis(QCPAxis::atLeft), -0.5, rows - 0.5);
    style::setSafeRange(*m_rect->axis(QCPAxis::atBottom), 0, most * roomBeside);
    style::setSafeRange(*m_rect->axis(QCPAxis::atTop), 0, whole * roomBeside);
}

// --- what is shown ------------------------------------------------------------------------------

LegendEntries ParetoPlot::legendEntries() const {
    if (empty()) {
        return {};
    }
    return {areaEntry(partsKey, m_bars->brush().color(),
                      tr("parts that fail it; a part that fails several counts at each")),
            lineEntry(sumKey, m_sum->pen(), tr("share of all failures, summed up"))};
}

QString ParetoPlot::nameOf(const RejectCause& cause) {
    return cause.kind ? Names::constraint(*cause.kind) : tr("Size not reached");
}

QStringList ParetoPlot::names() const {
    QStringList names;
    for (const RejectCause& cause : causes()) {
        names << nameOf(cause);
    }
    return names;
}

CsvTable ParetoPlot::table() const {
    return m_outcome ? tableOf(m_outcome->summary) : CsvTable();
}

CsvTable ParetoPlot::tableOf(const BatchSummary& summary) {
    CsvTable table;
    table.header << tr("Cause") << tr("Parts") << tr("Share of the parts, %")
                 << tr("Share of all failures, summed up, %");
    double all = 0, upTo = 0;
    for (const RejectCause& cause : summary.causes) {
        all += static_cast<double>(cause.count);
    }
    for (const RejectCause& cause : summary.causes) {
        const auto count = static_cast<double>(cause.count);
        upTo += count;
        table.rows.push_back({nameOf(cause), count,
                              whole * count / static_cast<double>(summary.parts),
                              whole * upTo / all});
    }
    return table;
}

QString ParetoPlot::valuesAt(const QPointF& at) const {
    const double row = m_rect->axis(QCPAxis::atLeft)->pixelToCoord(at.y());
    const auto i = static_cast<std::ptrdiff_t>(std::lround(row));
    if (!m_rect->rect().contains(at.toPoint()) || i < 0 || i >= std::ssize(causes())) {
        return {};
    }
    const RejectCause& cause = causes()[static_cast<std::size_t>(i)];
    const double share =
        whole * static_cast<double>(cause.count) / static_cast<double>(m_outcome->summary.parts);
    return tr("%1: %n part(s), %2 % of the batch", nullptr, static_cast<int>(cause.count))
        .arg(nameOf(cause), Names::significant(share));
}

// --- look and words -----------------------------------------------------------------------------

void ParetoPlot::restyle() {
    ViewPlot::restyle();
    m_bars->setPen(Qt::NoPen);
    m_bars->setBrush(toned(style::Drawn::frequency));
    const QColor line = toned(style::Drawn::cumulativeShare);
    m_sum->setPen(QPen(line, 1.5));
    m_sum->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, line, line, sharePointSize));
}

void ParetoPlot::setTexts() {
    QSharedPointer<QCPAxisTickerText> rows(new QCPAxisTickerText);
    double at = 0;
    for (const QString& name : names()) {
        rows->addTick(at++, name);
    }
    m_rect->axis(QCPAxis::atLeft)->setTicker(rows);
    m_rect->axis(QCPAxis::atBottom)->setLabel(tr("Parts"));
    m_rect->axis(QCPAxis::atTop)->setLabel(tr("Share of all failures, summed up, %"));
}

} // namespace sparkout
