// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/characteristics.h"

#include "core/project/part.h"
#include "core/quality/constraints.h"
#include "core/quality/ranges.h"
#include "core/quality/roughness.h"
#include "core/units.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

constexpr double wholeLimit = 100; ///< [%]

/// Whether the limit differs from part to part, so that values are in per cent of it.
bool isRelative(const Requirement& row) {
    return row.source == LimitSource::model;
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
            addSection(m_project.operation->travels ? static_cast<Zone>(i) : Zone::section, i);
        }
        m_zone = Zone::section;
        m_section = -1;
        for (const Requirement& row : requirementRows) {
            if (row.scope == ConstraintScope::part || row.scope == ConstraintScope::pass) {
                add(row);
            }
        }
        m_list.push_back({"time", "s", Zone::section, -1, {}, {}, 0x1p-4});
        return std::move(m_list);
    }

private:
    void addSection(Zone zone, int section) {
        const Part& part = *m_project.part;
        const double low = part.lower_deviation_um, high = part.upper_deviation_um;
        m_zone = zone;
        m_section = section;
        m_list.push_back({"diameter", "µm", zone, section, low, high, resolutionFor(high - low)});
        for (const Requirement& row : requirementRows) {
            if (row.scope == ConstraintScope::section) {
                add(row);
            }
        }
    }

    /// Adds what is required, and the radial runout, which costs no computation.
    void add(const Requirement& row) {
        const bool isOn = missingInput(row, m_project).empty();
        if (!isOn && row.kind != ConstraintKind::radialRunout) {
            return;
        }
        std::optional<double> limit;
        if (isOn) {
            limit = isRelative(row) ? wholeLimit : statedLimit(row, m_project);
        }
        const Part& part = *m_project.part;
        const double width =
            row.isDeviation || !limit ? part.upper_deviation_um - part.lower_deviation_um : *limit;
        const std::optional<double> none;
        m_list.push_back(
            {row.key, isRelative(row) ? "%" : row.unit, m_zone, m_section,
             row.isLeast ? limit : none, row.isLeast ? none : limit, resolutionFor(width), &row,
             row.kind == ConstraintKind::roughness && !isRoughnessCalibrated(m_project),
             knowsMachine(row.kind, m_project)});
    }

    const Project& m_project;
    std::vector<Characteristic> m_list;
    Zone m_zone = Zone::section;
    int m_section = -1;
};

double valueOf(const Characteristic& characteristic, const SimulationResult& result,
               const std::vector<ConstraintResult>& constraints) {
    const Requirement* const row = characteristic.requirement;
    if (!row && characteristic.section < 0) {
        return result.time_s;
    }
    const auto section = static_cast<std::size_t>(characteristic.section);
    if (!row) {
        return meanDeviation_um(result.sections[section], result.project.part->diameter_mm);
    }
    if (row->kind == ConstraintKind::radialRunout) {
        return result.sections[section].radialRunout_mm * units::umPerMm;
    }
    double worst = std::numeric_limits<double>::quiet_NaN(); // the greatest of a drive's stages
    for (const ConstraintResult& constraint : constraints) {
        if (constraint.kind == row->kind
            && (characteristic.section < 0 || constraint.section == characteristic.section)) {
            if (!isComputed(constraint)) {
                continue;
            }
            const double value =
                isRelative(*row) ? wholeLimit * (1 - constraint.relativeMargin) : constraint.value;
            worst = std::isnan(worst) ? value : std::max(worst, value);
        }
    }
    return worst;
}

} // namespace

bool hasCapability(const Characteristic& characteristic) {
    const Requirement* const row = characteristic.requirement;
    return (characteristic.low || characteristic.high) && (!row || row->isCapable);
}

bool isOfSurface(const Characteristic& characteristic) {
    const Requirement* const row = characteristic.requirement;
    return row ? row->isOfSurface() : characteristic.section >= 0;
}

double meanDeviation_um(const SectionResult& section, double nominal_mm) {
    double sum = 0;
    std::size_t ground = 0;
    for (const double radius : section.radii_mm) {
        const bool gap = std::isnan(radius);
        sum += gap ? 0 : radius - nominal_mm / 2;
        ground += gap ? 0 : 1;
    }
    return 2 * sum / static_cast<double>(ground) * units::umPerMm;
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
            continue; // not known: the overlap requirement fails
        }
        if (!constraint.holds) {
            outcome.fails[static_cast<std::size_t>(constraint.kind)] = true;
        }
        const bool strips = constraint.kind == ConstraintKind::overlap && !constraint.holds;
        if (requirementOf(constraint.kind).scope != ConstraintScope::setting || strips) {
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
