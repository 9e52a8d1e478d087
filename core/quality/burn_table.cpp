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

BurnTable::Worst BurnTable::worst(const double* root, const double* depth_mm, std::size_t count,
                                  double totalInfeed_mm, double atLeast) const {
    double most = 0;
    for (std::size_t lane = 0; lane < count; ++lane) {
        const double used = usage(root[lane], totalInfeed_mm - depth_mm[lane]);
        most = used > most ? used : most;
    }
    if (!(most > atLeast)) {
        return {};
    }
    std::size_t lane = 0;
    while (lane + 1 < count && usage(root[lane], totalInfeed_mm - depth_mm[lane]) != most) {
        ++lane;
    }
    return {most, lane};
}

} // namespace sparkout
