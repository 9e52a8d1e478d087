// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/characteristics.h"

#include "core/quality/constraints.h"
#include "core/quality/finished_surface.h"
#include "core/quality/self_sharpening.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <string_view>

namespace sparkout {

namespace {

constexpr const char* diameterName = "diameter";
constexpr const char* timeName = "time";
constexpr double wholeLimit = 100; ///< [%]

/// Whether the limit differs from part to part.
bool isRelative(const char* name) {
    return name == constraintName(ConstraintKind::burn)
           || name == constraintName(ConstraintKind::selfSharpening);
}

/// The greatest power of two not above a thousandth of the width.
double resolutionFor(double width) {
    return std::exp2(std::floor(std::log2(std::max(width, 1e-3) / 1000)));
}

class Lister {
public:
    explicit Lister(const Project& project) : m_project(project) {}

    std::vector<Characteristic> list() {
        for (int i = 0; i < placeCount(m_project); ++i) {
            addSection(m_project.operation->hasZones ? static_cast<Zone>(i) : Zone::section, i);
        }
        const Tolerance& tolerance = m_project.part.tolerance;
        addUpper(ConstraintKind::cylindricity, tolerance.cylindricity_um);
        addUpper(ConstraintKind::totalRunout, tolerance.total_runout_um);
        if (m_project.material.burn_rise_k) {
            addUpper(ConstraintKind::burn, wholeLimit);
        }
        if (selfSharpening(m_project)) {
            addUpper(ConstraintKind::selfSharpening, wholeLimit);
        }
        addUpper(ConstraintKind::wheelPower, m_project.machine.wheel_drive_kw);
        addUpper(ConstraintKind::workPower, m_project.machine.work_drive_kw);
        m_list.push_back({timeName, "s", Zone::section, -1, {}, {}, 0x1p-4});
        return std::move(m_list);
    }

private:
    void addSection(Zone zone, int section) {
        const Part& part = m_project.part;
        const double low = part.lower_deviation_um, high = part.upper_deviation_um;
        const double fine = resolutionFor(high - low);
        const auto name = [](ConstraintKind kind) { return constraintName(kind); };
        m_zone = zone;
        m_section = section;
        m_list.push_back({diameterName, "µm", zone, section, low, high, fine});
        m_list.push_back({name(ConstraintKind::diameterMin), "µm", zone, section, low, {}, fine});
        m_list.push_back({name(ConstraintKind::diameterMax), "µm", zone, section, {}, high, fine});
        m_list.push_back({name(ConstraintKind::radialRunout),
                          "µm",
                          zone,
                          section,
                          {},
                          part.tolerance.radial_runout_um,
                          resolutionFor(part.tolerance.radial_runout_um.value_or(high - low))});
        addUpper(ConstraintKind::roundness, part.tolerance.roundness_um);
        addUpper(ConstraintKind::roughness, part.tolerance.roughness_ra_um);
        m_zone = Zone::section;
        m_section = -1;
    }

    void addUpper(ConstraintKind kind, const std::optional<double>& limit) {
        if (limit) {
            m_list.push_back({constraintName(kind),
                              isRelative(constraintName(kind)) ? "%" : constraintUnit(kind),
                              m_zone,
                              m_section,
                              {},
                              limit,
                              resolutionFor(*limit)});
        }
    }

    const Project& m_project;
    std::vector<Characteristic> m_list;
    Zone m_zone = Zone::section;
    int m_section = -1;
};

double valueOf(const Characteristic& characteristic, const SimulationResult& result,
               const std::vector<ConstraintResult>& constraints) {
    const char* const name = characteristic.name;
    if (name == timeName) {
        return result.time_s;
    }
    if (name == diameterName) {
        return meanDeviation_um(result.sections[static_cast<std::size_t>(characteristic.section)],
                                result.project.part.diameter_mm);
    }
    if (name == constraintName(ConstraintKind::radialRunout)) {
        return result.sections[static_cast<std::size_t>(characteristic.section)].radialRunout_mm
               * units::umPerMm;
    }
    double worst = std::numeric_limits<double>::quiet_NaN(); // of a drive's stages the greatest
    for (const ConstraintResult& constraint : constraints) {
        if (constraintName(constraint.kind) == name
            && (characteristic.section < 0 || constraint.section == characteristic.section)) {
            const double value =
                isRelative(name) ? wholeLimit * (1 - constraint.relativeMargin) : constraint.value;
            worst = std::isnan(worst) ? value : std::max(worst, value);
        }
    }
    return worst;
}

} // namespace

bool hasCapability(const Characteristic& characteristic) {
    return (characteristic.low || characteristic.high)
           && std::string_view(characteristic.unit) == "µm"
           && std::string_view(characteristic.name) != constraintName(ConstraintKind::roughness);
}

bool isOfSurface(const Characteristic& characteristic) {
    for (int i = 0; i < constraintKinds; ++i) {
        const auto kind = static_cast<ConstraintKind>(i);
        if (std::string_view(characteristic.name) == constraintName(kind)) {
            return FinishedSurface::isMeantBy(kind);
        }
    }
    return std::string_view(characteristic.name) == diameterName;
}

double meanDeviation_um(const SectionResult& section, double nominal_mm) {
    const double sum =
        std::accumulate(section.radii_mm.begin(), section.radii_mm.end(), 0.0,
                        [nominal_mm](double s, double R) { return s + (R - nominal_mm / 2); });
    return 2 * sum / static_cast<double>(section.radii_mm.size()) * units::umPerMm;
}

std::vector<Characteristic> characteristicsOf(const Project& project) {
    return Lister(project).list();
}

void measure(const SimulationResult& result, const std::vector<Characteristic>& characteristics,
             PartOutcome& outcome) {
    outcome = {};
    outcome.completed = result.status == RunStatus::completed;
    if (!outcome.completed) {
        return;
    }
    const std::vector<ConstraintResult> constraints = evaluateConstraints(result);
    outcome.good = true;
    outcome.margin = std::numeric_limits<double>::max();
    for (const ConstraintResult& constraint : constraints) {
        outcome.good = outcome.good && constraint.holds;
        outcome.asked[static_cast<std::size_t>(constraint.kind)] = true;
        if (!constraint.isWhole) {
            continue; // not known: the overlap fails instead
        }
        if (!constraint.holds) {
            outcome.fails[static_cast<std::size_t>(constraint.kind)] = true;
        }
        const bool strips = constraint.kind == ConstraintKind::overlap && !constraint.holds;
        if (scopeOf(constraint.kind) != ConstraintScope::setting || strips) {
            outcome.margin = std::min(outcome.margin, constraint.relativeMargin);
        }
    }
    const FinishedSurface surface(result.project);
    for (const Characteristic& characteristic : characteristics) {
        outcome.values.push_back(surface.isWhole() || !isOfSurface(characteristic)
                                     ? valueOf(characteristic, result, constraints)
                                     : std::numeric_limits<double>::quiet_NaN());
    }
}

} // namespace sparkout
