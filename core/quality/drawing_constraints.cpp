// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/drawing_constraints.h"

#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/quality/roughness.h"
#include "core/quality/waviness_outputs.h"
#include "core/units.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <utility>

namespace sparkout {

namespace {

using units::umPerMm;

constexpr double slack_um = diameterSlack_mm * umPerMm;

const SectionResult& judgedSection(const Judged& of) {
    return of.result.sections[static_cast<std::size_t>(of.section)];
}

const Tolerance& toleranceOf(const Judged& of) {
    return of.result.project.part->tolerance;
}

double geometricRunout(const SimulationResult& result) {
    return addedRunout_um(*result.project.machine) / umPerMm;
}

/// Adds a requirement in µm on a section or the part.
void add(ConstraintKind kind, Side side, const Judged& of, double limit, double value, double width,
         ConstraintResults& found) {
    ConstraintResult result = held(kind, side, limit, value, width);
    result.section = of.section;
    result.zone = of.result.sections[static_cast<std::size_t>(std::max(of.section, 0))].zone;
    result.holds = result.margin >= -slack_um;
    found.push_back(result);
}

void addTolerance(ConstraintKind kind, const Judged& of, double limit, double value_mm,
                  ConstraintResults& found) {
    add(kind, Side::atMost, of, limit, value_mm * umPerMm, limit, found);
}

} // namespace

void evaluateLeastDiameter(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    const Part& part = *of.result.project.part;
    const double low = part.lower_deviation_um;
    add(kind, Side::atLeast, of, low, judgedSection(of).diameterDeviationMin_mm * umPerMm,
        part.upper_deviation_um - low, found);
}

void evaluateLargestDiameter(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    const Part& part = *of.result.project.part;
    const double high = part.upper_deviation_um;
    add(kind, Side::atMost, of, high, judgedSection(of).diameterDeviationMax_mm * umPerMm,
        high - part.lower_deviation_um, found);
}

void evaluateRadialRunout(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    if (const auto& limit = toleranceOf(of).radial_runout_um) {
        addTolerance(kind, of, *limit, judgedSection(of).radialRunout_mm, found);
    }
}

std::optional<FormulaSheet> sheetOfRadialRunout(const Judged& of) {
    const std::vector<SectionShape> shapes =
        shapesOfPlace(of.result, static_cast<std::size_t>(of.section));
    const auto worst = std::ranges::max_element(shapes, {}, [](const SectionShape& shape) {
        return runout({&shape, 1}, 0);
    });
    return radialRunoutSheet(*worst, geometricRunout(of.result));
}

void evaluateRoundness(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    if (const auto& limit = toleranceOf(of).roundness_um) {
        const auto index = static_cast<std::size_t>(of.section);
        addTolerance(kind, of, *limit, of.accuracy.sections[index].minimumZone.deviation(), found);
    }
}

std::optional<FormulaSheet> sheetOfRoundness(const Judged& of) {
    return roundnessSheet(of.accuracy.sections[static_cast<std::size_t>(of.section)].minimumZone);
}

void evaluateCylindricity(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    const auto& limit = toleranceOf(of).cylindricity_um;
    if (limit && !of.result.sections.empty()) {
        addTolerance(kind, of, *limit, of.accuracy.minimumZone.deviation(), found);
    }
}

std::optional<FormulaSheet> sheetOfCylindricity(const Judged& of) {
    return cylindricitySheet(of.accuracy.minimumZone);
}

void evaluateTotalRunout(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    const auto& limit = toleranceOf(of).total_runout_um;
    if (limit && !of.result.sections.empty()) {
        addTolerance(kind, of, *limit, of.accuracy.totalRunout_mm, found);
    }
}

std::optional<FormulaSheet> sheetOfTotalRunout(const Judged& of) {
    return totalRunoutSheet(shapesOf(of.result), geometricRunout(of.result));
}

void evaluateWaviness(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    if (const auto& limit = toleranceOf(of).waviness_um) {
        const auto place = static_cast<std::size_t>(of.section);
        const bool isKnown = areWavesKnown(of.result.project);
        addTolerance(kind, of, *limit, isKnown ? profileWaves(of.result, place).height_mm : 0,
                     found);
    }
}

void evaluateRoughness(ConstraintKind kind, const Judged& of, ConstraintResults& found) {
    const auto& limit = toleranceOf(of).roughness_ra_um;
    const std::optional<LastCut>& last = judgedSection(of).lastCut;
    if (limit && last) {
        const RoughnessFactor factor = roughnessFactor(of.result.project);
        const double Ra = RoughnessModel(of.result.project, factor.least).roughness(*last);
        addTolerance(kind, of, *limit, Ra, found);
        found.back().at = last->at;
        if (const std::optional<double> most = factor.greatestOf(Ra)) {
            found.back().mostValue = *most * umPerMm;
        }
    }
}

std::optional<FormulaSheet> sheetOfRoughness(const Judged& of) {
    return roughnessSheet(of.result.project, *judgedSection(of).lastCut);
}

std::optional<double> roughnessDepth(const Project& project, double b, double /*stock*/) {
    const auto& Ra = project.part->tolerance.roughness_ra_um;
    return Ra ? std::optional(
               RoughnessModel(project).limitDepth(*Ra / umPerMm, strokeOverlap(project, b)))
              : std::nullopt;
}

std::vector<SectionShape> shapesOf(const SimulationResult& result) {
    std::vector<SectionShape> shapes;
    for (const SectionResult& section :
         result.zoneSections.empty() ? result.sections : result.zoneSections) {
        shapes.push_back({section.position_mm, section.radii_mm});
    }
    return shapes;
}

std::vector<SectionShape> shapesOfPlace(const SimulationResult& result, std::size_t section) {
    const std::vector<SectionShape> all = shapesOf(result);
    const std::size_t inPlace = all.size() / result.sections.size();
    const auto first = all.begin() + static_cast<std::ptrdiff_t>(section * inPlace);
    return {first, first + static_cast<std::ptrdiff_t>(inPlace)};
}

double roundnessOf(const SimulationResult& result, std::size_t section) {
    const std::vector<SectionShape> shapes = shapesOfPlace(result, section);
    const Directions directions(shapes.front().radii_mm.size());
    double largest = 0;
    for (const SectionShape& shape : shapes) {
        largest = std::max(largest, minimumZoneCircles(shape.radii_mm, directions).deviation());
    }
    return largest;
}

namespace {

/// Replaces the sections by one per zone: the least round section of each.
void foldZones(PartAccuracy& accuracy, const SimulationResult& result) {
    const std::size_t zones = result.sections.size();
    const std::size_t inZone = accuracy.sections.size() / std::max<std::size_t>(zones, 1);
    if (inZone < 2) {
        return;
    }
    const auto deviation = [](const SectionAccuracy& section) {
        return section.minimumZone.deviation();
    };
    std::vector<SectionAccuracy> folded;
    for (std::size_t zone = 0; zone < zones; ++zone) {
        const auto first = accuracy.sections.begin() + static_cast<std::ptrdiff_t>(zone * inZone);
        const auto end = first + static_cast<std::ptrdiff_t>(inZone);
        folded.push_back(
            *std::max_element(first, end, [&](const SectionAccuracy& a, const SectionAccuracy& b) {
                return deviation(a) < deviation(b);
            }));
        folded.back().radialRunout_mm = result.sections[zone].radialRunout_mm;
    }
    accuracy.sections = std::move(folded);
}

RoundnessZone circlesAboutAxis(std::span<const double> radii_mm) {
    RoundnessZone zone{.inner_mm = std::numeric_limits<double>::infinity()};
    for (const double radius_mm : radii_mm) { // NaN in a gap
        zone.inner_mm = std::min(zone.inner_mm, radius_mm);
        zone.outer_mm = std::max(zone.outer_mm, radius_mm);
    }
    return zone;
}

/// The upper bound of the minimum zone of radii between these circles, as minimumZoneCircles()
/// finds it.
double mostRoundness_mm(const RoundnessZone& between) {
    const double width_mm = between.deviation();
    return width_mm + width_mm * width_mm / between.inner_mm;
}

} // namespace

PartAccuracy accuracyOf(const SimulationResult& result) {
    const double geometric = geometricRunout(result);
    PartAccuracy accuracy = partAccuracy(shapesOf(result), geometric);
    for (std::size_t zone = 0; !result.zoneSections.empty() && zone < result.sections.size();
         ++zone) {
        const PartAccuracy alone = partAccuracy(shapesOfPlace(result, zone), geometric);
        accuracy.zones.push_back(
            {alone.minimumZone.deviation(), alone.totalRunout_mm, alone.profile});
    }
    foldZones(accuracy, result);
    return accuracy;
}

PartAccuracy requiredAccuracy(const SimulationResult& result, double clear_um) {
    PartAccuracy accuracy;
    const Tolerance& tolerance = result.project.part->tolerance;
    const std::vector<SectionShape> shapes = shapesOf(result);
    if (shapes.empty()) {
        return accuracy;
    }
    std::optional<Directions> made;
    const auto directions = [&]() -> const Directions& {
        return made ? *made : made.emplace(shapes[0].radii_mm.size());
    };
    for (std::size_t i = 0; tolerance.roundness_um && i < shapes.size(); ++i) {
        SectionAccuracy section;
        section.minimumZone = circlesAboutAxis(shapes[i].radii_mm);
        const double most_mm = (*tolerance.roundness_um - clear_um) / umPerMm;
        if (!(mostRoundness_mm(section.minimumZone) < most_mm)) {
            section.minimumZone = minimumZoneCircles(shapes[i].radii_mm, directions());
        }
        accuracy.sections.push_back(section);
    }
    foldZones(accuracy, result);
    if (tolerance.cylindricity_um) {
        accuracy.minimumZone = minimumZoneCylinder(shapes, directions());
    }
    if (tolerance.total_runout_um) {
        accuracy.totalRunout_mm = runout(shapes, geometricRunout(result));
    }
    return accuracy;
}

} // namespace sparkout
