// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/profile.h"

#include "core/field.h"
#include "core/project/part.h"
#include "core/units.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <numbers>

namespace sparkout {

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

std::vector<double> profileRadii(const Part& part, double largestRadius_mm) {
    const int K = part.radii_per_section;
    const double dR = initialRunout(part);
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
            R = largestRadius_mm
                + (deviations[static_cast<std::size_t>(k)] - highest) / units::umPerMm;
            break;
        }
        }
    }
    return radii;
}

Blank makeBlank(const Part& part) {
    const double dR = initialRunout(part);
    Blank blank;
    blank.targetRadius_mm = targetRadius(part);
    blank.totalInfeed_mm = part.stock_mm + dR;
    const bool external = part.surface == Surface::external;
    blank.firstTouchRadius_mm =
        blank.targetRadius_mm + (external ? blank.totalInfeed_mm : -blank.totalInfeed_mm);
    const double largest = blank.firstTouchRadius_mm + (external ? 0 : dR);
    const std::vector<bool> gaps = inGaps(part);
    const std::vector<double> radii = profileRadii(part, largest);
    for (std::size_t k = 0; k < radii.size(); ++k) {
        const double depth =
            external ? blank.firstTouchRadius_mm - radii[k] : radii[k] - blank.firstTouchRadius_mm;
        blank.depth_mm.push_back(gaps[k] ? beyondReach_mm : std::max(0.0, depth));
    }
    return blank;
}

} // namespace sparkout
