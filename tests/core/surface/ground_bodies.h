// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/accuracy.h"
#include "core/surface/cylindricity.h"
#include "core/surface/harmonics.h"
#include "tests/core/support/dense.h"
#include "tests/core/support/random_cutting.h"
#include "tests/core/support/rapidcheck_runs.h"
#include "tests/core/surface/downhill.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

/// Random bodies of several sections, and their zones by other means.
namespace sparkout::ground_bodies {

using fixtures::between;
using fixtures::close;
using fixtures::decades;
using fixtures::holds;
using fixtures::oneIn;
using fixtures::pick;
using fixtures::within;

using Radii = std::vector<double>;

inline double angle(std::size_t k, std::size_t K) {
    return 2 * std::numbers::pi * double(k) / double(K);
}

/// The sections of a part, which own their radii.
struct Body {
    std::vector<double> positions;
    std::vector<Radii> radii;

    [[nodiscard]] std::vector<SectionShape> shapes() const {
        std::vector<SectionShape> found;
        for (std::size_t j = 0; j < positions.size(); ++j) {
            found.push_back({positions[j], radii[j]});
        }
        return found;
    }
    [[nodiscard]] std::size_t K() const { return radii[0].size(); }
};

inline Body anyBody(std::size_t J, std::size_t K, double form) {
    Body body;
    double position = between(0, 20);
    for (std::size_t j = 0; j < J; ++j) {
        body.positions.push_back(position);
        position += between(2, 60);
        Radii radii(K);
        const double shift = form * between(0, 0.4), phase = between(0, 6);
        const double size = form * between(-0.3, 0.3), lobe = form * between(0, 0.3);
        for (std::size_t k = 0; k < K; ++k) {
            radii[k] = 15 + size + shift * std::cos(angle(k, K) - phase)
                       + lobe * std::cos(3 * angle(k, K)) + 0.2 * form * between(-1, 1);
        }
        body.radii.push_back(radii);
    }
    return body;
}

/// Every section alike.
inline Body prism(const std::vector<double>& positions, const Radii& radii) {
    return {positions, std::vector<Radii>(positions.size(), radii)};
}

struct Axis {
    double x = 0, y = 0, slopeX = 0, slopeY = 0;
};

/// Distance of a point to a line through (x, y) at `middle`, by the cross product.
inline double distanceTo(const Body& body, std::size_t j, std::size_t k, double middle,
                         const Axis& axis) {
    const double x = body.radii[j][k] * std::cos(angle(k, body.K())) - axis.x;
    const double y = body.radii[j][k] * std::sin(angle(k, body.K())) - axis.y;
    const double z = body.positions[j] - middle;
    const double u = axis.slopeX, v = axis.slopeY;
    return std::hypot(y - z * v, z * u - x, x * v - y * u) / std::hypot(u, v, 1);
}

inline double width(const Body& body, double middle, const Axis& axis) {
    double low = 1e300, high = 0;
    for (std::size_t j = 0; j < body.positions.size(); ++j) {
        for (std::size_t k = 0; k < body.K(); ++k) {
            const double d = distanceTo(body, j, k, middle, axis);
            low = std::min(low, d);
            high = std::max(high, d);
        }
    }
    return high - low;
}

/// The radii at which rays from the axis of the machine meet a true cylinder that leans.
inline Body leaningCylinder(const std::vector<double>& positions, std::size_t K, double R,
                            const Axis& axis) {
    Body body{positions, {}};
    const double t2 = axis.slopeX * axis.slopeX + axis.slopeY * axis.slopeY;
    for (const double z : positions) {
        Radii radii(K);
        for (std::size_t k = 0; k < K; ++k) {
            const double c = std::cos(angle(k, K)), s = std::sin(angle(k, K));
            const double ax = axis.x + axis.slopeX * z, ay = axis.y + axis.slopeY * z;
            // |q|² − (q·t)²/(1 + t²) = R² with q = ρ·(c, s) − a, a quadratic in ρ
            const double ct = c * axis.slopeX + s * axis.slopeY;
            const double at = ax * axis.slopeX + ay * axis.slopeY;
            const double A = 1 - ct * ct / (1 + t2);
            const double B = -(c * ax + s * ay) + ct * at / (1 + t2);
            const double C = ax * ax + ay * ay - at * at / (1 + t2) - R * R;
            radii[k] = (-B + std::sqrt(B * B - A * C)) / A;
        }
        body.radii.push_back(radii);
    }
    return body;
}

/// The surface's points as an axis in the middle sees them, all linear.
inline AxisView linearView(const Body& body) {
    AxisView view(body.positions.size(), body.K());
    const double middle = (body.positions.front() + body.positions.back()) / 2;
    const double reach = (body.positions.back() - body.positions.front()) / 2;
    for (std::size_t j = 0; j < body.positions.size(); ++j) {
        for (std::size_t k = 0; k < body.K(); ++k) {
            const std::size_t i = j * body.K() + k;
            view.d[i] = body.radii[j][k];
            view.nx[i] = std::cos(angle(k, body.K()));
            view.ny[i] = std::sin(angle(k, body.K()));
        }
        view.zeta[j] = (body.positions[j] - middle) / reach;
    }
    return view;
}

/// The largest level of any six points: by duality the least of the whole.
inline double bestOfAllSixes(const AxisView& view) {
    const std::size_t N = view.d.size();
    double most = 0;
    std::vector<bool> chosen(N);
    std::fill(chosen.begin(), chosen.begin() + 6, true);
    do {
        dense::Matrix G(5);
        std::vector<double> d;
        for (std::size_t i = 0; i < N; ++i) {
            if (chosen[i]) {
                G[0].push_back(1);
                G[1].push_back(view.nx[i]);
                G[2].push_back(view.ny[i]);
                G[3].push_back(view.nx[i] * view.zetaOf(i));
                G[4].push_back(view.ny[i] * view.zetaOf(i));
                d.push_back(view.d[i]);
            }
        }
        most = std::max(most, dense::alternation(G, d));
    } while (std::prev_permutation(chosen.begin(), chosen.end()));
    return most;
}

inline double longest(const Body& body) {
    return body.positions.back() - body.positions.front();
}

/// What the curvature of the distances may hide (the header's bound), and some last bits.
inline double curvature(const Body& body, double w) {
    return 2 * (w * w / 15 + 15 * std::pow(2 * w / longest(body), 2)) + 2e-12;
}

} // namespace sparkout::ground_bodies
