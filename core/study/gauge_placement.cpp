// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/gauge_placement.h"

#include "core/process/system_compliance.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/simulation/simulate.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <utility>

namespace sparkout {

CouplingAnswer couplingOf(const Project& project) {
    if (project.operation->travels) {
        return CouplingAnswer::traverse;
    }
    const bool given =
        !std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n);
    return given ? CouplingAnswer::givenCompliance : CouplingAnswer::comparable;
}

double meanDiameterDeviation(const SectionResult& section, const Part& part) {
    return 2 * meanOfGround(section.radii_mm) - part.diameter_mm;
}

CouplingComparison compareCoupling(const Project& project, const std::stop_token& stop) {
    CouplingComparison both;
    Project run = project;
    run.machine->zone_compliance.reset(); // coupled sections have none
    run.sections_coupled = false;
    both.independent = simulateUnchecked(run, nullptr, stop);
    run.sections_coupled = true;
    both.coupled = simulateUnchecked(run, nullptr, stop);
    for (std::size_t i = 0; i < both.coupled.sections.size(); ++i) {
        both.differences_mm.push_back(
            meanDiameterDeviation(both.coupled.sections[i], *project.part)
            - meanDiameterDeviation(both.independent.sections[i], *project.part));
    }
    return both;
}

namespace {

/// The zone that contains a place of the ground length.
Zone zoneAt(const Project& project, double position_mm) {
    const ZoneLengths zones = zoneLengths(project);
    const double fromEntry = project.machine->entry_side == EntrySide::headstock
                                 ? position_mm
                                 : project.part->length_mm - position_mm;
    if (fromEntry < zones.rz1) {
        return Zone::rz1;
    }
    return fromEntry <= zones.rz1 + zones.nz ? Zone::nz : Zone::rz2;
}

/// Rise of the linear fit over the positions, from the smallest to the largest.
double straightRise(const std::vector<SectionResult>& sections, const std::vector<double>& values) {
    const auto count = static_cast<double>(values.size());
    double x = 0;
    for (const SectionResult& section : sections) {
        x += section.position_mm / count;
    }
    const double y = std::accumulate(values.begin(), values.end(), 0.0) / count;
    double products = 0;
    double squares = 0;
    double low = 0;
    double high = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
        const double away = sections[i].position_mm - x;
        products += away * (values[i] - y);
        squares += away * away;
        low = std::min(low, away);
        high = std::max(high, away);
    }
    return squares > 0 ? products / squares * (high - low) : 0;
}

GaugePosition summary(const SimulationResult& result) {
    const Part& part = *result.project.part;
    GaugePosition at;
    at.status = result.status;
    at.time_s = result.time_s;
    std::vector<double> meanRadii;
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const SectionResult& section = result.sections[i];
        if (i == 0 || section.diameterDeviationMin_mm < at.deviationMin_mm) {
            at.deviationMin_mm = section.diameterDeviationMin_mm;
            at.sectionOfMin = i;
        }
        if (i == 0 || section.diameterDeviationMax_mm > at.deviationMax_mm) {
            at.deviationMax_mm = section.diameterDeviationMax_mm;
            at.sectionOfMax = i;
        }
        at.meanDeviations_mm.push_back(meanDiameterDeviation(section, part));
        meanRadii.push_back((at.meanDeviations_mm.back() + part.diameter_mm) / 2);
    }
    at.taper_mm = straightRise(result.sections, meanRadii);
    at.margin_mm = std::min(part.upper_deviation_um / units::umPerMm - at.deviationMax_mm,
                            at.deviationMin_mm - part.lower_deviation_um / units::umPerMm);
    return at;
}

/// Runs the cycle with the gauge at one place after the other.
class Placement {
public:
    Placement(Project project, std::stop_token stop)
        : m_project(std::move(project)), m_stop(std::move(stop)) {
        m_project.gauge->section.reset();
        m_project.gauge->position_mm.reset();
        m_project.gauge->compliance_mm_per_n.reset();
        m_points = compliantPoints(m_project, m_stop);
    }

    GaugePosition at(double position_mm) {
        return m_project.operation->travels ? inZone(position_mm) : atPlace(position_mm);
    }

private:
    GaugePosition atPlace(double position_mm) {
        m_project.gauge->position_mm = position_mm;
        GaugePosition found = summary(simulateUnchecked(m_project, nullptr, m_stop));
        found.position_mm = position_mm;
        found.compliance_mm_per_n = freeGaugePoint(m_project, m_points, m_stop).gamma_mm_n;
        return found;
    }

    GaugePosition inZone(double position_mm) {
        const Zone zone = zoneAt(m_project, position_mm);
        auto& known = m_byZone[static_cast<std::size_t>(zone)];
        if (!known) {
            known = summary(simulateTraverseGaugedIn(zone, m_project, m_stop));
            known->zone = zone;
            known->compliance_mm_per_n = m_points[static_cast<std::size_t>(zone)].gamma_mm_n;
        }
        GaugePosition found = *known;
        found.position_mm = position_mm;
        return found;
    }

    Project m_project;
    std::stop_token m_stop;
    std::vector<CompliantPoint> m_points;
    std::array<std::optional<GaugePosition>, 3> m_byZone; ///< runs differ by zone only
};

/// Whole revolutions give plateaus of equal margins: the middle of one is the safest place on it.
std::optional<std::size_t> bestOf(const std::vector<GaugePosition>& positions) {
    std::optional<std::size_t> first;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        if (positions[i].status == RunStatus::completed
            && (!first || positions[i].margin_mm > positions[*first].margin_mm)) {
            first = i;
        }
    }
    if (!first) {
        return {};
    }
    std::size_t last = *first;
    while (last + 1 < positions.size() && positions[last + 1].status == RunStatus::completed
           && positions[last + 1].margin_mm == positions[*first].margin_mm) {
        ++last;
    }
    return *first + (last - *first) / 2;
}

} // namespace

std::vector<double> gaugeCandidates(const Project& project, int count) {
    std::vector<double> positions;
    if (project.operation->travels) {
        for (const CompliantPoint& zone : compliantPoints(project)) {
            positions.push_back(zone.position_mm);
        }
        std::sort(positions.begin(), positions.end());
        return positions;
    }
    const int steps = std::max(count, 2) - 1;
    for (int i = 0; i <= steps; ++i) {
        positions.push_back(project.part->length_mm * i / steps);
    }
    return positions;
}

GaugePlacement placeGauge(const Project& project, const std::vector<double>& positions_mm,
                          const PlacementProgress& progress, const std::stop_token& stop) {
    GaugePlacement placement;
    Placement runs(project, stop);
    for (const double position : positions_mm) {
        GaugePosition found = runs.at(position);
        if (found.status == RunStatus::stopped) {
            placement.stopped = true;
            break;
        }
        auto& all = placement.positions;
        all.push_back(std::move(found));
        if (progress) {
            progress(all.size(), positions_mm.size());
        }
    }
    placement.best = bestOf(placement.positions);
    return placement;
}

} // namespace sparkout
