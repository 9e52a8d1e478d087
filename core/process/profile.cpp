// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/profile.h"

#include "core/field.h"
#include "core/process/system_compliance.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/units.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace sparkout {

std::vector<Stretch> groundStretches(const Project& project) {
    std::vector<Stretch> stretches;
    const double length = project.part->length_mm;
    if (!project.operation->travels) {
        for (int j = 0; j < project.sections; ++j) {
            stretches.push_back(
                {length * j / project.sections, length * (j + 1) / project.sections});
        }
        return stretches;
    }
    const ZoneLengths zones = zoneLengths(project);
    const double bounds[] = {reliefBehind(project, zones.rz1), zones.rz1, length - zones.rz2,
                             length - reliefBehind(project, zones.rz2)};
    const bool mirrored = project.machine->entry_side == EntrySide::tailstock;
    for (int i = 0; i < 3; ++i) {
        stretches.push_back(mirrored ? Stretch{length - bounds[i + 1], length - bounds[i]}
                                     : Stretch{bounds[i], bounds[i + 1]});
    }
    return stretches;
}

double targetRadius(const Part& part) {
    if (part.target_diameter_mm) {
        return *part.target_diameter_mm / 2;
    }
    return part.diameter_mm / 2
           + (part.upper_deviation_um + part.lower_deviation_um) / 4 / units::umPerMm;
}

double initialRunout(const Part& part) {
    if (part.profile != ProfileForm::measured) {
        return part.initial_runout_mm;
    }
    assert(part.radii_um && !part.radii_um->empty());
    const Range range = measuredRange(part);
    return (range.high - range.low) / units::umPerMm;
}

namespace {

std::vector<double> radiiOf(const Part& part, double largestRadius_mm, double dR) {
    const int K = part.radii_per_section;
    const double p = largestRadius_mm;
    const double q = largestRadius_mm - dR;
    const double e = dR / 2;
    const double r = largestRadius_mm - e;
    std::vector<double> radii(static_cast<std::size_t>(K));
    for (int k = 0; k < K; ++k) {
        const double phi = 2 * std::numbers::pi * k / K;
        double& R = radii[static_cast<std::size_t>(k)];
        switch (part.profile) {
        case ProfileForm::ellipse:
            R = p * q / std::hypot(q * std::cos(phi), p * std::sin(phi));
            break;
        case ProfileForm::eccentric: {
            const double across = e * std::sin(phi);
            R = e * std::cos(phi) + std::sqrt(r * r - across * across);
            break;
        }
        case ProfileForm::lobes: R = largestRadius_mm - e * (1 - std::cos(part.lobes * phi)); break;
        case ProfileForm::measured: {
            const auto& deviations = *part.radii_um;
            const double highest = measuredRange(part).high;
            const double whole = initialRunout(part);
            const double stretch = whole == dR || whole == 0 ? 1 : dR / whole;
            R = largestRadius_mm
                + (deviations[static_cast<std::size_t>(k)] - highest) / units::umPerMm * stretch;
            break;
        }
        }
    }
    return radii;
}

/// Depths below the first touch of a blank or zone that is itself touched at this depth.
std::vector<double> depthsOf(const Part& part, const Blank& blank, double touch_mm, double dR) {
    const bool external = part.surface == Surface::external;
    const double largest =
        external ? blank.firstTouchRadius_mm - touch_mm : blank.firstTouchRadius_mm + touch_mm + dR;
    const std::vector<bool> gaps = inGaps(part);
    const std::vector<double> radii = radiiOf(part, largest, dR);
    std::vector<double> depths;
    for (std::size_t k = 0; k < radii.size(); ++k) {
        const double depth =
            external ? blank.firstTouchRadius_mm - radii[k] : radii[k] - blank.firstTouchRadius_mm;
        depths.push_back(gaps[k] ? beyondReach_mm : std::max(0.0, depth));
    }
    return depths;
}

} // namespace

std::vector<double> profileRadii(const Part& part, double largestRadius_mm) {
    return radiiOf(part, largestRadius_mm, initialRunout(part));
}

double largestRunout(const Part& part) {
    double largest = initialRunout(part);
    if (part.zone_runout_mm) {
        const double of = largest;
        largest = 0;
        for (const double own : *part.zone_runout_mm) {
            largest = std::max(largest, of + own);
        }
    }
    return largest;
}

Blank makeBlank(const Part& part) {
    const double dR = initialRunout(part);
    const std::vector<ZoneBlank> zones = zoneBlanks(part);
    Blank blank;
    blank.targetRadius_mm = targetRadius(part);
    blank.totalInfeed_mm = part.stock_mm + dR;
    if (!zones.empty()) {
        blank.totalInfeed_mm += furthestZone_mm(part);
    }
    const bool external = part.surface == Surface::external;
    blank.firstTouchRadius_mm =
        blank.targetRadius_mm + (external ? blank.totalInfeed_mm : -blank.totalInfeed_mm);
    blank.depth_mm = depthsOf(part, blank, 0, dR);
    for (const ZoneBlank& zone : zones) {
        const double touch = furthestZone_mm(part) - zone.stock_mm - zone.runout_mm;
        blank.placeDepth_mm.push_back(depthsOf(part, blank, touch, dR + zone.runout_mm));
    }
    return blank;
}

} // namespace sparkout
