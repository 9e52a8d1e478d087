// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/chart/profiles_look.h"

#include "ui/chart/quantity_colour.h"
#include "ui/chart/view_plot.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr double mostInward = 0.6; ///< relative to the base circle, if chosen by the program
constexpr double mostOutward = 1;
constexpr double mostInwardByHand = 0.9;
constexpr double mostOutwardByHand = 3;
constexpr double highestMagnification = 1e6;

double magnificationWithin(const Reach& reach, double base_mm, double inward, double outward) {
    double most = highestMagnification;
    if (reach.inward_mm > 0) {
        most = std::min(most, inward * base_mm / reach.inward_mm);
    }
    if (reach.outward_mm > 0) {
        most = std::min(most, outward * base_mm / reach.outward_mm);
    }
    return std::max(roundDown125(most), 1.0);
}

} // namespace

PolarScale polarScale(const ProfileSeries& series, const Profile& profile,
                      RadiusReference reference, double magnification) {
    const bool mean = reference == RadiusReference::mean;
    return {series.target_mm, mean ? profile.mean_mm : series.target_mm, magnification};
}

std::vector<ProfilePoint> closedLine(const std::vector<double>& radii_mm, const PolarScale& scale) {
    const int K = static_cast<int>(radii_mm.size());
    std::vector<ProfilePoint> line;
    line.reserve(radii_mm.size() + 1);
    for (int i = 0; i <= K && K > 0; ++i) {
        const int k = i % K;
        const double drawn = scale.at(radii_mm[static_cast<std::size_t>(k)]);
        line.push_back({drawn * std::cos(angleOf(k, K)), drawn * std::sin(angleOf(k, K))});
    }
    return line;
}

std::vector<ProfilePoint> circleLine(const FittedCircle& circle, const PolarScale& scale,
                                     int points) {
    std::vector<double> radii;
    for (int k = 0; k < points; ++k) {
        radii.push_back(radiusOf(circle, angleOf(k, points)));
    }
    return closedLine(radii, scale);
}

ProfilePoint centrePoint(const RoundnessZone& zone, const PolarScale& scale) {
    return {scale.magnification * zone.x_mm, scale.magnification * zone.y_mm};
}

void Reach::include(double deviation_mm) {
    inward_mm = std::max(inward_mm, -deviation_mm);
    outward_mm = std::max(outward_mm, deviation_mm);
}

Reach reachOf(const ProfileSeries& series, const std::vector<int>& shown, RadiusReference reference,
              bool withBlank) {
    Reach reach;
    for (const int index : shown) {
        const Profile& profile = series.profiles[static_cast<std::size_t>(index)];
        const PolarScale scale = polarScale(series, profile, reference, 1);
        for (const double radius : profile.radii_mm) {
            reach.include(radius - scale.reference_mm);
        }
        for (std::size_t k = 0; withBlank && k < series.blank_mm.size(); ++k) {
            reach.include(series.blankOf(profile)[k] - scale.reference_mm);
        }
    }
    return reach;
}

double roundDown125(double value) {
    const double power = std::pow(10.0, std::floor(std::log10(value)));
    // Rounding must not miss a number that is 1, 2 or 5 exactly.
    const double lead = value / power * (1 + 1e-12);
    return (lead >= 10 ? 10 : lead >= 5 ? 5 : lead >= 2 ? 2 : 1) * power;
}

double roundUp125(double value) {
    const double below = roundDown125(value);
    if (below >= value * (1 - 1e-12)) {
        return below;
    }
    const double lead = below / std::pow(10.0, std::floor(std::log10(below * (1 + 1e-12))));
    return below * (lead > 1.5 && lead < 3 ? 2.5 : 2);
}

double suitableMagnification(const Reach& reach, double base_mm) {
    return magnificationWithin(reach, base_mm, mostInward, mostOutward);
}

std::vector<double> possibleMagnifications(const Reach& reach, double base_mm) {
    const double most = magnificationWithin(reach, base_mm, mostInwardByHand, mostOutwardByHand);
    std::vector<double> numbers;
    for (double power = 1; power <= most; power *= 10) {
        for (const double lead : {1, 2, 5}) {
            if (lead * power <= most * (1 + 1e-9)) {
                numbers.push_back(lead * power);
            }
        }
    }
    return numbers;
}

using style::Drawn;

namespace {

Drawn drawnAs(ProfileLine line) {
    switch (line) {
    case ProfileLine::profile:
    case ProfileLine::spread: return Drawn::profile;
    case ProfileLine::blank: return Drawn::blank;
    case ProfileLine::target: return Drawn::target;
    case ProfileLine::gauge: return Drawn::gauge;
    case ProfileLine::leastSquares:
    case ProfileLine::inscribed:
    case ProfileLine::circumscribed:
    case ProfileLine::minimumZone: return Drawn::referenceCircle;
    case ProfileLine::field: break;
    }
    return Drawn::toleranceField;
}

} // namespace

QPen ProfileLook::pen(ProfileLine line, const QPalette& palette, bool dim) {
    const QColor colour = style::dimmed(style::colour(drawnAs(line), palette), dim);
    QPen pen = style::line(drawnAs(line), colour);
    if (line == ProfileLine::spread) { // the edge of its area
        pen.setWidthF(0.8);
    }
    return pen;
}

QColor ProfileLook::fill(ProfileLine line, const QPalette& palette, bool dim) {
    QColor colour = style::dimmed(style::colour(drawnAs(line), palette), dim);
    const bool strong = line == ProfileLine::spread;
    colour.setAlphaF(colour.alphaF() * (strong ? 0.35F : style::isDark(palette) ? 0.22F : 0.16F));
    return colour;
}

QString ProfileLook::name(ProfileLine line) {
    switch (line) {
    case ProfileLine::profile: return tr("profile, along the axis its mean");
    case ProfileLine::spread: return tr("minimum…maximum over the radii");
    case ProfileLine::blank: return tr("blank");
    case ProfileLine::target: return tr("target radius");
    case ProfileLine::leastSquares: return tr("least-squares circle");
    case ProfileLine::minimumZone: return tr("circles of the minimum zone");
    case ProfileLine::inscribed: return tr("maximum inscribed circle");
    case ProfileLine::circumscribed: return tr("minimum circumscribed circle");
    case ProfileLine::field: return tr("tolerance band");
    case ProfileLine::gauge: return tr("gauge");
    }
    return {};
}

} // namespace sparkout
