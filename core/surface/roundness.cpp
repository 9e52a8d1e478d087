// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/roundness.h"

#include "core/surface/section_points.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cassert>
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

Directions::Directions(std::size_t K) : m_cos(K), m_sin(K) {
    assert(K >= 4);
    for (std::size_t k = 0; k < K; ++k) {
        const double phi = 2 * std::numbers::pi * static_cast<double>(k) / static_cast<double>(K);
        m_cos[k] = std::cos(phi);
        m_sin[k] = std::sin(phi);
    }
}

Directions::Directions(const Directions& all, std::span<const std::size_t> radii)
    : m_even(radii.size() == all.size()) {
    assert(radii.size() >= 4);
    for (const std::size_t k : radii) {
        m_cos.push_back(all.m_cos[k]);
        m_sin.push_back(all.m_sin[k]);
    }
}

GroundRadii::GroundRadii(std::span<const double> radii) : m_count(radii.size()) {
    for (std::size_t k = 0; k < radii.size(); ++k) {
        if (!std::isnan(radii[k])) {
            m_ground.push_back(k);
        }
    }
}

std::vector<double> GroundRadii::of(std::span<const double> radii) const {
    std::vector<double> ground;
    for (const std::size_t k : m_ground) {
        ground.push_back(radii[k]);
    }
    return ground;
}

namespace {

/// d_k ≈ r + x·nx_k + y·ny_k ± level.
struct Fit {
    double r = 0, x = 0, y = 0;
    double level = 0; ///< signed: reference point m is off by level·(−1)^m

    [[nodiscard]] double residual(const CentreView& s, std::size_t k) const {
        return s.d[k] - r - x * s.nx[k] - y * s.ny[k];
    }
};

/// Remez's exchange for {1, nx, ny} on the points of one section: four reference points by rising
/// angle, their residuals equal and alternating; the point with the largest excess replaces its
/// neighbour of the same sign. Every exchange raises the level, so none recurs.
class Exchange {
public:
    explicit Exchange(std::size_t K) : m_reference{0, K / 4, K / 2, K / 2 + K / 4}, m_off(K) {}

    Fit run(const CentreView& view, double tolerance) {
        Fit fit = solve(view);
        for (std::size_t step = 0; step < 4 * view.d.size() + 64; ++step) {
            const std::size_t k = furthest(view, fit);
            const double residual = fit.residual(view, k);
            if (std::abs(residual) <= std::abs(fit.level) + tolerance || isReference(k)) {
                break;
            }
            exchange(k, residual > 0, fit.level >= 0);
            fit = solve(view);
        }
        return fit;
    }

    /// Reference points from one that touches the outer circle on.
    [[nodiscard]] std::array<std::size_t, 4> contacts(const Fit& fit) const {
        std::array<std::size_t, 4> found = m_reference;
        if (fit.level < 0) {
            std::rotate(found.begin(), found.begin() + 1, found.end());
        }
        return found;
    }

private:
    [[nodiscard]] bool isReference(std::size_t k) const {
        return std::find(m_reference.begin(), m_reference.end(), k) != m_reference.end();
    }

    /// Solves for equal and alternating residuals: the differences of the first and the third
    /// distance, and of the second and the fourth, depend neither on radius nor level.
    [[nodiscard]] Fit solve(const CentreView& s) const {
        const auto [a, b, c, d] = m_reference;
        const double ax = s.nx[a] - s.nx[c], ay = s.ny[a] - s.ny[c], ad = s.d[a] - s.d[c];
        const double bx = s.nx[b] - s.nx[d], by = s.ny[b] - s.ny[d], bd = s.d[b] - s.d[d];
        const double determinant = ax * by - ay * bx;
        const double x = (ad * by - ay * bd) / determinant;
        const double y = (ax * bd - ad * bx) / determinant;
        const auto rest = [&](std::size_t k) { return s.d[k] - x * s.nx[k] - y * s.ny[k]; };
        const double above = (rest(a) + rest(c)) / 2, below = (rest(b) + rest(d)) / 2;
        return {(above + below) / 2, x, y, (above - below) / 2};
    }

    std::size_t furthest(const CentreView& view, const Fit& fit) {
        const double* __restrict d = view.d.data();
        const double* __restrict nx = view.nx.data();
        const double* __restrict ny = view.ny.data();
        double* __restrict off = m_off.data();
        const std::size_t K = m_off.size();
#pragma omp simd
        for (std::size_t k = 0; k < K; ++k) {
            off[k] = std::abs(d[k] - fit.r - fit.x * nx[k] - fit.y * ny[k]);
        }
        const auto most = std::find(m_off.begin(), m_off.end(), rangeOf(m_off).high);
        // With NaN values, as with a centre in one of the points, a reference point ends the
        // exchange.
        return most != m_off.end() ? static_cast<std::size_t>(most - m_off.begin())
                                   : m_reference.front();
    }

    // The signs alternate all around, so exactly one of the two neighbours has the new point's
    // sign.
    void exchange(std::size_t k, bool outside, bool evenIsOutside) {
        const auto next = static_cast<std::size_t>(
            std::upper_bound(m_reference.begin(), m_reference.end(), k) - m_reference.begin());
        const std::size_t after = next % 4, before = (next + 3) % 4;
        const bool afterIsOutside = (after % 2 == 0) == evenIsOutside;
        m_reference[afterIsOutside == outside ? after : before] = k;
        std::sort(m_reference.begin(), m_reference.end());
    }

    std::array<std::size_t, 4> m_reference;
    std::vector<double> m_off; ///< of each point
};

RoundnessZone zone(const CentreView& view, double x, double y) {
    RoundnessZone found;
    found.x_mm = x;
    found.y_mm = y;
    const ValueRange distances = rangeOf(view.d);
    found.inner_mm = distances.low;
    found.outer_mm = distances.high;
    found.reference_mm = (found.inner_mm + found.outer_mm) / 2;
    return found;
}

RoundnessZone limaconZone(std::span<const double> radii, const Directions& directions) {
    const double tolerance = roundings * rangeOf(radii).high;
    CentreView view(radii.size());
    view.takeLimacon(radii, directions);
    Exchange exchange(radii.size());
    const Fit fit = exchange.run(view, tolerance);
    RoundnessZone found;
    found.x_mm = fit.x;
    found.y_mm = fit.y;
    found.reference_mm = fit.r;
    found.inner_mm = fit.r - std::abs(fit.level);
    found.outer_mm = fit.r + std::abs(fit.level);
    found.contacts = exchange.contacts(fit);
    return found;
}

/// Mean distance, and the shift of the centre by the nearly orthogonal directions.
struct Step {
    double r = 0, x = 0, y = 0;
};

/// For uneven directions: the least Σ(e − r − x·nx − y·ny)².
Step leastSquaresOfSome(const CentreView& view) {
    Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
    Eigen::Vector3d right = Eigen::Vector3d::Zero();
    for (std::size_t k = 0; k < view.d.size(); ++k) {
        const Eigen::Vector3d row(1, view.nx[k], view.ny[k]);
        normal += row * row.transpose();
        right += row * (view.d[k] - view.d[0]);
    }
    const Eigen::Vector3d found = normal.partialPivLu().solve(right);
    return {view.d[0] + found[0], found[1], found[2]};
}

Step leastSquaresStep(const CentreView& view) {
    const double* __restrict d = view.d.data();
    const double* __restrict nx = view.nx.data();
    const double* __restrict ny = view.ny.data();
    const std::size_t K = view.d.size();
    double sum = 0, x = 0, y = 0, sumX = 0, sumY = 0;
#pragma omp simd reduction(+ : sum, x, y, sumX, sumY)
    for (std::size_t k = 0; k < K; ++k) {
        const double e = d[k] - d[0];
        sum += e;
        x += e * nx[k];
        y += e * ny[k];
        sumX += nx[k];
        sumY += ny[k];
    }
    const auto count = static_cast<double>(K);
    const double mean = sum / count;
    return {d[0] + mean, 2 / count * (x - mean * sumX), 2 / count * (y - mean * sumY)};
}

bool isInterrupted(std::span<const double> radii) {
    return std::any_of(radii.begin(), radii.end(), [](double R) { return std::isnan(R); });
}

/// The result of `zoneOf` for the ground radii and their directions.
template <class ZoneOf>
RoundnessZone ofGround(std::span<const double> radii, const Directions& directions,
                       const ZoneOf& zoneOf) {
    const GroundRadii ground(radii);
    RoundnessZone found = zoneOf(ground.of(radii), Directions(directions, ground.indices()));
    for (std::size_t& contact : found.contacts) {
        contact = ground.indices()[contact];
    }
    return found;
}

} // namespace

RoundnessZone leastSquaresCircle(std::span<const double> radii, const Directions& directions) {
    if (isInterrupted(radii)) {
        return ofGround(radii, directions, leastSquaresCircle);
    }
    constexpr int mostSteps = 200;
    CentreView view(radii.size());
    double x = 0, y = 0, r = 0, share = 1;
    double last = std::numeric_limits<double>::infinity();
    for (int step = 0; step < mostSteps; ++step) {
        view.take(radii, directions, x, y);
        const Step by = directions.areEven() ? leastSquaresStep(view) : leastSquaresOfSome(view);
        const double size = std::abs(by.x) + std::abs(by.y);
        r = by.r;
        if (size <= 32 * epsilon * r || step + 1 == mostSteps) {
            break;
        }
        share = size > last ? share / 2 : share; // far from round the steps may overshoot
        last = size;
        x += share * by.x;
        y += share * by.y;
    }
    RoundnessZone found = zone(view, x, y);
    found.reference_mm = r;
    return found;
}

// Gauss-Newton on the centre: each step is the exact minimum zone of the distances linearised about
// the last centre, halved until the true zone becomes narrower.
RoundnessZone minimumZoneCircles(std::span<const double> radii, const Directions& directions,
                                 const RoundnessZone& leastSquares) {
    if (isInterrupted(radii)) {
        return ofGround(radii, directions,
                        [&](const std::vector<double>& some, const Directions& theirs) {
                            return minimumZoneCircles(some, theirs, leastSquares);
                        });
    }
    constexpr int mostSteps = 50;
    const double tolerance = roundings * leastSquares.outer_mm;
    RoundnessZone best = leastSquares;
    CentreView view(radii.size());
    Exchange exchange(radii.size());
    view.take(radii, directions, best.x_mm, best.y_mm);
    for (int step = 0; step < mostSteps; ++step) {
        const Fit fit = exchange.run(view, tolerance / 2);
        best.contacts = exchange.contacts(fit);
        const double gain = best.deviation() - 2 * std::abs(fit.level);
        bool narrower = false;
        for (double share = 1; gain > tolerance && !narrower && share > 1e-3; share /= 2) {
            const double x = best.x_mm + share * fit.x, y = best.y_mm + share * fit.y;
            view.take(radii, directions, x, y);
            const RoundnessZone tried = zone(view, x, y);
            narrower = tried.deviation() < best.deviation();
            if (narrower) {
                best = tried;
                best.contacts = exchange.contacts(fit);
            }
        }
        if (!narrower) {
            break;
        }
    }
    best.reference_mm = (best.inner_mm + best.outer_mm) / 2;
    return best;
}

RoundnessZone minimumZoneCircles(std::span<const double> radii, const Directions& directions,
                                 ZoneModel model) {
    if (isInterrupted(radii)) {
        return ofGround(radii, directions,
                        [model](const std::vector<double>& some, const Directions& theirs) {
                            return minimumZoneCircles(some, theirs, model);
                        });
    }
    return model == ZoneModel::limacons
               ? limaconZone(radii, directions)
               : minimumZoneCircles(radii, directions, leastSquaresCircle(radii, directions));
}

} // namespace sparkout
