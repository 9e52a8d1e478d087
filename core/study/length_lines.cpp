// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/study/length_lines.h"

#include "core/project/part.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>

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

} // namespace sparkout
