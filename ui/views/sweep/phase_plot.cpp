// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/sweep/phase_plot.h"

#include "core/project/part.h"
#include "core/units.h"
#include "ui/plot/run_dash.h"
#include "ui/views/sweep/failing_layer.h"
#include "ui/views/sweep/phase_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

using style::Drawn;

namespace {

constexpr double phaseRoom = 0.05; ///< beside and above what is drawn
constexpr int phaseFieldAlpha = 60;
constexpr double pieceEnd = std::numeric_limits<double>::quiet_NaN();

} // namespace

PhasePlot::PhasePlot(QWidget* parent)
    : ViewPlot(parent)
    , m_rect(addRect())
    , m_failing(new FailingLayer(*m_rect))
    , m_field(new QCPItemRect(this))
    , m_largest(addCurve(*m_rect))
    , m_smallest(addCurve(*m_rect))
    , m_stated(addRule(*m_rect, 0)) {
    connect(this, &QCustomPlot::afterLayout, this, [this] {
        if (style::fitValueAxes(*m_rect, font())) {
            replot(rpQueuedReplot);
        }
    });
    m_field->setLayer(QStringLiteral("background"));
    m_field->setClipAxisRect(m_rect);
    anchor({m_field->topLeft, m_field->bottomRight}, *m_rect);
    m_field->topLeft->setTypeX(QCPItemPosition::ptAxisRectRatio);
    m_field->bottomRight->setTypeX(QCPItemPosition::ptAxisRectRatio);
    setKeyed(largestKey, {m_largest});
    setKeyed(smallestKey, {m_smallest});
    setKeyed(toleranceKey, {m_field});
    setKeyed(failsKey, {m_failing});
    setKeyed(statedKey, {m_stated});
    built();
}

void PhasePlot::setPhases(PhaseOutcomePtr phases) {
    m_phases = std::move(phases);
    fill();
    contentSet();
}

void PhasePlot::fill() {
    m_largest->data()->clear();
    m_smallest->data()->clear();
    std::vector<QCPRange> failing;
    if (!m_phases) {
        m_failing->setRanges({});
        return;
    }
    const auto line = [](QCPCurve& curve, const PhasePiece& piece, double from_mm, double to_mm) {
        curve.addData(piece.from_mm, from_mm * units::umPerMm);
        curve.addData(piece.to_mm, to_mm * units::umPerMm);
        curve.addData(piece.to_mm, pieceEnd);
    };
    for (const DecidedPiece& each : m_phases->decision.pieces) {
        const auto low = PhaseText::sizes(each.low), high = PhaseText::sizes(each.high);
        if (low && high) {
            line(*m_largest, each.piece, low->most_mm, high->most_mm);
            line(*m_smallest, each.piece, low->least_mm, high->least_mm);
        }
    }
    for (const StockRange& each : m_phases->decision.failingRanges()) {
        failing.emplace_back(each.from_mm, each.to_mm);
    }
    m_failing->setRanges(std::move(failing));
    const Part& part = *m_phases->project.part;
    m_field->topLeft->setCoords(0, part.upper_deviation_um);
    m_field->bottomRight->setCoords(1, part.lower_deviation_um);
    m_stated->point1->setCoords(part.stock_mm, 0);
    m_stated->point2->setCoords(part.stock_mm, 1);
}

void PhasePlot::fit() {
    if (!m_phases) {
        return;
    }
    const Part& part = *m_phases->project.part;
    double low = part.lower_deviation_um, high = part.upper_deviation_um;
    for (const QCPCurve* curve : {m_largest, m_smallest}) {
        for (const QCPCurveData& at : *curve->data()) {
            if (std::isfinite(at.value)) {
                low = std::min(low, at.value);
                high = std::max(high, at.value);
            }
        }
    }
    const StockRange& range = m_phases->decision.range;
    const double beside = phaseRoom / 2 * (range.to_mm - range.from_mm);
    style::setSafeRange(*across(), range.from_mm - beside, range.to_mm + beside);
    style::setRoomyRange(*up(), low, high, phaseRoom, 0);
}

std::vector<QCPRange> PhasePlot::failing() const {
    return m_failing->ranges();
}

double PhasePlot::statedStock_mm() const {
    return m_stated->point1->key();
}

QString PhasePlot::valuesAt(const QPointF& at) const {
    return m_phases && m_rect->rect().contains(at.toPoint())
               ? PhaseText::stock(m_phases->decision, across()->pixelToCoord(at.x()))
               : QString();
}

// --- table, look and words ----------------------------------------------------------------------

CsvTable PhasePlot::table() const {
    CsvTable table;
    if (!m_phases) {
        return table;
    }
    const std::vector<DecidedPiece>& pieces = m_phases->decision.pieces;
    std::size_t stages = 0;
    for (const DecidedPiece& each : pieces) {
        stages = std::max(stages, each.piece.counts.size());
    }
    table.header << tr("From stock per side, mm") << tr("To stock per side, mm");
    for (std::size_t i = 0; i < stages; ++i) {
        table.header << tr("Steps of stage %1").arg(i + 1);
    }
    table.header << tr("Time, min") << tr("Minimum deviation of the diameter, µm")
                 << tr("Maximum deviation of the diameter, µm") << tr("Verdict");
    const QCPRange seen = across()->range();
    for (const DecidedPiece& each : pieces) {
        if (each.piece.to_mm < seen.lower || each.piece.from_mm > seen.upper) {
            continue;
        }
        std::vector<CsvCell> row{each.piece.from_mm, each.piece.to_mm};
        for (std::size_t i = 0; i < stages; ++i) {
            row.push_back(i < each.piece.counts.size() ? CsvCell(double(each.piece.counts[i]))
                                                       : CsvCell());
        }
        row.emplace_back(each.time_s / units::secondsPerMinute);
        const auto low = PhaseText::sizes(each.low), high = PhaseText::sizes(each.high);
        row.push_back(low && high ? CsvCell(low->least_mm * units::umPerMm) : CsvCell());
        row.push_back(low && high ? CsvCell(high->most_mm * units::umPerMm) : CsvCell());
        row.emplace_back(PhaseText::pieceVerdict(each));
        table.rows.push_back(std::move(row));
    }
    return table;
}

void PhasePlot::restyle() {
    ViewPlot::restyle();
    m_largest->setPen(runPen(0, toned(style::oneOfSeries(0))));
    m_smallest->setPen(runPen(1, toned(style::oneOfSeries(1))));
    const QColor field = toned(Drawn::toleranceField);
    m_field->setPen(field);
    m_field->setBrush(style::dimmed(
        style::filling(style::colour(Drawn::toleranceField, palette()), phaseFieldAlpha, palette()),
        isDimmed()));
    m_failing->setColour(toned(Drawn::fails));
    m_stated->setPen(QPen(ink(), 1.5, Qt::DotLine));
}

LegendEntries PhasePlot::legendEntries() const {
    if (!m_phases) {
        return {};
    }
    LegendEntries entries{lineEntry(largestKey, m_largest->pen(), tr("maximum diameter")),
                          lineEntry(smallestKey, m_smallest->pen(), tr("minimum diameter")),
                          areaEntry(toleranceKey, m_field->brush().color(), tr("tolerance band"))};
    if (!m_failing->ranges().empty()) {
        entries.push_back(areaEntry(failsKey, m_failing->area(), tr("stocks that fail")));
        entries.back().hatch = Hatch::rising;
        entries.back().hatchLine = m_failing->colour();
    }
    entries.push_back(lineEntry(statedKey, m_stated->pen(), tr("stated stock")));
    return entries;
}

void PhasePlot::setTexts() {
    across()->setLabel(tr("Stock per side, mm"));
    up()->setLabel(tr("Deviation of the diameter from nominal, µm"));
}

} // namespace sparkout
