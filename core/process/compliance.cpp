// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/compliance.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>

namespace sparkout {

namespace {

// I = pi d^4/64 [mm^4]
double secondMoment(double d) {
    return std::numbers::pi * d * d * d * d / 64;
}

// Exact for polynomials up to the third degree.
template <class Function>
double simpson(Function f, double a, double b) {
    return b > a ? (b - a) / 6 * (f(a) + 4 * f((a + b) / 2) + f(b)) : 0;
}

} // namespace

Compliance::Compliance(ShaftModel model) : m_model(std::move(model)), m_joints{0.0} {
    assert(!m_model.segments.empty() && m_model.youngsModulus_n_mm2 > 0);
    assert(m_model.wheelHead_n_mm > 0 && m_model.headstock_n_mm > 0);
    assert(m_model.mounting == Mounting::chuck || m_model.tailstock_n_mm > 0);
    for (const BeamSegment& segment : m_model.segments) {
        assert(segment.length_mm > 0 && segment.diameter_mm > 0);
        m_joints.push_back(m_joints.back() + segment.length_mm);
        m_rigidities.push_back(m_model.youngsModulus_n_mm2 * secondMoment(segment.diameter_mm));
    }
    for (const SupportSpring& spring : m_model.rests) {
        assert(spring.stiffness_n_mm >= 0);
        const double p = onShaft(spring.position_mm);
        std::vector<double> row = restTermsAt(p);
        const double free = bare(p, p);
        double pivot = 1 / spring.stiffness_n_mm + free;
        for (const double term : row)
            pivot -= term * term;
        if (pivot > 1e-12 * free) // else the point is already held rigidly: the rest adds nothing
            m_rests.push_back({p, std::sqrt(pivot), std::move(row)});
    }
}

double Compliance::between(double x, double s) const {
    x = onShaft(x);
    s = onShaft(s);
    const std::vector<double> atX = restTermsAt(x);
    const std::vector<double> atS = restTermsAt(s);
    double g = bare(x, s);
    for (std::size_t i = 0; i < m_rests.size(); ++i)
        g -= atX[i] * atS[i];
    return 1 / m_model.wheelHead_n_mm + g;
}

double Compliance::mean(double x, double from, double to) const {
    assert(from <= to);
    x = onShaft(x);
    from = onShaft(from);
    to = onShaft(to);
    if (!(from < to))
        return between(x, from);
    // The rests' terms are linear in g, so their means follow from the means of g.
    std::vector<double> g;
    for (const Rest& rest : m_rests)
        g.push_back(bareMean(rest.position, from, to));
    const std::vector<double> means = restTerms(std::move(g));
    const std::vector<double> atX = restTermsAt(x);
    double gamma = bareMean(x, from, to);
    for (std::size_t i = 0; i < m_rests.size(); ++i)
        gamma -= atX[i] * means[i];
    return 1 / m_model.wheelHead_n_mm + gamma;
}

ComplianceParts Compliance::partsAt(double x) const {
    x = onShaft(x);
    const bool centres = m_model.mounting == Mounting::centres;
    const double share = centres ? x / length() : 0; // of the force that the tailstock carries
    ComplianceParts parts;
    parts.wheelHead = 1 / m_model.wheelHead_n_mm;
    parts.headstock = (1 - share) * (1 - share) / m_model.headstock_n_mm;
    parts.tailstock = centres ? share * share / m_model.tailstock_n_mm : 0;
    parts.bending = bending(x, x);
    for (const double term : restTermsAt(x))
        parts.rests -= term * term;
    return parts;
}

// Sums of lengths may miss the end of the shaft by rounding; anything more is a bug of the caller.
double Compliance::onShaft(double x) const {
    assert(x >= -1e-9 * length() && x <= (1 + 1e-9) * length());
    return std::clamp(x, 0.0, length());
}

// M_x(xi), bending moment at xi from a unit force at x [mm]
double Compliance::moment(double xi, double x) const {
    const double L = length();
    return m_model.mounting == Mounting::centres ? std::min(xi, x) * (L - std::max(xi, x)) / L
                                                 : std::max(0.0, x - xi);
}

// G_beam(x,s) = integral of M_x(xi) M_s(xi)/(E I(xi)) d xi, broken at the joints, x and s
double Compliance::bending(double x, double s) const {
    const auto work = [&](double xi) { return moment(xi, x) * moment(xi, s); };
    double sum = 0;
    for (std::size_t i = 0; i < m_rigidities.size(); ++i) {
        const double from = m_joints[i];
        const double to = m_joints[i + 1];
        const double first = std::clamp(std::min(x, s), from, to);
        const double second = std::clamp(std::max(x, s), from, to);
        const double part =
            simpson(work, from, first) + simpson(work, first, second) + simpson(work, second, to);
        sum += part / m_rigidities[i];
    }
    return sum;
}

// g(x,s): the shaft on its supports, without rests and wheel head
double Compliance::bare(double x, double s) const {
    if (m_model.mounting == Mounting::chuck)
        return 1 / m_model.headstock_n_mm + bending(x, s);
    const double u = x / length();
    const double v = s / length();
    return (1 - u) * (1 - v) / m_model.headstock_n_mm + u * v / m_model.tailstock_n_mm
           + bending(x, s);
}

// The mean of bare(x,s) over from <= s <= to, broken at the joints and x
double Compliance::bareMean(double x, double from, double to) const {
    const auto g = [&](double s) { return bare(x, s); };
    double sum = 0;
    for (std::size_t i = 0; i < m_rigidities.size(); ++i) {
        const double first = std::clamp(from, m_joints[i], m_joints[i + 1]);
        const double last = std::clamp(to, m_joints[i], m_joints[i + 1]);
        const double middle = std::clamp(x, first, last);
        sum += simpson(g, first, middle) + simpson(g, middle, last);
    }
    return sum / (to - from);
}

// From g(x,p_i) the terms f_i(x) with which the rests make g(x,s) into g(x,s) - sum of f_i(x)
// f_i(s): the rank-one updates one after the other, written as a forward substitution.
std::vector<double> Compliance::restTerms(std::vector<double> g) const {
    for (std::size_t i = 0; i < m_rests.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j)
            g[i] -= m_rests[i].row[j] * g[j];
        g[i] /= m_rests[i].pivot;
    }
    return g;
}

std::vector<double> Compliance::restTermsAt(double x) const {
    std::vector<double> g;
    for (const Rest& rest : m_rests)
        g.push_back(bare(x, rest.position));
    return restTerms(std::move(g));
}

double quillCompliance(double length_mm, double diameter_mm, double youngsModulus_n_mm2,
                       double wheelHead_n_mm, double headstock_n_mm) {
    assert(length_mm >= 0 && diameter_mm > 0 && youngsModulus_n_mm2 > 0 && wheelHead_n_mm > 0
           && headstock_n_mm > 0);
    const double L = length_mm;
    return 1 / wheelHead_n_mm + 1 / headstock_n_mm
           + L * L * L / (3 * youngsModulus_n_mm2 * secondMoment(diameter_mm));
}

} // namespace sparkout
