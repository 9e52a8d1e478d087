// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/burn_table.h"

#include <algorithm>
#include <array>
#include <cmath>

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
        : m_model(model), m_U(U), m_last(model.limitArgument(U, deepest_mm)) {
        m_from = m_to = model.limitPoint(U, 0);
    }
    double at(double stock) {
        while (m_to.stock_mm < stock && m_node < nodes) {
            m_from = m_to;
            m_to = m_model.limitPoint(m_U, m_last * ++m_node / nodes);
        }
        return m_to.stock_mm > m_from.stock_mm ? hermite(m_from, m_to, stock) : m_to.root;
    }

private:
    static constexpr int nodes = 96;
    const BurnModel& m_model;
    double m_U, m_last;
    BurnLimitPoint m_from, m_to;
    int m_node = 0;
};

} // namespace

BurnTable::BurnTable(const BurnModel& model, double U, double deepest_mm) {
    constexpr double stepsPerScale = 50;
    constexpr double fewest = 16, most = 4096;
    const double deepest = std::max(deepest_mm, 0.0);
    const BurnLimitPoint surface = model.limitPoint(U, 0);
    // The stock over which the curve bends: the reach of heat, or over which √a doubles.
    const double scale = surface.stockSlope_mm * std::min(1.0, surface.root / surface.rootSlope);
    m_last = std::clamp(std::ceil(stepsPerScale * deepest / scale), fewest, most);
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

namespace {

/// Lanes looked at together, with one secant; lanes whose largest bound is compared at once.
constexpr std::size_t blockLanes = 64, groupLanes = 8;

/// 1/√a along the secant over the stocks of some lanes.
struct Secant {
    double inverse = 0, slope = 0; ///< at the stock `from`, and per mm beyond it
    double from = 0;
};

struct DepthRange {
    double least = 0, most = 0;
};

// Each loop is written once and compiled for two vector units, as the pass is (pass_kernel.cpp).
[[gnu::always_inline]] inline DepthRange depthsIn(const double* __restrict depth,
                                                  std::size_t count) {
    double least = depth[0], most = depth[0];
#pragma omp simd reduction(min : least) reduction(max : most)
    for (std::size_t i = 0; i < count; ++i) {
        least = depth[i] < least ? depth[i] : least;
        most = depth[i] > most ? depth[i] : most;
    }
    return {least, most};
}
DepthRange depthsBaseline(const double* depth, std::size_t count) {
    return depthsIn(depth, count);
}
[[gnu::target("avx2")]] DepthRange depthsAvx2(const double* depth, std::size_t count) {
    return depthsIn(depth, count);
}

using Bounds = std::array<double, blockLanes>;

/// The bounds of the lanes, 0 up to the end of the last group; returns the largest.
[[gnu::always_inline]] inline double boundsIn(const double* __restrict root,
                                              const double* __restrict depth, Bounds& bounds,
                                              std::size_t count, double total,
                                              const Secant& secant) {
    double* __restrict bound = bounds.data();
    const double inverse = secant.inverse, slope = secant.slope, from = total - secant.from;
    double most = 0;
#pragma omp simd reduction(max : most)
    for (std::size_t i = 0; i < count; ++i) {
        const double b = root[i] * (inverse + slope * (from - depth[i]));
        bound[i] = b;
        most = b > most ? b : most;
    }
    for (std::size_t i = count; i % groupLanes != 0; ++i) {
        bound[i] = 0;
    }
    return most;
}
double boundsBaseline(const double* root, const double* depth, Bounds& bounds, std::size_t count,
                      double total, const Secant& secant) {
    return boundsIn(root, depth, bounds, count, total, secant);
}
[[gnu::target("avx2")]] double boundsAvx2(const double* root, const double* depth, Bounds& bounds,
                                          std::size_t count, double total, const Secant& secant) {
    return boundsIn(root, depth, bounds, count, total, secant);
}

double largestOf(const double* group) {
    const double a = std::max(std::max(group[0], group[1]), std::max(group[2], group[3]));
    const double b = std::max(std::max(group[4], group[5]), std::max(group[6], group[7]));
    return std::max(a, b);
}

const bool hasAvx2 = __builtin_cpu_supports("avx2");

} // namespace

BurnTable::Worst BurnTable::worst(const double* root, const double* depth_mm, std::size_t count,
                                  double totalInfeed_mm, double atLeast, std::size_t guess) const {
    constexpr double tableError = 4e-6; ///< of the secant's ends and of the lane's value
    const auto usageOf = [&](std::size_t lane) {
        return usage(root[lane], totalInfeed_mm - depth_mm[lane]);
    };
    Worst found{atLeast, count};
    const auto look = [&](std::size_t lane) {
        const double used = usageOf(lane);
        if (used > found.usage) {
            found = {used, lane};
        }
    };
    look(std::min(guess, count - 1));
    Bounds bounds;
    for (std::size_t first = 0; first < count; first += blockLanes) {
        const std::size_t lanes = std::min(blockLanes, count - first);
        const double* depth = depth_mm + first;
        const auto [least, most] =
            hasAvx2 ? depthsAvx2(depth, lanes) : depthsBaseline(depth, lanes);
        const double low = std::max(0.0, totalInfeed_mm - most), high = totalInfeed_mm - least;
        Secant secant{usage(1, low) * (1 + tableError), 0, low};
        if (high > low) {
            secant.slope = (usage(1, high) * (1 + tableError) - secant.inverse) / (high - low);
        }
        const double largest =
            hasAvx2 ? boundsAvx2(root + first, depth, bounds, lanes, totalInfeed_mm, secant)
                    : boundsBaseline(root + first, depth, bounds, lanes, totalInfeed_mm, secant);
        for (std::size_t i = 0; largest > found.usage && i < lanes; i += groupLanes) {
            const double* group = bounds.data() + i;
            if (largestOf(group) <= found.usage) {
                continue;
            }
            for (std::size_t j = 0; j < groupLanes; ++j) {
                if (group[j] > found.usage) {
                    look(first + i + j);
                }
            }
        }
    }
    return found.lane < count ? found : Worst{};
}

} // namespace sparkout
