// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/accuracy.h"

#include "core/text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

/// The mean without NaN values, which mark a gap.
double mean(std::span<const double> values) {
    const auto first = std::ranges::find_if(values, [](double v) { return !std::isnan(v); });
    double sum = 0;
    std::size_t count = 0;
    for (const double value : values) {
        if (!std::isnan(value)) {
            sum += value - *first;
            ++count;
        }
    }
    return *first + sum / static_cast<double>(count);
}

/// Σ weight·value / Σ weight².
double projection(std::span<const double> weights, std::span<const double> values) {
    double dot = 0, squares = 0;
    for (std::size_t j = 0; j < weights.size(); ++j) {
        dot += weights[j] * values[j];
        squares += weights[j] * weights[j];
    }
    return squares > 0 ? dot / squares : 0;
}

LongitudinalForm classify(double taper, double crown) {
    if (std::max(std::abs(taper), std::abs(crown)) < straight_mm) {
        return LongitudinalForm::straight;
    }
    if (std::abs(taper) >= std::abs(crown)) {
        return LongitudinalForm::taper;
    }
    return crown > 0 ? LongitudinalForm::barrel : LongitudinalForm::saddle;
}

} // namespace

double runout(std::span<const SectionShape> sections, double geometricRunout_mm,
              FormulaSheet* sheet) {
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const SectionShape& section : sections) {
        for (const double radius : section.radii_mm) { // min and max ignore NaN, as in a gap
            low = std::min(low, radius);
            high = std::max(high, radius);
        }
    }
    const double found = high - low + geometricRunout_mm;
    state(sheet, "{Δ} = {R_max} − {R_min} + {Δ_m}", {"Δ", found, "mm"},
          {{"R_max", high, "mm"}, {"R_min", low, "mm"}, {"Δ_m", geometricRunout_mm, "mm"}});
    return found;
}

// Least squares by orthogonal functions: P₁ = ξ − mean ξ and P₂ = ξ² without its components along 1
// and P₁, with ξ from −1 at the first section to 1 at the last. Between the middle and these ends
// ξ² rises by 1, so its coefficient is ends less middle.
LongitudinalProfile longitudinalProfile(std::span<const double> positions_mm,
                                        std::span<const double> meanRadii_mm) {
    const auto [first, last] = std::minmax_element(positions_mm.begin(), positions_mm.end());
    const double middle = (*first + *last) / 2, reach = (*last - *first) / 2;
    if (positions_mm.size() < 2 || reach <= 0) {
        return {};
    }
    const std::size_t J = positions_mm.size();
    std::vector<double> line(J), curve(J), rest(J);
    const double radius = mean(meanRadii_mm);
    for (std::size_t j = 0; j < J; ++j) {
        line[j] = (positions_mm[j] - middle) / reach;
        curve[j] = line[j] * line[j];
        rest[j] = meanRadii_mm[j] - radius;
    }
    const double lineMean = mean(line), curveMean = mean(curve);
    for (std::size_t j = 0; j < J; ++j) {
        line[j] -= lineMean;
        curve[j] -= curveMean;
    }
    double slope = projection(line, rest);
    double bend = 0;
    if (J > 2) {
        const double curveInLine = projection(line, curve);
        for (std::size_t j = 0; j < J; ++j) {
            curve[j] -= curveInLine * line[j];
        }
        bend = projection(curve, rest);
        slope -= bend * curveInLine;
    }
    LongitudinalProfile found{2 * slope, -bend, LongitudinalForm::straight};
    found.form = classify(found.taper_mm, found.crown_mm);
    return found;
}

PartAccuracy partAccuracy(std::span<const SectionShape> sections, double geometricRunout_mm) {
    PartAccuracy part;
    if (sections.empty()) {
        return part;
    }
    const Directions directions(sections[0].radii_mm.size());
    std::vector<double> positions, means;
    for (const SectionShape& section : sections) {
        SectionAccuracy accuracy;
        accuracy.meanRadius_mm = mean(section.radii_mm);
        accuracy.radialRunout_mm = runout({&section, 1}, geometricRunout_mm);
        accuracy.leastSquares = leastSquaresCircle(section.radii_mm, directions);
        accuracy.minimumZone =
            minimumZoneCircles(section.radii_mm, directions, accuracy.leastSquares);
        part.sections.push_back(accuracy);
        positions.push_back(section.position_mm);
        means.push_back(accuracy.meanRadius_mm);
    }
    part.leastSquares = leastSquaresCylinder(sections, directions);
    part.minimumZone = minimumZoneCylinder(sections, directions, part.leastSquares);
    part.totalRunout_mm = runout(sections, geometricRunout_mm);
    part.profile = longitudinalProfile(positions, means);
    return part;
}

FormulaSheet radialRunoutSheet(const SectionShape& section, double geometricRunout_mm) {
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Radial runout"), "MODEL-7", {}};
    runout({&section, 1}, geometricRunout_mm, &sheet);
    return sheet;
}

FormulaSheet totalRunoutSheet(std::span<const SectionShape> sections, double geometricRunout_mm) {
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Total radial runout"), "MODEL-7", {}};
    runout(sections, geometricRunout_mm, &sheet);
    return sheet;
}

FormulaSheet roundnessSheet(const RoundnessZone& zone) {
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Roundness deviation"), "ISO12181", {}};
    state(&sheet, "{Δ_r} = {R_out} − {R_in}", {"Δ_r", zone.deviation(), "mm"},
          {{"R_out", zone.outer_mm, "mm"}, {"R_in", zone.inner_mm, "mm"}});
    return sheet;
}

FormulaSheet cylindricitySheet(const CylinderZone& zone) {
    FormulaSheet sheet{SPARKOUT_NOOP("Formula", "Cylindricity deviation"), "ISO12180", {}};
    state(&sheet, "{Δ_c} = {R_out} − {R_in}", {"Δ_c", zone.deviation(), "mm"},
          {{"R_out", zone.outer_mm, "mm"}, {"R_in", zone.inner_mm, "mm"}});
    return sheet;
}

} // namespace sparkout
