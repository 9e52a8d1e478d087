// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/contact_compliance.h"

#include "core/project/machine.h"
#include "core/units.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

/// Puts each lane of the range into the state found by `stateOf`; returns the largest √a.
template <class StateOf>
double cutEach(Lanes& lanes, const PassRange& range, const StateOf& stateOf) {
    double largest = 0;
    for (std::size_t lane = range.first; lane < range.first + range.count; ++lane) {
        const ThresholdState state = stateOf(lane);
        putState(lanes, lane, state);
        largest = std::max(largest, state.root);
    }
    return largest;
}

} // namespace

ThresholdState thresholdState(double C, double A4, double h) {
    if (h > C) {
        return {std::sqrt(4 * (h - C) / A4), h > 0 ? 1.0 : 0.0};
    }
    return {0, h > 0 ? h / C : 0};
}

void putState(Lanes& lanes, std::size_t lane, const ThresholdState& state) {
    const auto [u, v] = state;
    lanes.depth_mm[lane] += u * u;
    lanes.root[lane] = u;
    lanes.rubbing[lane] = v;
    lanes.rootSum[lane] += v;
    lanes.peakRoot[lane] = std::max(lanes.peakRoot[lane], u);
    lanes.peakRubbing[lane] = std::max(lanes.peakRubbing[lane], v);
}

double cutWithThreshold(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& feed,
                        const PassRange& range) {
    return cutEach(lanes, range, [&](std::size_t lane) {
        const double h = std::max(0.0, lanes.wheelAt(lane, feed) - lanes.depth_mm[lane]);
        return thresholdState(coefficients.C[lane], coefficients.A4[lane], h);
    });
}

double cutAsGiven(Lanes& lanes, const LaneCoefficients& coefficients, const PassFeed& /*feed*/,
                  const PassRange& range) {
    return cutEach(lanes, range, [&](std::size_t lane) {
        return ThresholdState{std::sqrt(coefficients.C2[lane]), coefficients.C[lane]};
    });
}

ContactCompliance::ContactCompliance(const std::vector<std::vector<double>>& n_um_at_n) {
    assert(!n_um_at_n.empty());
    m_rows.push_back({.stiffness = n_um_at_n.front()[1] * units::umPerMm});
    for (const std::vector<double>& given : n_um_at_n) {
        Row row{.force = given[0], .stiffness = given[1] * units::umPerMm};
        Row& last = m_rows.back();
        if (row.force > last.force) {
            last.rise = (row.stiffness - last.stiffness) / (row.force - last.force);
            row.deflection = deflection(row.force);
            m_rows.push_back(row);
        }
    }
    m_rows.back().rise = 0;
}

const ContactCompliance::Row& ContactCompliance::rowBefore(double force_n) const {
    const auto next = std::upper_bound(m_rows.begin() + 1, m_rows.end(), force_n,
                                       [](double F, const Row& row) { return F < row.force; });
    return *(next - 1);
}

double ContactCompliance::deflection(double force_n) const {
    const Row& row = rowBefore(force_n);
    const double straight = (force_n - row.force) / row.stiffness;
    const double x = row.rise * straight;
    return row.deflection + (x == 0 ? straight : straight * (std::log1p(x) / x));
}

double ContactCompliance::compliance(double force_n) const {
    const Row& row = rowBefore(force_n);
    return 1 / (row.stiffness + row.rise * (force_n - row.force));
}

double ContactCompliance::cut(Lanes& lanes, const LaneCoefficients& coefficients,
                              const PassFeed& feed, const PassRange& range) const {
    double largest = 0;
    for (std::size_t lane = range.first; lane < range.first + range.count; ++lane) {
        const double h = std::max(0.0, lanes.wheelAt(lane, feed) - lanes.depth_mm[lane]);
        const Balance balance{.A = coefficients.A4[lane] / 4,
                              .C = coefficients.C[lane],
                              .bks = range.bks,
                              .bkr = range.bkr};
        const double u = root(balance, h, lanes.root[lane]);
        lanes.depth_mm[lane] += u * u;
        lanes.root[lane] = u;
        lanes.rootSum[lane] += u;
        lanes.peakRoot[lane] = std::max(lanes.peakRoot[lane], u);
        largest = std::max(largest, u);
    }
    return largest;
}

double ContactCompliance::cutWithThreshold(Lanes& lanes, const LaneCoefficients& coefficients,
                                           const PassFeed& feed, const PassRange& range) const {
    double largest = 0;
    for (std::size_t lane = range.first; lane < range.first + range.count; ++lane) {
        const double h = std::max(0.0, lanes.wheelAt(lane, feed) - lanes.depth_mm[lane]);
        const ThresholdState found = state({.A = coefficients.A4[lane] / 4,
                                            .C = coefficients.C[lane],
                                            .bks = range.bks,
                                            .bkr = range.bkr},
                                           h);
        putState(lanes, lane, found);
        largest = std::max(largest, found.root);
    }
    return largest;
}

// The left side rises with x, which is v, up to 1, below the threshold and a, from 0 on, above it.
// Its slope is at least that of the rigid contact, so the root lies between 0 and that of the rigid
// contact.
ThresholdState ContactCompliance::state(const Balance& balance, double h) const {
    const auto& [A, C, bks, bkr] = balance;
    if (h <= 0) {
        return {};
    }
    const double force_n = bkr, atThreshold = C + deflection(force_n);
    const bool cuts = h > atThreshold;
    const double stiff = cuts ? A : C, perForce = cuts ? bks : bkr;
    const auto lag = [&](double x) {
        return cuts ? atThreshold + stiff * x + deflection(force_n + perForce * x)
                          - deflection(force_n)
                    : stiff * x + deflection(perForce * x);
    };
    double low = 0, high = cuts ? (h - atThreshold) / stiff : 1;
    double x = high;
    const double enough = 2 * std::numeric_limits<double>::epsilon() * h;
    constexpr int mostSteps = 200, usualSteps = 20; // as in root()
    for (int step = 0; step < mostSteps; ++step) {
        const double rest = lag(x) - h;
        if (std::abs(rest) <= enough) {
            break;
        }
        (rest > 0 ? high : low) = x;
        const double force = (cuts ? force_n : 0) + perForce * x;
        const bool creeps = step > usualSteps && step % 2 == 0;
        double next = x - rest / (stiff + perForce * compliance(force));
        if (creeps || !(next > low && next < high)) {
            next = low + (high - low) / 2;
        }
        if (next == low || next == high || next == x) {
            break; // neighbouring numbers
        }
        x = next;
    }
    return cuts ? ThresholdState{std::sqrt(x), 1} : ThresholdState{0, x};
}

double ContactCompliance::root(const Balance& balance, double h, double from) const {
    const auto& [A, C, bks, bkr] = balance;
    if (h <= 0) {
        return 0;
    }
    double low = 0;
    double high = 2 * h / (C + std::sqrt(C * C + 4 * A * h)); // root without the contact
    double u = from > 0 && from < high ? from : high;
    const double enough = 2 * std::numeric_limits<double>::epsilon() * h;
    constexpr int mostSteps = 200;
    constexpr int usualSteps = 20; // where a stiffness changes, Newton's method may oscillate; then
                                   // every other step bisects
    for (int step = 0; step < mostSteps; ++step) {
        const double force = (bks * u + bkr) * u;
        const double rest = (A * u + C) * u + deflection(force) - h;
        if (std::abs(rest) <= enough) {
            break;
        }
        (rest > 0 ? high : low) = u;
        const double slope = 2 * A * u + C + compliance(force) * (2 * bks * u + bkr);
        double next = u - rest / slope;
        if (!(next > low && next < high) || (step > usualSteps && step % 2 == 0)) {
            next = low + (high - low) / 2;
        }
        if (next == low || next == high || next == u) {
            break; // neighbouring numbers
        }
        u = next;
    }
    return u;
}

std::optional<ContactCompliance> wheelContact(const Project& project) {
    const auto& contact = project.machine->wheel_contact;
    if (!contact || !contact->n_um_at_n) {
        return std::nullopt;
    }
    return ContactCompliance(*contact->n_um_at_n);
}

} // namespace sparkout
