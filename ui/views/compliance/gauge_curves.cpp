// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/compliance/gauge_curves.h"

#include "core/process/system_compliance.h"
#include "core/project/part.h"
#include "core/units.h"
#include "ui/plot/run_dash.h"
#include "ui/text/names.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

constexpr std::size_t mostSections = 6; ///< drawn individually

} // namespace

GaugeCurves::GaugeCurves(ViewPlot& plot, QCPAxisRect& rect)
    : LengthCurves(plot, rect)
    , m_lowest(addGraph(spreadKey))
    , m_highest(addGraph(spreadKey))
    , m_farthest(addGraph(farthestKey))
    , m_present(addGraph(presentKey))
    , m_best(addGraph(bestKey)) {
    m_highest->setChannelFillGraph(m_lowest);
    for (QCPGraph* mark : {m_present, m_best}) {
        mark->setLineStyle(QCPGraph::lsImpulse);
    }
}

double GaugeCurves::farthest_um(const GaugePosition& position) const {
    return std::max(position.deviationMax_mm * units::umPerMm - middle_um(),
                    middle_um() - position.deviationMin_mm * units::umPerMm);
}

double GaugeCurves::farthestNow_um() const {
    double farthest = 0;
    for (const SectionResult& section : m_outcome->result.sections) {
        for (const double deviation_mm :
             {section.diameterDeviationMin_mm, section.diameterDeviationMax_mm}) {
            farthest = std::max(farthest, std::abs(deviation_mm * units::umPerMm - middle_um()));
        }
    }
    return farthest;
}

const GaugePosition* GaugeCurves::best() const {
    return m_placement && m_placement->best ? &m_placement->positions[*m_placement->best] : nullptr;
}

std::vector<GaugeCurves::Drawn> GaugeCurves::drawn() const {
    std::vector<Drawn> places;
    const Project& project = m_outcome->result.project;
    const auto zones = compliantPoints(project);
    for (const GaugePosition& position : m_placement->positions) {
        if (project.operation->hasZones) {
            const CompliantPoint& zone = zones[static_cast<std::size_t>(position.zone)];
            places.push_back({zone.position_mm - zone.length_mm / 2, &position});
            places.push_back({zone.position_mm + zone.length_mm / 2, &position});
        } else {
            places.push_back({position.position_mm, &position});
        }
    }
    return places;
}

/// All if they are few, otherwise a selection from end to end.
std::vector<std::size_t> GaugeCurves::drawnSections() const {
    const std::size_t all = m_outcome ? m_outcome->result.sections.size() : 0;
    const std::size_t count = std::min(all, mostSections);
    std::vector<std::size_t> sections;
    for (std::size_t i = 0; i < count; ++i) {
        sections.push_back(count < 2 ? 0 : i * (all - 1) / (count - 1));
    }
    return sections;
}

void GaugeCurves::show(GaugePlacementPtr placement, OutcomePtr outcome, double present_mm) {
    m_placement = std::move(placement);
    m_outcome = std::move(outcome);
    takeField(*m_outcome->result.project.part);
    const std::vector<Drawn> places = drawn();
    QVector<double> x, low, high, far;
    constexpr double gap = std::numeric_limits<double>::quiet_NaN();
    for (const auto& [x_mm, position] : places) {
        const bool ended = position->status == RunStatus::completed;
        x << x_mm;
        low << (ended ? position->deviationMin_mm * units::umPerMm - middle_um() : gap);
        high << (ended ? position->deviationMax_mm * units::umPerMm - middle_um() : gap);
        far << (ended ? farthest_um(*position) : gap);
    }
    m_lowest->setData(x, low, true);
    m_highest->setData(x, high, true);
    m_farthest->setData(x, far, true);
    drawSections(places, x);
    const GaugePosition* best = this->best();
    m_best->setData(best ? QVector<double>{best->position_mm} : QVector<double>(),
                    best ? QVector<double>{farthest_um(*best)} : QVector<double>(), true);
    m_present->setData({present_mm}, {farthestNow_um()}, true);
    drawLimits(*m_outcome->result.project.part);
    restyle();
}

void GaugeCurves::drawSections(const std::vector<Drawn>& places, const QVector<double>& x) {
    const std::vector<std::size_t> sections = drawnSections();
    while (m_sections.size() < sections.size()) {
        m_sections.push_back(addGraph(sectionKey + static_cast<int>(m_sections.size())));
    }
    for (std::size_t i = 0; i < m_sections.size(); ++i) {
        QVector<double> mean;
        for (const Drawn& place : places) {
            const auto& means = place.position->meanDeviations_mm;
            const bool known = place.position->status == RunStatus::completed && i < sections.size()
                               && sections[i] < means.size();
            mean << (known ? means[sections[i]] * units::umPerMm - middle_um()
                           : std::numeric_limits<double>::quiet_NaN());
        }
        m_sections[i]->setData(x, mean, true);
    }
}

QString GaugeCurves::nameOf(std::size_t section) const {
    return Names::zone(m_outcome->result.sections[section].zone, static_cast<int>(section));
}

QColor GaugeCurves::colourOf(std::size_t section) const {
    return plot().toned(style::oneOfSeries(section));
}

LegendEntries GaugeCurves::legendEntries() const {
    if (!m_placement) {
        return {};
    }
    const QColor text = plot().ink();
    LegendEntries entries{
        entry(farthestKey, text, Qt::SolidLine, tr("farthest from the middle")),
        entry(bestKey, plot().toned(style::Drawn::bestGaugePlace), Qt::NoPen, tr("best place")),
        entry(presentKey, plot().toned(style::Drawn::presentGaugePlace), Qt::NoPen,
              tr("current place")),
        entry(spreadKey, plot().toned(style::Drawn::allDiameters), Qt::NoPen, tr("all diameters"))};
    const std::vector<std::size_t> sections = drawnSections();
    for (std::size_t i = 0; i < sections.size(); ++i) {
        entries.push_back(entry(sectionKey + static_cast<int>(i), colourOf(i), Qt::SolidLine,
                                nameOf(sections[i])));
        entries.back().dash = runDash(static_cast<int>(i));
    }
    entries.push_back(limitsEntry());
    return entries;
}

void GaugeCurves::restyle() {
    QColor spread = plot().toned(style::Drawn::allDiameters);
    m_lowest->setPen(Qt::NoPen);
    m_highest->setPen(Qt::NoPen);
    spread.setAlpha(spread.alpha() / 4);
    m_highest->setBrush(spread);
    m_farthest->setPen(QPen(plot().ink(), 2.5));
    const auto mark = [&](QCPGraph* graph, style::Drawn what, QCPScatterStyle::ScatterShape shape,
                          double size) {
        const QColor colour = plot().toned(what);
        graph->setPen(QPen(colour, 1.5, Qt::DotLine));
        graph->setScatterStyle(QCPScatterStyle(shape, QPen(colour, 2), colour, size));
    };
    mark(m_best, style::Drawn::bestGaugePlace, QCPScatterStyle::ssDiamond, 12);
    mark(m_present, style::Drawn::presentGaugePlace, QCPScatterStyle::ssDisc, 9);
    for (std::size_t i = 0; i < m_sections.size(); ++i) {
        m_sections[i]->setPen(runPen(static_cast<int>(i), colourOf(i)));
    }
    restyleLimits();
}

QString GaugeCurves::placeLabel() const {
    return tr("Place of the gauge from the headstock end of the ground length, mm");
}

CsvTable GaugeCurves::table() const {
    CsvTable table;
    if (!m_placement) {
        return table;
    }
    table.header << tr("Gauge at, mm") << tr("Compliance there, mm/N") << tr("Minimum diameter, µm")
                 << tr("Maximum diameter, µm") << tr("Farthest from the middle, µm")
                 << tr("Margin to the limits, µm") << tr("Time, s") << tr("Cycle ended by");
    for (std::size_t i = 0; i < m_outcome->result.sections.size(); ++i) {
        table.header << tr("%1, mean diameter, µm").arg(nameOf(i));
    }
    for (const GaugePosition& position : m_placement->positions) {
        std::vector<CsvCell> row{position.position_mm,
                                 position.compliance_mm_per_n,
                                 position.deviationMin_mm * units::umPerMm - middle_um(),
                                 position.deviationMax_mm * units::umPerMm - middle_um(),
                                 farthest_um(position),
                                 position.margin_mm * units::umPerMm,
                                 position.time_s,
                                 Names::status(position.status)};
        for (const double mean_mm : position.meanDeviations_mm) {
            row.emplace_back(mean_mm * units::umPerMm - middle_um());
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

QString GaugeCurves::valuesAt(double x_mm) const {
    if (!m_placement || m_placement->positions.empty()) {
        return {};
    }
    const std::vector<Drawn> places = drawn();
    const auto nearest = std::ranges::min_element(
        places, {}, [x_mm](const Drawn& place) { return std::abs(place.x_mm - x_mm); });
    const GaugePosition& at = *nearest->position;
    if (at.status != RunStatus::completed) {
        return tr("Gauge at %1 mm: %2")
            .arg(QLocale().toString(at.position_mm, 'f', 1), Names::status(at.status));
    }
    return tr("Gauge at %1 mm: diameters from %2 (%3) to %4 µm (%5), at most %6 µm from "
              "the middle of the field")
        .arg(QLocale().toString(at.position_mm, 'f', 1),
             Names::signedMicrometres(at.deviationMin_mm * units::umPerMm - middle_um()),
             nameOf(at.sectionOfMin),
             Names::signedMicrometres(at.deviationMax_mm * units::umPerMm - middle_um()),
             nameOf(at.sectionOfMax), Names::micrometres(farthest_um(at)));
}

} // namespace sparkout
