// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/form/reference_circles.h"

#include "core/form/centre_view.h"
#include "core/form/value_range.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <numbers>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
/// Rounding error of a radius by the distances' last bits, relative to the radius.
constexpr double roundings = 8 * epsilon;
/// Smaller weights count as 0.
constexpr double leastWeight = 1e-12;

enum class Side { inscribed, circumscribed };

using Basis = std::array<std::size_t, 3>;

Eigen::Matrix3d rowsOf(const CentreView& view, const Basis& basis) {
    Eigen::Matrix3d rows;
    for (int i = 0; i < 3; ++i) {
        const std::size_t k = basis[static_cast<std::size_t>(i)];
        rows.row(i) << 1, view.nx[k], view.ny[k];
    }
    return rows;
}

/// Weights ≥ 0 that sum to 1 and balance the directions: λ of Σλ·(1, n) = (1, 0, 0).
Eigen::Vector3d weightsOf(const Eigen::Matrix3d& rows) {
    return rows.transpose().partialPivLu().solve(Eigen::Vector3d(1, 0, 0));
}

double leastOf(const Eigen::Vector3d& weights) {
    const double least = weights.minCoeff();
    return std::isfinite(least) ? least : -std::numeric_limits<double>::infinity();
}

/// Three points a third of a turn apart, or for interrupted sections as near to it as possible; of
/// all such the best balanced ones. Empty if there are none.
std::optional<Basis> balanced(const CentreView& view) {
    std::vector<std::pair<double, std::size_t>> angles;
    for (std::size_t k = 0; k < view.d.size(); ++k) {
        angles.emplace_back(std::atan2(view.ny[k], view.nx[k]), k);
    }
    std::ranges::sort(angles);
    const double turn = 2 * std::numbers::pi;
    const auto nearest = [&](double angle) {
        const double wanted = angle > turn / 2 ? angle - turn : angle;
        auto after = std::ranges::lower_bound(angles, std::pair(wanted, std::size_t{0}));
        const auto before = after == angles.begin() ? angles.end() - 1 : after - 1;
        after = after == angles.end() ? angles.begin() : after;
        const double ahead = std::abs(std::remainder(after->first - wanted, turn));
        const double behind = std::abs(std::remainder(wanted - before->first, turn));
        return ahead < behind ? after->second : before->second;
    };
    std::optional<Basis> best;
    double most = leastWeight;
    for (const auto& [angle, k] : angles) {
        const Basis basis{k, nearest(angle + turn / 3), nearest(angle + 2 * turn / 3)};
        const double least = leastOf(weightsOf(rowsOf(view, basis)));
        if (least > most) {
            most = least;
            best = basis;
        }
    }
    return best;
}

/// The largest level with level + x·nx_k + y·ny_k ≤ v_k for all k.
struct Lift {
    double level = 0, x = 0, y = 0;
};

/// The dual simplex method: each exchange lowers the level, until no point has an excess.
Lift lift(const CentreView& view, const std::vector<double>& v, Basis& basis, double tolerance) {
    Lift found;
    for (std::size_t step = 0; step < 4 * v.size() + 64; ++step) {
        const Eigen::Matrix3d rows = rowsOf(view, basis);
        const Eigen::Vector3d at =
            rows.partialPivLu().solve(Eigen::Vector3d(v[basis[0]], v[basis[1]], v[basis[2]]));
        found = {at[0], at[1], at[2]};
        std::size_t entering = 0;
        double least = std::numeric_limits<double>::infinity();
        for (std::size_t k = 0; k < v.size(); ++k) {
            const double room = v[k] - at[0] - at[1] * view.nx[k] - at[2] * view.ny[k];
            if (room < least) {
                least = room;
                entering = k;
            }
        }
        if (!(least < -tolerance)) {
            break;
        }
        const Eigen::Vector3d weights = weightsOf(rows);
        const Eigen::Vector3d along = rows.transpose().partialPivLu().solve(
            Eigen::Vector3d(1, view.nx[entering], view.ny[entering]));
        int leaving = -1;
        double smallest = std::numeric_limits<double>::infinity();
        for (int i = 0; i < 3; ++i) {
            if (along[i] > leastWeight && weights[i] / along[i] < smallest) {
                smallest = weights[i] / along[i];
                leaving = i;
            }
        }
        if (leaving < 0) {
            break;
        }
        basis[static_cast<std::size_t>(leaving)] = entering;
    }
    return found;
}

RoundnessZone zoneAbout(const CentreView& view, double x, double y, Side side) {
    const ValueRange distances = rangeOf(view.d);
    RoundnessZone zone;
    zone.x_mm = x;
    zone.y_mm = y;
    zone.inner_mm = distances.low;
    zone.outer_mm = distances.high;
    zone.reference_mm = side == Side::inscribed ? zone.inner_mm : zone.outer_mm;
    return zone;
}

std::optional<RoundnessZone> circleOf(std::span<const double> given, const Directions& all,
                                      Side side) {
    const GroundRadii ground(given);
    if (ground.indices().size() < 4) {
        return std::nullopt;
    }
    const std::vector<double> radii = ground.of(given);
    const Directions directions(all, ground.indices());
    constexpr int mostSteps = 60;
    const double sign = side == Side::inscribed ? 1 : -1;
    const RoundnessZone start = leastSquaresCircle(given, all);
    CentreView view(radii.size());
    view.take(radii, directions, start.x_mm, start.y_mm);
    RoundnessZone best = zoneAbout(view, start.x_mm, start.y_mm, side);
    const double tolerance = roundings * best.outer_mm;
    std::vector<double> v(radii.size());
    std::optional<Basis> basis;
    for (int step = 0; step < mostSteps; ++step) {
        if (!basis || leastOf(weightsOf(rowsOf(view, *basis))) < -leastWeight) {
            basis = balanced(view);
        }
        if (!basis) {
            return std::nullopt;
        }
        std::ranges::transform(view.d, v.begin(), [sign](double d) { return sign * d; });
        const Lift lifted = lift(view, v, *basis, tolerance / 2);
        const double gain = lifted.level - sign * best.reference_mm;
        bool better = false;
        for (double share = 1; gain > tolerance && !better && share > 1e-4; share /= 2) {
            const double x = best.x_mm + sign * share * lifted.x;
            const double y = best.y_mm + sign * share * lifted.y;
            view.take(radii, directions, x, y);
            const RoundnessZone tried = zoneAbout(view, x, y, side);
            better = sign * (tried.reference_mm - best.reference_mm) > 0;
            best = better ? tried : best;
        }
        if (!better) {
            break;
        }
    }
    return best;
}

} // namespace

std::optional<RoundnessZone> minimumCircumscribedCircle(std::span<const double> radii_mm,
                                                        const Directions& directions) {
    return circleOf(radii_mm, directions, Side::circumscribed);
}

std::optional<RoundnessZone> maximumInscribedCircle(std::span<const double> radii_mm,
                                                    const Directions& directions) {
    return circleOf(radii_mm, directions, Side::inscribed);
}

} // namespace sparkout
