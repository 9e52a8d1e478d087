// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/profile_series.h"

#include "core/process/profile.h"
#include "core/process/system_compliance.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/quality/ranges.h"
#include "core/surface/accuracy.h"
#include "core/surface/harmonics.h"
#include "core/surface/roundness.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

/// The value of a radius, or half a diameter, in the unit of the quantity.
double valueOf(double radius_mm, const ProfileSeries& series, LengthQuantity quantity) {
    switch (quantity) {
    case LengthQuantity::radius_um: return (radius_mm - series.target_mm) * units::umPerMm;
    case LengthQuantity::diameter_um: return (2 * radius_mm - series.nominal_mm) * units::umPerMm;
    case LengthQuantity::radius_mm: break;
    }
    return radius_mm;
}

double edgeOf(const LengthSpread& spread, LengthLine line) {
    switch (line) {
    case LengthLine::blankMin:
    case LengthLine::min: return spread.min;
    case LengthLine::blankMax:
    case LengthLine::max: return spread.max;
    default: return spread.mean;
    }
}

std::vector<ProfilePoint> level(const ProfileSeries& series, double value) {
    return {{0, value}, {series.length_mm, value}};
}

} // namespace

LengthSpread spreadOf(const std::vector<double>& radii_mm, const ProfileSeries& series,
                      LengthQuantity quantity) {
    LengthSpread spread;
    const std::size_t K = radii_mm.size();
    const bool across = quantity == LengthQuantity::diameter_um;
    const std::size_t count = across ? K / 2 : K;
    double sum = 0;
    std::size_t ground = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const double radius = across ? (radii_mm[k] + radii_mm[k + K / 2]) / 2 : radii_mm[k];
        if (std::isnan(radius)) { // a gap
            continue;
        }
        const double value = valueOf(radius, series, quantity);
        spread.min = ground == 0 ? value : std::min(spread.min, value);
        spread.max = ground == 0 ? value : std::max(spread.max, value);
        sum += value;
        ++ground;
    }
    spread.mean = ground > 0 ? sum / static_cast<double>(ground) : 0;
    return spread;
}

const std::vector<Profile>& alongThePart(const ProfileSeries& series) {
    return series.zoneSections.empty() ? series.profiles : series.zoneSections;
}

double lengthValue(const ProfileSeries& series, const Profile& profile, LengthLine line,
                   LengthQuantity quantity) {
    switch (line) {
    case LengthLine::lowerLimit: return valueOf(series.lowerLimit_mm, series, quantity);
    case LengthLine::upperLimit: return valueOf(series.upperLimit_mm, series, quantity);
    case LengthLine::target: return valueOf(series.target_mm, series, quantity);
    case LengthLine::blankMin:
    case LengthLine::blankMax:
        return edgeOf(spreadOf(series.blankOf(profile), series, quantity), line);
    default: return edgeOf(spreadOf(profile.radii_mm, series, quantity), line);
    }
}

std::vector<ProfilePoint> lengthLine(const ProfileSeries& series, LengthLine line,
                                     LengthQuantity quantity) {
    const bool ofProfile =
        line == LengthLine::min || line == LengthLine::max || line == LengthLine::mean;
    if (!ofProfile) {
        return series.profiles.empty()
                   ? std::vector<ProfilePoint>()
                   : level(series, lengthValue(series, series.profiles[0], line, quantity));
    }
    std::vector<ProfilePoint> points;
    const std::vector<Profile>& profiles = alongThePart(series);
    const std::size_t count = profiles.size();
    // With the entry at the tailstock the zones begin at that end.
    const bool backwards = count > 1 && profiles.front().from_mm > profiles.back().from_mm;
    for (std::size_t i = 0; i < count; ++i) {
        const Profile& p = profiles[backwards ? count - 1 - i : i];
        const double value = lengthValue(series, p, line, quantity);
        if (series.operation->travels) {
            points.push_back({p.from_mm, value});
            points.push_back({p.to_mm, value});
        } else {
            points.push_back({p.position_mm, value});
        }
    }
    return points;
}

int profileAt(const ProfileSeries& series, double position_mm) {
    int nearest = -1;
    double least = 0;
    for (std::size_t i = 0; i < series.profiles.size(); ++i) {
        const Profile& p = series.profiles[i];
        const double away = std::max({p.from_mm - position_mm, position_mm - p.to_mm, 0.0});
        if (nearest < 0 || away < least) {
            nearest = static_cast<int>(i);
            least = away;
        }
    }
    return nearest;
}

std::vector<ShaftStep> shaftSteps(const Project& project) {
    std::vector<ShaftStep> steps;
    if (project.part->surface == Surface::internal) {
        return steps;
    }
    double at = -project.part->shaft.ground_from_mm;
    for (const ShaftSegment& segment : project.part->shaft.segments) {
        steps.push_back({at, at + segment.length_mm, segment.diameter_mm / 2});
        at += segment.length_mm;
    }
    return steps;
}

namespace {

constexpr double fieldTolerance_mm = 1e-9; ///< tolerance of the verdict [MODEL-8]

/// The radii of the blank, for a zone or section or for the whole part.
std::vector<double> blankRadii(const Part& part, std::optional<std::size_t> place = {}) {
    const Blank blank = makeBlank(part);
    const std::vector<double>& depth_mm = place ? blank.depthAt(*place) : blank.depth_mm;
    const double side = part.surface == Surface::internal ? 1 : -1;
    std::vector<double> radii;
    for (std::size_t k = 0; k < depth_mm.size(); ++k) {
        radii.push_back(blank.isGap(k) ? std::numeric_limits<double>::quiet_NaN()
                                       : blank.firstTouchRadius_mm + side * depth_mm[k]);
    }
    return radii;
}

/// Sets the parts of the ground length that the zones or sections represent.
void setStretches(ProfileSeries& series, const Project& project) {
    const std::vector<Stretch> stretches = groundStretches(project);
    for (std::size_t i = 0; i < series.profiles.size(); ++i) {
        series.profiles[i].from_mm = stretches[i].from_mm;
        series.profiles[i].to_mm = stretches[i].to_mm;
    }
}

/// Adds each section with its slice of the ground length, from the headstock end.
void addZoneSections(ProfileSeries& series, const SimulationResult& result) {
    const std::vector<CompliantPoint> points = zoneSectionPoints(result.project);
    for (std::size_t i = 0; i < result.zoneSections.size(); ++i) {
        const SectionResult& s = result.zoneSections[i];
        Profile p;
        p.zone = s.zone;
        p.position_mm = s.position_mm;
        p.from_mm = s.position_mm - points[i].length_mm / 2;
        p.to_mm = s.position_mm + points[i].length_mm / 2;
        p.radii_mm = s.radii_mm;
        series.zoneSections.push_back(std::move(p));
    }
}

ProfileSeries endOfCycle(const SimulationResult& result) {
    const Part& part = *result.project.part;
    ProfileSeries series;
    series.operation = result.project.operation;
    series.surface = part.surface;
    series.nominal_mm = part.diameter_mm;
    series.target_mm = targetRadius(part);
    series.lowerLimit_mm = part.diameter_mm / 2 + part.lower_deviation_um / 2 / units::umPerMm;
    series.upperLimit_mm = part.diameter_mm / 2 + part.upper_deviation_um / 2 / units::umPerMm;
    series.length_mm = part.length_mm;
    series.blank_mm = blankRadii(part);
    series.strokeCount = result.cycleCount;
    series.stroke = result.cycleCount;
    series.time_s = result.time_s;
    series.knowsRunout = isRunoutKnown(*result.project.machine);
    series.knowsRoundness = isRoundnessKnown(*result.project.machine);
    series.knowsEccentricity = isEccentricityKnown(*result.project.machine);
    series.isWhole = FinishedSurface(result.project).isWhole();
    const bool zones = series.operation->travels;
    const int gauge = gaugeProfile(result);
    for (std::size_t i = 0; i < result.sections.size(); ++i) {
        const SectionResult& s = result.sections[i];
        Profile p;
        p.zone = s.zone;
        p.section = static_cast<int>(i);
        p.gauge = p.section == gauge;
        p.position_mm = s.position_mm;
        p.radii_mm = s.radii_mm;
        p.diameterMin_mm = s.diameterDeviationMin_mm;
        p.diameterMax_mm = s.diameterDeviationMax_mm;
        p.radialRunout_mm = s.radialRunout_mm;
        series.profiles.push_back(std::move(p));
        if (i == static_cast<std::size_t>(gauge)) {
            series.gauge_mm =
                zones ? s.position_mm : result.project.gauge->position_mm.value_or(s.position_mm);
        }
    }
    setStretches(series, result.project);
    addZoneSections(series, result);
    if (!zoneBlanks(part).empty()) {
        for (std::size_t i = 0; i < series.profiles.size(); ++i) {
            series.profiles[i].blank_mm = blankRadii(part, i);
        }
        for (Profile& section : series.zoneSections) {
            section.blank_mm = blankRadii(part, static_cast<std::size_t>(section.zone));
        }
    }
    return series;
}

/// Computes deviations and runout of the radii, like Run::sectionResult at the end.
void measure(Profile& profile, double nominal_mm, double geometricRunout_mm) {
    const int half = static_cast<int>(profile.radii_mm.size()) / 2;
    profile.diameterMin_mm = std::numeric_limits<double>::infinity();
    profile.diameterMax_mm = -profile.diameterMin_mm;
    for (int k = 0; k < half; ++k) { // min and max ignore NaN, as across a gap
        const double deviation = diameterAt(profile, k) - nominal_mm;
        profile.diameterMin_mm = std::min(profile.diameterMin_mm, deviation);
        profile.diameterMax_mm = std::max(profile.diameterMax_mm, deviation);
    }
    const SectionShape shape{profile.position_mm, profile.radii_mm};
    profile.radialRunout_mm = runout({&shape, 1}, geometricRunout_mm);
}

/// Replaces the final radii by those at a moment.
void rewindTo(ProfileSeries& series, const Trajectory& trajectory, const Progress& moment) {
    const LastVisits visits = lastVisits(trajectory, series.profiles.size(), moment);
    for (std::size_t i = 0; i < visits.size(); ++i) {
        for (std::size_t k = 0; k < visits[i].size(); ++k) {
            const Visit* const last = visits[i][k];
            series.profiles[i].radii_mm[k] =
                last ? last->radius_mm : series.blankOf(series.profiles[i])[k];
        }
    }
    const Place at = moment.isBlank() ? Place{} : trajectory.passes[moment.end - 1].place;
    series.stage = moment.isBlank() ? 0 : at.stage;
    series.stroke = moment.isBlank() ? 0 : at.cycleCount;
    series.strokeDone = endsStroke(trajectory, moment);
    series.time_s = timeOf(trajectory, moment);
}

} // namespace

ProfileSeries makeProfileSeries(const SimulationResult& result, const Trajectory& trajectory,
                                const std::optional<Progress>& moment) {
    ProfileSeries series = endOfCycle(result);
    if (!trajectory.passes.empty()) {
        series.stage = trajectory.passes.back().place.stage;
    }
    if (moment && moment->end <= trajectory.passes.size() && !trajectory.passes.empty()) {
        rewindTo(series, trajectory, *moment);
        if (!series.atEnd()) { // passes are recorded for the zones' middles
            series.zoneSections.clear();
        }
        const double geometric = addedRunout_um(*result.project.machine) / units::umPerMm;
        for (Profile& p : series.profiles) {
            measure(p, series.nominal_mm, geometric);
        }
    }
    const Directions directions(series.blank_mm.size());
    for (Profile& p : series.profiles) {
        p.mean_mm = meanOfGround(p.radii_mm);
        p.leastSquares = leastSquaresCircle(p.radii_mm, directions);
    }
    return series;
}

void addMinimumZone(Profile& profile) {
    const Directions directions(profile.radii_mm.size());
    profile.minimumZone = minimumZoneCircles(profile.radii_mm, directions, profile.leastSquares);
}

void addHeldCircles(Profile& profile) {
    const Directions directions(profile.radii_mm.size());
    profile.inscribed = maximumInscribedCircle(profile.radii_mm, directions);
    profile.circumscribed = minimumCircumscribedCircle(profile.radii_mm, directions);
}

void filterProfile(Profile& profile, int cutoff_upr) {
    const Directions directions(profile.radii_mm.size());
    profile.radii_mm = gaussianFiltered(profile.radii_mm, directions, cutoff_upr);
    profile.mean_mm = meanOfGround(profile.radii_mm);
    profile.leastSquares = leastSquaresCircle(profile.radii_mm, directions);
}

Profile measuredProfile(const ProfileSeries& series, std::vector<double> radii_mm) {
    Profile profile;
    profile.radii_mm = std::move(radii_mm);
    measure(profile, series.nominal_mm, 0);
    profile.mean_mm = meanOfGround(profile.radii_mm);
    profile.leastSquares =
        leastSquaresCircle(profile.radii_mm, Directions(profile.radii_mm.size()));
    return profile;
}

int gaugeProfile(const SimulationResult& result) {
    const Project& project = result.project;
    if (!project.gauge->position_mm || project.operation->travels) {
        return gaugeSection(project);
    }
    const auto away = [&](const SectionResult& section) {
        return std::abs(section.position_mm - *project.gauge->position_mm);
    };
    return static_cast<int>(std::ranges::min_element(result.sections, {}, away)
                            - result.sections.begin());
}

bool outOfField(const ProfileSeries& series, const Profile& profile) {
    const double lower = 2 * series.lowerLimit_mm - series.nominal_mm;
    const double upper = 2 * series.upperLimit_mm - series.nominal_mm;
    return profile.diameterMin_mm < lower - fieldTolerance_mm
           || profile.diameterMax_mm > upper + fieldTolerance_mm;
}

double radiusOf(const FittedCircle& circle, double angle) {
    const double across = circle.x_mm * std::sin(angle) - circle.y_mm * std::cos(angle);
    return circle.x_mm * std::cos(angle) + circle.y_mm * std::sin(angle)
           + std::sqrt(circle.radius_mm * circle.radius_mm - across * across);
}

double angleOf(int k, int radii) {
    return 2 * std::numbers::pi * k / radii;
}

int nearestRadius(double angle, int radii) {
    const auto k = static_cast<int>(std::lround(angle / angleOf(1, radii)));
    return (k % radii + radii) % radii;
}

double diameterAt(const Profile& profile, int k) {
    const std::size_t K = profile.radii_mm.size();
    const auto i = static_cast<std::size_t>(k);
    const double across = profile.radii_mm[(i + K / 2) % K];
    if (K % 2 == 0) {
        return profile.radii_mm[i] + across;
    }
    return profile.radii_mm[i] + (across + profile.radii_mm[(i + K / 2 + 1) % K]) / 2;
}

} // namespace sparkout
