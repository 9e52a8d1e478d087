// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/system_compliance.h"

#include "core/process/compliance.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/units.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace sparkout {

namespace {

Compliance shaftCompliance(const Project& project, const std::stop_token& stop) {
    const Shaft& shaft = project.part->shaft;
    const Stiffness& stiffness = *project.machine->stiffness_n_um;
    ShaftModel model;
    for (const ShaftSegment& segment : shaft.segments) {
        model.segments.push_back({segment.length_mm, segment.diameter_mm});
    }
    for (const SteadyRest& rest : shaft.steady_rests) {
        model.rests.push_back({rest.position_mm, rest.stiffness_n_um * units::umPerMm});
    }
    model.youngsModulus_n_mm2 = shaft.youngs_modulus_gpa * units::mpaPerGpa;
    model.mounting = shaft.mounting;
    model.headstock_n_mm = stiffness.headstock * units::umPerMm;
    model.tailstock_n_mm = stiffness.tailstock * units::umPerMm;
    model.wheelHead_n_mm = stiffness.wheel_head * units::umPerMm;
    return Compliance(std::move(model), stop);
}

double quillGamma(const Project& project) {
    const Shaft& shaft = project.part->shaft;
    const Stiffness& stiffness = *project.machine->stiffness_n_um;
    return quillCompliance(shaft.quill->length_mm, shaft.quill->diameter_mm,
                           shaft.youngs_modulus_gpa * units::mpaPerGpa,
                           stiffness.wheel_head * units::umPerMm,
                           stiffness.headstock * units::umPerMm);
}

bool isComputed(const Project& project) {
    return std::holds_alternative<std::monostate>(project.machine->compliance_mm_per_n);
}

std::vector<double> positions(const Project& project) {
    std::vector<double> middles;
    const double length = project.part->length_mm;
    if (!project.operation->travels) {
        for (int j = 0; j < project.sections; ++j) {
            middles.push_back(length * (j + 0.5) / project.sections);
        }
        return middles;
    }
    const ZoneLengths zones = zoneLengths(project);
    const double relief = reliefBehind(project, zones.rz2);
    middles = {zones.rz1 - plungeWidth(project, zones.rz1) / 2, zones.rz1 + zones.nz / 2,
               length - relief - plungeWidth(project, zones.rz2) / 2};
    if (project.machine->entry_side == EntrySide::tailstock) {
        for (double& middle : middles) {
            middle = length - middle;
        }
    }
    return middles;
}

/// γ at positions along the ground length, from stiffness and shaft.
std::vector<double> computedGammas(const Project& project, const std::vector<double>& at,
                                   const std::stop_token& stop = {}) {
    std::vector<double> gammas;
    if (project.part->surface == Surface::internal) {
        gammas.assign(at.size(), quillGamma(project));
        return gammas;
    }
    const Compliance system = shaftCompliance(project, stop);
    const double from = project.part->shaft.ground_from_mm;
    for (const double position : at) {
        if (stop.stop_requested()) {
            break;
        }
        gammas.push_back(project.operation->travels
                             ? system.at(from + position)
                             : system.mean(from + position, from, from + project.part->length_mm));
    }
    gammas.resize(at.size()); // 0 where stopped
    return gammas;
}

/// The lengths of the ground length that the zones or sections represent.
std::vector<double> lengths(const Project& project) {
    if (!project.operation->travels) {
        const auto sections = static_cast<std::size_t>(project.sections);
        return std::vector<double>(sections, project.part->length_mm / project.sections);
    }
    const ZoneLengths zones = zoneLengths(project);
    return {plungeWidth(project, zones.rz1), zones.nz, plungeWidth(project, zones.rz2)};
}

/// The factor on the compliance of a zone or section.
double zoneFactor(const Project& project, std::size_t place) {
    const auto& factors = project.machine->zone_compliance;
    return factors && place < factors->size() ? (*factors)[place] : 1;
}

std::vector<double> givenGammas(const GivenCompliance& given) {
    if (const auto* zones = std::get_if<ZoneCompliance>(&given)) {
        return {zones->rz1, zones->nz, zones->rz2};
    }
    return std::get<std::vector<double>>(given);
}

} // namespace

ZoneLengths zoneLengths(const Project& project) {
    const double rz1 = project.wheel->width_mm - project.machine->overrun_entry_mm;
    const double rz2 = project.wheel->width_mm - project.machine->overrun_exit_mm;
    return {rz1, project.part->length_mm - rz1 - rz2, rz2};
}

double plungeWidth(const Project& project, double zoneLength_mm) {
    return std::min(zoneLength_mm, project.wheel->width_mm);
}

double reliefBehind(const Project& project, double zoneLength_mm) {
    return zoneLength_mm - plungeWidth(project, zoneLength_mm);
}

std::vector<CompliantPoint> compliantPoints(const Project& project, const std::stop_token& stop) {
    const std::vector<double> at = positions(project);
    const std::vector<double> gammas = isComputed(project)
                                           ? computedGammas(project, at, stop)
                                           : givenGammas(project.machine->compliance_mm_per_n);
    assert(gammas.size() == at.size());
    const std::vector<double> length = lengths(project);
    std::vector<CompliantPoint> points;
    for (std::size_t i = 0; i < at.size(); ++i) {
        points.push_back({at[i], gammas[i] * zoneFactor(project, i), length[i]});
    }
    return points;
}

double fromEntry(const Project& project, double position_mm) {
    return project.machine->entry_side == EntrySide::tailstock
               ? project.part->length_mm - position_mm
               : position_mm;
}

std::vector<CompliantPoint> zoneSectionPoints(const Project& project, const std::stop_token& stop) {
    std::vector<CompliantPoint> points;
    if (zoneSectionCount(project) == 0) {
        return points;
    }
    const ZoneLengths zones = zoneLengths(project);
    const std::vector<double> reached = lengths(project);
    const double from[] = {zones.rz1 - reached[0], zones.rz1, project.part->length_mm - zones.rz2};
    std::vector<double> at;
    for (std::size_t zone = 0; zone < reached.size(); ++zone) {
        const double slice = reached[zone] / project.zone_sections;
        for (int i = 0; i < project.zone_sections; ++i) {
            at.push_back(fromEntry(project, from[zone] + slice * (i + 0.5)));
            points.push_back({at.back(), 0, slice});
        }
    }
    std::vector<double> gammas;
    if (isComputed(project)) {
        gammas = computedGammas(project, at, stop);
    } else {
        for (const double gamma : givenGammas(project.machine->compliance_mm_per_n)) {
            gammas.insert(gammas.end(), static_cast<std::size_t>(project.zone_sections), gamma);
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::size_t zone = i / static_cast<std::size_t>(project.zone_sections);
        points[i].gamma_mm_n = gammas[i] * zoneFactor(project, zone);
    }
    return points;
}

std::vector<CompliantPlace> complianceAlong(const Project& project, int places,
                                            const std::stop_token& stop) {
    std::vector<CompliantPlace> along;
    if (!isComputed(project)) {
        return along;
    }
    const Part& part = *project.part;
    const double gaps = std::max(places, 2) - 1;
    if (part.surface == Surface::internal) {
        ComplianceParts parts;
        parts.wheelHead = 1 / (project.machine->stiffness_n_um->wheel_head * units::umPerMm);
        parts.headstock = 1 / (project.machine->stiffness_n_um->headstock * units::umPerMm);
        parts.bending = quillGamma(project) - parts.wheelHead - parts.headstock;
        for (int i = 0; i <= gaps; ++i) {
            along.push_back({part.length_mm * i / gaps, parts});
        }
        return along;
    }
    const Compliance system = shaftCompliance(project, stop);
    for (int i = 0; i <= gaps && !stop.stop_requested(); ++i) {
        const double x = i < gaps ? system.length() * i / gaps : system.length();
        along.push_back({x - part.shaft.ground_from_mm, system.partsAt(x)});
    }
    return along;
}

int gaugeSection(const Project& project) {
    if (project.operation->travels) {
        return 1; // the middle of НЗ
    }
    if (project.gauge->position_mm) {
        const std::vector<double> middles = positions(project);
        const auto nearest = std::ranges::min_element(middles, {}, [&](double middle) {
            return std::abs(middle - *project.gauge->position_mm);
        });
        return static_cast<int>(nearest - middles.begin());
    }
    return project.gauge->section.value_or(project.sections / 2);
}

std::size_t placeOfPoint(const Project& project, std::size_t point) {
    const auto places = static_cast<std::size_t>(placeCount(project));
    if (point < places) {
        return point;
    }
    return zoneSectionCount(project) > 0
               ? (point - places) / static_cast<std::size_t>(project.zone_sections)
               : static_cast<std::size_t>(gaugeSection(project));
}

CompliantPoint freeGaugePoint(const Project& project, const std::vector<CompliantPoint>& sections,
                              const std::stop_token& stop) {
    const double x = *project.gauge->position_mm;
    if (project.gauge->compliance_mm_per_n) {
        return {x, *project.gauge->compliance_mm_per_n};
    }
    if (isComputed(project)) {
        const auto nearest = static_cast<std::size_t>(gaugeSection(project));
        return {x, computedGammas(project, {x}, stop).front() * zoneFactor(project, nearest)};
    }
    if (x <= sections.front().position_mm) {
        return {x, sections.front().gamma_mm_n};
    }
    for (std::size_t i = 1; i < sections.size(); ++i) {
        const CompliantPoint& a = sections[i - 1];
        const CompliantPoint& b = sections[i];
        if (x <= b.position_mm) {
            const double share = (x - a.position_mm) / (b.position_mm - a.position_mm);
            return {x, a.gamma_mm_n + share * (b.gamma_mm_n - a.gamma_mm_n)};
        }
    }
    return {x, sections.back().gamma_mm_n};
}

std::vector<double> influenceRows(const Project& project, const std::vector<double>& at,
                                  const std::vector<double>& from, const std::stop_token& stop) {
    assert(isComputed(project));
    if (project.part->surface == Surface::internal) {
        return std::vector<double>(at.size() * from.size(), quillGamma(project));
    }
    const double ground = project.part->shaft.ground_from_mm;
    const auto alongTheShaft = [ground](std::vector<double> places) {
        for (double& place : places) {
            place = ground + place;
        }
        return places;
    };
    return shaftCompliance(project, stop).rows(alongTheShaft(at), alongTheShaft(from), stop);
}

} // namespace sparkout
