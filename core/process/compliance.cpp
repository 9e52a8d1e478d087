// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/compliance.h"

#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"

#include <Eigen/Core>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout {

namespace {

void divideStiffness(Project& project, double factor) {
    if (auto& stiffness = project.machine->stiffness_n_um) {
        stiffness->headstock /= factor;
        stiffness->tailstock /= factor;
        stiffness->wheel_head /= factor;
    }
    project.part->shaft.youngs_modulus_gpa /= factor;
    for (SteadyRest& rest : project.part->shaft.steady_rests) {
        rest.stiffness_n_um /= factor;
    }
}

} // namespace

void scaleCompliance(Project& project, double factor) {
    Machine& machine = *project.machine;
    if (auto* const zones = std::get_if<ZoneCompliance>(&machine.compliance_mm_per_n)) {
        *zones = {zones->rz1 * factor, zones->nz * factor, zones->rz2 * factor};
    } else if (auto* const sections =
                   std::get_if<std::vector<double>>(&machine.compliance_mm_per_n)) {
        for (double& gamma : *sections) {
            gamma *= factor;
        }
    } else {
        divideStiffness(project, factor);
    }
    if (machine.wheel_contact && machine.wheel_contact->n_um_at_n) {
        for (std::vector<double>& row : *machine.wheel_contact->n_um_at_n) {
            row[1] /= factor;
        }
    }
    if (project.gauge->compliance_mm_per_n) {
        *project.gauge->compliance_mm_per_n *= factor;
    }
}

double sumOf(const ComplianceParts& parts) {
    double sum = 0;
    for (const CompliancePart part : allComplianceParts) {
        sum += valueOf(parts, part);
    }
    return sum;
}

double valueOf(const ComplianceParts& parts, CompliancePart part) {
    switch (part) {
    case CompliancePart::wheelHead: return parts.wheelHead;
    case CompliancePart::headstock: return parts.headstock;
    case CompliancePart::tailstock: return parts.tailstock;
    case CompliancePart::bending: return parts.bending;
    case CompliancePart::rests: return parts.rests;
    }
    return 0;
}

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

// The product of the leading numbers of both vectors.
double product(const std::vector<double>& a, const std::vector<double>& b, std::size_t count) {
    using Numbers = Eigen::Map<const Eigen::VectorXd>;
    const auto n = static_cast<Eigen::Index>(count);
    return Numbers(a.data(), n).dot(Numbers(b.data(), n));
}

/// Limit of segments times rests for separate summation.
constexpr std::size_t mostSingly = 256;
/// Limit of places on either side of G for separate summation.
constexpr std::size_t fewPlaces = 4;

} // namespace

/// The bending of the shaft along its length under a unit force, spread evenly over from...to or at
/// one point, by running sums (see the class).
class Compliance::BentLine {
public:
    BentLine(const Compliance& shaft, double from, double to)
        : m_centres(shaft.m_model.mounting == Mounting::centres)
        , m_L(shaft.length())
        , m_from(from)
        , m_to(to) {
        m_at.reserve(shaft.m_joints.size() + 2);
        m_rigidities.reserve(shaft.m_joints.size() + 2);
        for (std::size_t i = 0; i < shaft.m_rigidities.size(); ++i) {
            const double begin = shaft.m_joints[i];
            const double end = shaft.m_joints[i + 1];
            double at = begin;
            for (const double next :
                 {std::clamp(from, begin, end), std::clamp(to, begin, end), end}) {
                if (next > at) {
                    m_at.push_back(at);
                    m_rigidities.push_back(shaft.m_rigidities[i]);
                    at = next;
                }
            }
        }
        m_at.push_back(m_L);
        m_before.assign(m_at.size(), 0.0);
        m_other.assign(m_at.size(), 0.0);
        const std::size_t pieces = m_rigidities.size();
        for (std::size_t i = 0; i < pieces; ++i) {
            m_before[i + 1] = before(i, m_at[i + 1]);
            if (!m_centres) {
                m_other[i + 1] = height(i, m_at[i + 1]);
            }
        }
        for (std::size_t i = pieces; m_centres && i-- > 0;) {
            m_other[i] = behind(i, m_at[i]);
        }
    }

    double at(double x) const {
        const auto next = std::upper_bound(m_at.begin() + 1, m_at.end() - 1, x);
        const auto i = static_cast<std::size_t>(next - m_at.begin()) - 1;
        return m_centres ? (m_L - x) / m_L * before(i, x) + x / m_L * behind(i, x) : height(i, x);
    }

private:
    double moment(double xi) const {
        const double middle = (m_from + m_to) / 2;
        const double spread = m_to - m_from;
        if (m_centres) {
            if (xi <= m_from)
                return xi * (m_L - middle) / m_L;
            if (xi >= m_to)
                return (m_L - xi) * middle / m_L;
            return ((xi - m_from) * (xi + m_from) * (m_L - xi)
                    + xi * (m_to - xi) * (2 * m_L - xi - m_to))
                   / (2 * m_L * spread);
        }
        if (xi <= m_from)
            return middle - xi;
        return xi >= m_to ? 0 : (m_to - xi) * (m_to - xi) / (2 * spread);
    }
    // Up to x in piece i. Centres: the integral of xi M/(E I); chuck: the integral of M/(E I), the
    // slope.
    double before(std::size_t i, double x) const {
        const auto work = [&](double xi) { return (m_centres ? xi : 1) * moment(xi); };
        return m_before[i] + simpson(work, m_at[i], x) / m_rigidities[i];
    }
    double behind(std::size_t i, double x) const {
        const auto work = [&](double xi) { return (m_L - xi) * moment(xi); };
        return m_other[i + 1] + simpson(work, x, m_at[i + 1]) / m_rigidities[i];
    }
    double height(std::size_t i, double x) const {
        const auto work = [&](double xi) { return (x - xi) * moment(xi); };
        return m_other[i] + m_before[i] * (x - m_at[i])
               + simpson(work, m_at[i], x) / m_rigidities[i];
    }

    bool m_centres;
    double m_L, m_from, m_to;
    std::vector<double> m_at, m_rigidities; // ends of pieces; of each piece
    std::vector<double> m_before, m_other;  // at the ends; centres: behind, chuck: height
};

Compliance::Compliance(ShaftModel model, const std::stop_token& stop)
    : m_model(std::move(model)), m_joints{0.0} {
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
        if (stop.stop_requested()) {
            break;
        }
        const double p = onShaft(spring.position_mm);
        std::vector<double> row = restTermsAt(p);
        const double free = bare(p, p);
        double pivot = 1 / spring.stiffness_n_mm + free;
        for (const double term : row)
            pivot -= term * term;
        if (pivot > 1e-12 * free) // otherwise it is rigid: the rest adds nothing
            m_rests.push_back({p, std::sqrt(pivot), std::move(row)});
    }
}

double Compliance::between(double x, double s) const {
    x = onShaft(x);
    s = onShaft(s);
    return with(restTermsAt(x), restTermsAt(s), bare(x, s));
}

std::vector<double> Compliance::rows(const std::vector<double>& at, const std::vector<double>& from,
                                     const std::stop_token& stop) const {
    const auto terms = [this, &stop](const std::vector<double>& places) {
        std::vector<std::vector<double>> all;
        for (const double place : places) {
            if (stop.stop_requested())
                break;
            all.push_back(restTermsAt(onShaft(place)));
        }
        return all;
    };
    // The bending at each place under a load at each place before it.
    const bool isSymmetric = at == from;
    const bool byLines = isLarge() || std::min(at.size(), from.size()) > fewPlaces;
    const auto linesUnder = [&](const std::vector<double>& places) {
        std::vector<BentLine> lines;
        for (const double place : places) {
            if (!byLines || stop.stop_requested())
                break;
            lines.emplace_back(*this, onShaft(place), onShaft(place));
        }
        return lines;
    };
    const std::vector<BentLine> underAt = linesUnder(at);
    const std::vector<BentLine> underFrom = linesUnder(isSymmetric ? std::vector<double>() : from);
    const auto bareAt = [&](std::size_t i, std::size_t j) {
        const double x = onShaft(at[i]);
        const double s = onShaft(from[j]);
        if (!byLines)
            return bare(x, s);
        const BentLine& line = x < s ? underAt[i] : isSymmetric ? underAt[j] : underFrom[j];
        return springs(x, s) + line.at(std::max(x, s));
    };
    const std::vector<std::vector<double>> atEach = terms(at);
    const std::vector<std::vector<double>> fromEach = terms(from);
    std::vector<double> G(at.size() * from.size()); // 0 where stopped
    for (std::size_t i = 0; i < at.size() && !stop.stop_requested(); ++i) {
        for (std::size_t j = 0; j < (isSymmetric ? i + 1 : from.size()); ++j) {
            const double g = with(atEach[i], fromEach[j], bareAt(i, j));
            G[i * from.size() + j] = g;
            if (isSymmetric)
                G[j * from.size() + i] = g;
        }
    }
    return G;
}

// The complete g at two places, including the terms of the rests.
double Compliance::with(const std::vector<double>& atX, const std::vector<double>& atS,
                        double g) const {
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
    double gamma = 0;
    if (isLarge()) {
        const BentLine line(*this, from, to);
        const double middle = from + (to - from) / 2;
        for (const Rest& rest : m_rests)
            g.push_back(springs(rest.position, middle) + line.at(rest.position));
        gamma = springs(x, middle) + line.at(x);
    } else {
        for (const Rest& rest : m_rests)
            g.push_back(bareMean(rest.position, from, to));
        gamma = bareMean(x, from, to);
    }
    const std::vector<double> means = restTerms(std::move(g));
    return with(restTermsAt(x), means, gamma);
}

ComplianceParts Compliance::partsAt(double x) const {
    x = onShaft(x);
    const bool centres = m_model.mounting == Mounting::centres;
    const double share = centres ? x / length() : 0; // share of the force carried by the tailstock
    ComplianceParts parts;
    parts.wheelHead = 1 / m_model.wheelHead_n_mm;
    parts.headstock = (1 - share) * (1 - share) / m_model.headstock_n_mm;
    parts.tailstock = centres ? share * share / m_model.tailstock_n_mm : 0;
    parts.bending = bending(x, x);
    for (const double term : restTermsAt(x))
        parts.rests -= term * term;
    return parts;
}

// Sums of lengths may miss the end of the shaft by rounding; a larger error is a bug of the caller.
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
    if (isLarge()) {
        const double load = std::min(x, s);
        return springs(x, s) + BentLine(*this, load, load).at(std::max(x, s));
    }
    return springs(x, s) + bending(x, s);
}

double Compliance::springs(double x, double s) const {
    if (m_model.mounting == Mounting::chuck)
        return 1 / m_model.headstock_n_mm;
    const double u = x / length();
    const double v = s / length();
    return (1 - u) * (1 - v) / m_model.headstock_n_mm + u * v / m_model.tailstock_n_mm;
}

bool Compliance::isLarge() const {
    return m_rigidities.size() * std::max<std::size_t>(m_model.rests.size(), 4) > mostSingly;
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
    const bool large = isLarge();
    for (std::size_t i = 0; i < m_rests.size(); ++i) {
        if (large) {
            g[i] -= product(m_rests[i].row, g, i);
        }
        for (std::size_t j = 0; j < i && !large; ++j)
            g[i] -= m_rests[i].row[j] * g[j];
        g[i] /= m_rests[i].pivot;
    }
    return g;
}

std::vector<double> Compliance::restTermsAt(double x) const {
    std::vector<double> g;
    if (isLarge() && !m_rests.empty()) {
        const BentLine line(*this, x, x);
        for (const Rest& rest : m_rests)
            g.push_back(springs(x, rest.position) + line.at(rest.position));
    } else {
        for (const Rest& rest : m_rests)
            g.push_back(bare(x, rest.position));
    }
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
