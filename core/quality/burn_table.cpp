// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/burn_table.h"

#include <algorithm>
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
    static constexpr int nodes = 64;
    const BurnModel& m_model;
    double m_U, m_last;
    BurnLimitPoint m_from, m_to;
    int m_node = 0;
};

} // namespace

BurnTable::BurnTable(const BurnModel& model, double U, double deepest_mm)
    : m_deepest(std::max(deepest_mm, 0.0)) {
    constexpr double stepsPerReach = 50; // of heat, 2√(Ωτ) where burning begins
    constexpr double fewest = 16, most = 4096;
    const double reach = model.limitPoint(U, 0).stockSlope_mm;
    const double steps = std::clamp(std::ceil(stepsPerReach * m_deepest / reach), fewest, most);
    m_perStep = m_deepest > 0 ? steps / m_deepest : 0;
    Curve curve(model, U, m_deepest);
    double root = curve.at(0);
    for (double i = 0; i < steps; ++i) {
        const double middle = curve.at(m_deepest * (i + 0.5) / steps);
        const double next = curve.at(m_deepest * (i + 1) / steps);
        const double bend = 2 * (root + next - 2 * middle);
        m_pieces.push_back({root, next - root - bend, bend});
        root = next;
    }
    m_pieces.push_back({root, 0, 0});
}

BurnTable::Worst BurnTable::worst(const double* root, const double* depth_mm, std::size_t count,
                                  double totalInfeed_mm) const {
    Worst found;
    for (std::size_t lane = 0; lane < count; ++lane) {
        const double used = usage(root[lane], totalInfeed_mm - depth_mm[lane]);
        if (used > found.usage) {
            found = {used, lane};
        }
    }
    return found;
}

} // namespace sparkout
