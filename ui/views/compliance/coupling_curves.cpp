// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/coupling_curves.h"

#include "core/project/part.h"
#include "core/units.h"
#include "ui/plot/quantity_line.h"
#include "ui/text/names.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

using style::Drawn;

namespace {

/// The two models often lie closer than the hundredths others are stated in.
QString fine(double value_um) {
    return Names::fixed(value_um, 3);
}

} // namespace

CouplingCurves::CouplingCurves(ViewPlot& plot, QCPAxisRect& rect)
    : LengthCurves(plot, rect)
    , m_independent(addGraph(independentKey))
    , m_coupled(addGraph(coupledKey))
    , m_difference(addGraph(differenceKey)) {}

double CouplingCurves::fromMiddle_um(const SectionResult& section) const {
    return meanDiameterDeviation(section, *m_comparison->independent.project.part) * units::umPerMm
           - middle_um();
}

void CouplingCurves::show(CouplingPtr comparison) {
    m_comparison = std::move(comparison);
    if (m_comparison) {
        drawLimits(*m_comparison->independent.project.part);
    } else {
        clearLimits();
    }
    QVector<double> x, independent, coupled, difference;
    for (std::size_t i = 0; m_comparison && i < m_comparison->differences_mm.size(); ++i) {
        x << m_comparison->independent.sections[i].position_mm;
        independent << fromMiddle_um(m_comparison->independent.sections[i]);
        coupled << fromMiddle_um(m_comparison->coupled.sections[i]);
        difference << m_comparison->differences_mm[i] * units::umPerMm;
    }
    m_independent->setData(x, independent, true);
    m_coupled->setData(x, coupled, true);
    m_difference->setData(x, difference, true);
    restyle();
}

QString CouplingCurves::summary() const {
    const auto largest = std::ranges::max_element(
        m_comparison->differences_mm, {}, [](double difference) { return std::abs(difference); });
    const auto at = static_cast<std::size_t>(largest - m_comparison->differences_mm.begin());
    const auto spread = [this](const SimulationResult& result) {
        const auto [low, high] = std::ranges::minmax_element(
            result.sections, {}, [this](const SectionResult& s) { return fromMiddle_um(s); });
        return fine(fromMiddle_um(*high) - fromMiddle_um(*low));
    };
    const auto time = [](const SimulationResult& result) { return Names::time(result.time_s, 4); };
    QString text =
        tr("Coupling changes the diameter most at %2 mm, by %1 µm. Spread over the length: "
           "independent %3 µm, coupled %4 µm. Time: %5 and %6.")
            .arg(fine(*largest * units::umPerMm),
                 Names::significant(m_comparison->independent.sections[at].position_mm, 4),
                 spread(m_comparison->independent), spread(m_comparison->coupled),
                 time(m_comparison->independent), time(m_comparison->coupled));
    for (const auto& [result, form] : {std::pair(&m_comparison->independent, tr("Independent: %1")),
                                       std::pair(&m_comparison->coupled, tr("Coupled: %1"))}) {
        if (result->status != RunStatus::completed) {
            text += u' ' + form.arg(Names::status(result->status));
        }
    }
    return text;
}

LegendEntries CouplingCurves::legendEntries() const {
    if (!m_comparison) {
        return {};
    }
    const auto line = [this](int key, Drawn what, const QString& text) {
        const QPen pen = style::line(what, plot().toned(what));
        return entry(key, pen.color(), pen.style(), text);
    };
    return {line(independentKey, Drawn::independentSections, tr("sections independent")),
            line(coupledKey, Drawn::coupledSections, tr("sections coupled")),
            line(differenceKey, Drawn::couplingDifference, tr("coupled less independent")),
            limitsEntry()};
}

void CouplingCurves::restyle() {
    const auto look = [this](QCPGraph* graph, Drawn what, QCPScatterStyle::ScatterShape shape) {
        const QColor colour = plot().toned(what);
        graph->setPen(style::line(what, colour));
        graph->setScatterStyle(QCPScatterStyle(shape, QPen(colour, 1.5), colour, 6));
    };
    look(m_independent, Drawn::independentSections, QCPScatterStyle::ssDisc);
    look(m_coupled, Drawn::coupledSections, QCPScatterStyle::ssSquare);
    look(m_difference, Drawn::couplingDifference, QCPScatterStyle::ssDiamond);
    restyleLimits();
}

CsvTable CouplingCurves::table() const {
    CsvTable table;
    if (!m_comparison) {
        return table;
    }
    table.header << tr("Section") << tr("Position, mm")
                 << tr("Independent, mean diameter from the middle, µm")
                 << tr("Coupled, mean diameter from the middle, µm") << tr("Difference, µm");
    for (std::size_t i = 0; i < m_comparison->differences_mm.size(); ++i) {
        const SectionResult& section = m_comparison->independent.sections[i];
        table.rows.push_back({static_cast<double>(i), section.position_mm, fromMiddle_um(section),
                              fromMiddle_um(m_comparison->coupled.sections[i]),
                              m_comparison->differences_mm[i] * units::umPerMm});
    }
    return table;
}

QString CouplingCurves::valuesAt(double x_mm) const {
    if (!m_comparison || m_comparison->differences_mm.empty()) {
        return {};
    }
    const auto& sections = m_comparison->independent.sections;
    const auto nearest = std::ranges::min_element(
        sections, {}, [x_mm](const SectionResult& s) { return std::abs(s.position_mm - x_mm); });
    const auto i = static_cast<std::size_t>(nearest - sections.begin());
    return tr("%1 at %2 mm: independent %3 µm, coupled %4 µm, difference %5 µm")
        .arg(Names::zone(Zone::section, static_cast<int>(i)),
             Names::significant(nearest->position_mm, 4), fine(fromMiddle_um(*nearest)),
             fine(fromMiddle_um(m_comparison->coupled.sections[i])),
             fine(m_comparison->differences_mm[i] * units::umPerMm));
}

} // namespace sparkout
