// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/burn_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sparkout {

namespace {

/// Cubic through two points of the curve with their slopes.
double hermite(const BurnLimitPoint& a, const BurnLimitPoint& b, double stock) {
    const double width = b.stock_mm - a.stock_mm;
    const double t = (stock - a.stock_mm) / width;
    const double slopeA = width * a.rootSlope / a.stockSlope_mm;
    const double slopeB = width * b.rootSlope / b.stockSlope_mm;
    const double rise = b.root - a.root;
    return a.root
           + t * (slopeA + t * (3 * rise - 2 * slopeA - slopeB + t * (slopeA + slopeB - 2 * rise)));
}

/// The curve at rising stocks, through nodes at equal steps of x.
class Curve {
public:
    Curve(const BurnModel& model, double U, double deepest_mm)
        : m_model(model)
        , m_U(U)
        , m_last(model.limitArgument(U, deepest_mm))
        , m_nodes(std::clamp(std::ceil(nodesPerArgument * m_last), fewestNodes, mostNodes)) {
        m_from = m_to = model.limitPoint(U, 0);
    }
    double at(double stock) {
        while (m_to.stock_mm < stock && m_node < m_nodes) {
            m_from = m_to;
            m_to = m_model.limitPoint(m_U, m_last * ++m_node / m_nodes);
        }
        return m_to.stock_mm > m_from.stock_mm ? hermite(m_from, m_to, stock) : m_to.root;
    }

private:
    // 1 is the range of x over which the curve bends.
    static constexpr double nodesPerArgument = 48, fewestNodes = 8, mostNodes = 96;
    const BurnModel& m_model;
    double m_U, m_last, m_nodes;
    BurnLimitPoint m_from, m_to;
    int m_node = 0;
};

} // namespace

BurnTable::BurnTable(const BurnModel& model, double U, double deepest_mm) {
    constexpr double stepsPerScale = 64;
    constexpr double fewest = 16, most = 8192;
    const double deepest = std::max(deepest_mm, 0.0);
    const BurnLimitPoint surface = model.limitPoint(U, 0);
    // The range of stock over which the curve bends: the reach of heat, or that over which √a
    // doubles.
    const double scale = surface.stockSlope_mm * std::min(1.0, surface.root / surface.rootSlope);
    const double wanted = std::ceil(stepsPerScale * deepest / scale);
    m_isResolved = wanted <= most;
    m_last = std::clamp(wanted, fewest, most);
    m_perStep = deepest > 0 ? m_last / deepest : 0;
    Curve curve(model, U, deepest);
    double inverse = 1 / curve.at(0);
    for (double i = 0; i < m_last; ++i) {
        const double middle = 1 / curve.at(deepest * (i + 0.5) / m_last);
        const double next = 1 / curve.at(deepest * (i + 1) / m_last);
        const double bend = 2 * (inverse + next - 2 * middle);
        m_pieces.push_back({inverse, next - inverse - bend, bend});
        inverse = next;
    }
    m_pieces.push_back({inverse, 0, 0});
}

std::optional<BurnStretch> BurnTable::over(double low_mm, double high_mm,
                                           double totalInfeed_mm) const {
    constexpr double enough = 7e-7; ///< relative, at the points between the nodes
    const double centre = (high_mm + low_mm) / 2, half = (high_mm - low_mm) / 2;
    const auto value = [&](double t) { return usage(1, centre + half * t); };
    // Through the values at t = −1, −√½, 0, √½ and 1, even and odd parts apart.
    constexpr double node = 1 / std::numbers::sqrt2;
    const double v0 = value(0), n1 = value(-node), n2 = value(node), e1 = value(-1), e2 = value(1);
    const double evenEnd = (e1 + e2) / 2 - v0, evenNode = (n1 + n2) / 2 - v0;
    const double oddEnd = (e2 - e1) / 2, oddNode = (n2 - n1) / (2 * node);
    const double cubic = 2 * (oddEnd - oddNode), square = 4 * evenNode - evenEnd;
    const double by = 1 / half, byBy = by * by;
    const BurnStretch found{.total = totalInfeed_mm,
                            .low = low_mm,
                            .centre = centre,
                            .c = {v0, (oddEnd - cubic) * by, square * byBy, cubic * byBy * by,
                                  (evenEnd - square) * byBy * byBy}};
    // cos π/8 and cos 3π/8: the error of such a polynomial is largest near them.
    constexpr double outer = 0.92387953251128674, inner = 0.38268343236508977;
    for (const double t : {-outer, -inner, inner, outer}) {
        const double given = value(t);
        if (!(std::abs(found.usage(1, totalInfeed_mm - centre - half * t) - given)
              <= enough * given)) {
            return std::nullopt;
        }
    }
    return found;
}

namespace {

// One source compiled for two vector units, like the pass (pass_kernel.cpp).
[[gnu::always_inline]] inline double worstOf(const BurnStretch& stretch,
                                             const double* __restrict root,
                                             const double* __restrict depth, std::size_t count) {
    const BurnStretch local = stretch; // keeps its numbers in registers
    double worst = 0;
#pragma omp simd reduction(max : worst)
    for (std::size_t i = 0; i < count; ++i) {
        const double used = local.usage(root[i], depth[i]);
        worst = used > worst ? used : worst;
    }
    return worst;
}
double worstBaseline(const BurnStretch& stretch, const double* root, const double* depth,
                     std::size_t count) {
    return worstOf(stretch, root, depth, count);
}
[[gnu::target("avx2")]] double worstAvx2(const BurnStretch& stretch, const double* root,
                                         const double* depth, std::size_t count) {
    return worstOf(stretch, root, depth, count);
}

const bool hasAvx2 = __builtin_cpu_supports("avx2");

} // namespace

double BurnStretch::worst(const double* root, const double* depth_mm, std::size_t count) const {
    return hasAvx2 ? worstAvx2(*this, root, depth_mm, count)
                   : worstBaseline(*this, root, depth_mm, count);
}

} // namespace sparkout
