// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/process/coupled_sections.h"

#include "core/process/section_influence.h"

#include <Eigen/Core>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

using Eigen::ArrayXd;
using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;
using MapConst = Eigen::Map<const ArrayXd>;

Eigen::Map<const VectorXd> mapped(const std::vector<double>& values) {
    return {values.data(), static_cast<Index>(values.size())};
}

} // namespace

class CoupledSections::Solver {
public:
    Solver(const std::vector<double>& influence, const std::vector<double>& widths,
           const ForceLaw& law, std::optional<ContactCompliance> contact)
        : m_count(mapped(widths).size())
        , m_law(law)
        , m_contact(std::move(contact))
        , m_width(mapped(widths))
        , m_wholeWidth(m_width.sum())
        , m_influence(influence, widths.size())
        , m_own(mapped(influence).reshaped(m_count, m_count).diagonal())
        , m_gamma((mapped(influence).reshaped(m_count, m_count) * mapped(widths)).cwiseMax(0))
        , m_now(m_count)
        , m_next(m_count)
        , m_step(m_count)
        , m_reduced(m_count)
        , m_gap(m_count)
        , m_added(m_count)
        , m_direction(m_count)
        , m_all(widths.size())
        , m_free(widths.size()) {
        std::iota(m_all.begin(), m_all.end(), Index{0});
    }

    Outcome solve(const double* lag_mm, double* root, const std::stop_token& stop, double* rubbing);
    void begin(const MapConst& h, Eigen::Ref<ArrayXd> u) const;
    [[nodiscard]] const SectionInfluence& influence() const { return m_influence; }
    [[nodiscard]] Index count() const { return m_count; }

private:
    /// An iterate and the values derived from it.
    struct Point {
        explicit Point(Index count) : f(count), u(count), w(count), r(count) {}
        VectorXd f;          ///< slice forces [N]
        ArrayXd u;           ///< √a [√mm]
        ArrayXd w;           ///< a + δ_c [mm]
        ArrayXd r;           ///< w + G·f − h [mm]
        double residual = 0; ///< largest |min(w + G_jj·f, r)| [mm]
    };

    [[nodiscard]] Eigen::Map<const VectorXd> influenceOf(Index j) const {
        return {m_influence.of(static_cast<std::size_t>(j)), m_count};
    }
    void start(const MapConst& h, const double* root);
    void startTouching(const MapConst& h, const double* root, const double* rubbing);
    void rootsOf(Point& point) const;
    [[nodiscard]] double ownForce(Index j, double left) const;
    void evaluate(Point& point, const MapConst& h) const;
    [[nodiscard]] double contactForce(Index j, double f) const;
    [[nodiscard]] double slope(Index j, double u, double f) const;
    [[nodiscard]] double ownDepth(const Point& point, Index j) const;
    void newtonStep();
    int interiorSteps(const MapConst& h, const std::stop_token& stop);
    double interiorStep(double mu);
    int descend(const MapConst& h, double enough, int mostSteps, const std::stop_token& stop);
    void sweep(const MapConst& h);
    void descentDirection();
    bool searchAlong(const MapConst& h);
    void moveTo(double share, double whole, const MapConst& h);
    [[nodiscard]] double slopeAlong() const;
    [[nodiscard]] double freeResidual() const;

    Index m_count;
    ForceLaw m_law;
    std::optional<ContactCompliance> m_contact;
    ArrayXd m_width;
    double m_wholeWidth;
    SectionInfluence m_influence;
    ArrayXd m_own; ///< G_jj
    /// Σ_l G_jl·Δx_l; 0 where neighbours push a section towards the wheel, since it has no balance
    /// of its own.
    ArrayXd m_gamma;
    Point m_now, m_next;
    VectorXd m_step, m_reduced;
    ArrayXd m_gap;        ///< z, which becomes r where it is positive [mm]
    VectorXd m_added;     ///< D of a step
    VectorXd m_direction; ///< direction of a descent
    std::vector<Index> m_all, m_free;
};

CoupledSections::Outcome CoupledSections::Solver::solve(const double* lag_mm, double* root,
                                                        const std::stop_token& stop,
                                                        double* rubbing) {
    assert(m_law.threshold == (rubbing != nullptr));
    const MapConst h(lag_mm, m_count);
    constexpr double epsilon = std::numeric_limits<double>::epsilon();
    const double enough =
        tolerance_mm + 4 * epsilon * static_cast<double>(m_count) * std::max(0.0, h.maxCoeff());
    Outcome outcome;
    if (!h.allFinite()) { // comparisons below would miss NaN
        outcome.residual_mm = std::numeric_limits<double>::infinity();
        return outcome;
    }
    if (rubbing) {
        startTouching(h, root, rubbing);
    } else {
        start(h, root);
    }
    evaluate(m_now, h);
    while (!(m_now.residual <= enough) && outcome.iterations < maxIterations
           && !stop.stop_requested()) {
        ++outcome.iterations;
        newtonStep();
        evaluate(m_next, h);
        if (!(m_next.residual <= m_now.residual / 2)) {
            outcome.iterations += interiorSteps(h, stop);
            if (!(m_next.residual < m_now.residual)) {
                break;
            }
        }
        std::swap(m_now, m_next);
    }
    if (!(m_now.residual <= enough)) {
        outcome.iterations += descend(h, enough, maxDescents, stop);
    }
    Eigen::Map<ArrayXd>(root, m_count) = m_now.u;
    for (Index j = 0; rubbing && j < m_count; ++j) {
        const double f = m_now.f[j], most = m_width[j] * m_law.kr;
        rubbing[j] = f < most ? f / most : f > 0 ? 1 : 0;
    }
    outcome.residual_mm = m_now.residual;
    outcome.converged = m_now.residual <= enough;
    return outcome;
}

void CoupledSections::Solver::start(const MapConst& h, const double* root) {
    m_now.u = MapConst(root, m_count).max(0);
    if ((m_now.u == 0).all()) {
        begin(h, m_now.u);
    }
    m_now.f = m_width * m_now.u * (m_law.ks * m_now.u + m_law.kr);
}

// Starts from the last revolution's forces, or with each section in its own balance.
void CoupledSections::Solver::startTouching(const MapConst& h, const double* root,
                                            const double* rubbing) {
    const MapConst v(rubbing, m_count);
    if ((v > 0).any()) {
        m_now.f = m_width * (m_law.ks * MapConst(root, m_count).square() + m_law.kr * v);
        return;
    }
    for (Index j = 0; j < m_count; ++j) {
        const double C = m_gamma[j] * m_law.kr;
        const double a = std::max(0.0, h[j] - C) / (1 + m_gamma[j] * m_law.ks);
        const double share = h[j] <= 0 ? 0 : h[j] < C ? h[j] / C : 1;
        m_now.f[j] = m_width[j] * (m_law.ks * a + m_law.kr * share);
    }
}

void CoupledSections::Solver::begin(const MapConst& h, Eigen::Ref<ArrayXd> u) const {
    for (Index j = 0; j < m_count; ++j) {
        const double C = m_gamma[j] * m_law.kr;
        const double q = std::sqrt(C * C + 4 * (1 + m_gamma[j] * m_law.ks) * std::max(0.0, h[j]));
        u[j] = h[j] > 0 ? 2 * h[j] / (C + q) : 0;
    }
}

// u is the root of k_s·u² + k_r·u = p; with a threshold of K·u² + F'_0 = p, or 0.
void CoupledSections::Solver::rootsOf(Point& point) const {
    const double ks = m_law.ks;
    const double kr = m_law.kr;
    if (m_law.threshold) {
        point.u = ((point.f.array() / m_width - kr) / ks).max(0).sqrt();
    } else if (kr > 0) {
        point.u = point.f.array() / m_width;
        point.u = 2 * point.u / (kr + (kr * kr + 4 * ks * point.u).sqrt());
    } else { // avoids 0/0 without pressure
        point.u = (point.f.array() / m_width / ks).sqrt();
    }
}

void CoupledSections::Solver::evaluate(Point& point, const MapConst& h) const {
    rootsOf(point);
    point.w = point.u.square();
    for (Index j = 0; m_contact && j < m_count; ++j) {
        point.w[j] += m_contact->deflection(contactForce(j, point.f[j]));
    }
    m_influence.multiply(point.f.data(), point.r.data());
    point.r += point.w - h;
    point.residual = (point.w + m_own * point.f.array()).min(point.r).abs().maxCoeff();
    if (!point.r.allFinite() || !point.u.allFinite()) { // Eigen's comparisons ignore NaN
        point.residual = std::numeric_limits<double>::infinity();
    }
}

// P_j, the force of the whole width at the section's pressure.
double CoupledSections::Solver::contactForce(Index j, double f) const {
    return f * m_wholeWidth / m_width[j];
}

// dw/df at u = √a; 0 for a section about to touch, and for one that touches below the threshold,
// which a singular G would not allow.
double CoupledSections::Solver::slope(Index j, double u, double f) const {
    double dw = 0;
    if (m_law.threshold) {
        dw = u > 0 || m_law.kr == 0 ? 1 / m_law.ks : 0;
    } else {
        dw = m_law.kr > 0 ? 2 * u / (2 * m_law.ks * u + m_law.kr) : 1 / m_law.ks;
    }
    if (m_contact) {
        dw += m_wholeWidth * m_contact->compliance(contactForce(j, f));
    }
    return std::max(dw / m_width[j], 1e-9 * m_own[j]);
}

// w + G_jj·f: the depth of a section that loses contact.
double CoupledSections::Solver::ownDepth(const Point& point, Index j) const {
    return point.w[j] + m_own[j] * point.f[j];
}

// Newton's step on min(w + G_jj·f, r) = 0: where the first is the smaller, the section loses
// contact.
void CoupledSections::Solver::newtonStep() {
    m_free.clear();
    m_step.setZero();
    for (Index j = 0; j < m_count; ++j) {
        if (ownDepth(m_now, j) >= m_now.r[j]) {
            m_free.push_back(j);
            m_added[j] = slope(j, m_now.u[j], m_now.f[j]);
        } else {
            m_step[j] = -m_now.f[j];
        }
    }
    if (m_free.size() == m_all.size()) {
        m_reduced = -m_now.r;
    } else {
        m_influence.multiply(m_step.data(), m_reduced.data());
        m_reduced = -m_now.r.matrix() - m_reduced;
    }
    m_influence.solve(m_added.data(), m_free, m_reduced.data());
    m_step += m_reduced; // sections that lose contact are not part of the solution
    m_next.f = (m_now.f + m_step).cwiseMax(0);
}

// Follows f·z = μ for all sections, z → r ≥ 0, into the solution as μ → 0. Steps are damped so that
// f and z stay positive; D is taken at the depth a section has yet to reach, since at u = 0 it
// vanishes. The result, in m_next, is refined by the next Newton steps. Returns the number of
// steps.
int CoupledSections::Solver::interiorSteps(const MapConst& h, const std::stop_token& stop) {
    constexpr int mostSteps = 60;
    constexpr double nearEnough_mm = 1e-11;
    m_next.f = m_now.f.cwiseMax(std::max(1e-2 * m_now.f.mean(), 1e-12));
    evaluate(m_next, h);
    m_gap = m_next.r.max(m_now.residual / 10);
    double centring = 0.2;
    int steps = 0;
    for (; steps < mostSteps && !stop.stop_requested(); ++steps) {
        const double mu = (m_next.f.array() * m_gap).mean();
        double worst = (m_next.r - m_gap).abs().maxCoeff();
        for (Index j = 0; j < m_count; ++j) {
            worst = std::max(worst, std::min(ownDepth(m_next, j), m_gap[j]));
        }
        if (worst < nearEnough_mm) {
            break;
        }
        const double share = interiorStep(centring * mu);
        evaluate(m_next, h);
        centring = share > 0.9 ? 0.02 : share > 0.5 ? 0.2 : 0.5;
    }
    for (Index j = 0; j < m_count; ++j) {
        if (ownDepth(m_next, j) < m_gap[j]) {
            m_next.f[j] = 0;
        }
    }
    evaluate(m_next, h);
    return steps;
}

// One step towards f·z = μ; returns the share of it that keeps both positive.
double CoupledSections::Solver::interiorStep(double mu) {
    for (Index j = 0; j < m_count; ++j) {
        const double lack = std::max(0.0, m_gap[j] - m_next.r[j]);
        const double u = std::sqrt(m_next.u[j] * m_next.u[j] + lack / 4);
        m_added[j] = slope(j, u, m_next.f[j]) + m_gap[j] / m_next.f[j];
        m_step[j] = -m_next.r[j] + mu / m_next.f[j];
    }
    m_influence.solve(m_added.data(), m_all, m_step.data());
    double share = 1;
    for (Index j = 0; j < m_count; ++j) {
        const double f = m_next.f[j];
        m_reduced[j] = mu / f - m_gap[j] - m_gap[j] / f * m_step[j];
        share = std::min({share, m_step[j] < 0 ? -0.95 * f / m_step[j] : 1,
                          m_reduced[j] < 0 ? -0.95 * m_gap[j] / m_reduced[j] : 1});
    }
    m_next.f += share * m_step;
    m_gap += share * m_reduced.array();
    return share;
}

// From m_now to the minimum of Ψ: sweeps, each followed by Newton's steps to the minimum over the
// sections that then cut. Neither raises Ψ. Returns the number of steps.
int CoupledSections::Solver::descend(const MapConst& h, double enough, int mostSteps,
                                     const std::stop_token& stop) {
    m_now.f = m_now.f.array().isFinite().select(m_now.f.array(), 0).max(0).matrix();
    int steps = 0;
    while (steps < mostSteps && !stop.stop_requested()) {
        sweep(h);
        evaluate(m_now, h);
        constexpr int mostInRow = 50;
        for (int step = 0; step < mostInRow && steps < mostSteps; ++step) {
            if (m_now.residual <= enough || stop.stop_requested()) {
                return steps;
            }
            ++steps;
            descentDirection();
            if (!searchAlong(h) || freeResidual() <= enough / 4) {
                break;
            }
        }
        if (m_now.residual <= enough) { // the next sweep might undo it by rounding
            break;
        }
    }
    return steps;
}

// Brings each section in turn into balance with the current forces of the others: the minimum of Ψ
// along f_j, f_j ≥ 0, the root of w(f_j) + G_jj·f_j = h_j − Σ_{l≠j} G_jl·f_l.
void CoupledSections::Solver::sweep(const MapConst& h) {
    auto& bent = m_reduced; // G·f
    m_influence.multiply(m_now.f.data(), bent.data());
    for (Index j = 0; j < m_count; ++j) {
        const double f = ownForce(j, h[j] - (bent[j] - m_own[j] * m_now.f[j]));
        bent += (f - m_now.f[j]) * influenceOf(j);
        m_now.f[j] = f;
    }
}

// f_j with w(f_j) + G_jj·f_j = left; 0 where `left` is not positive.
double CoupledSections::Solver::ownForce(Index j, double left) const {
    const double gamma = m_own[j] * m_width[j];
    const double A = 1 + gamma * m_law.ks;
    const double C = gamma * m_law.kr;
    const ContactCompliance::Balance balance{A, C, m_wholeWidth * m_law.ks,
                                             m_wholeWidth * m_law.kr};
    if (m_law.threshold) {
        const auto [u, v] =
            m_contact ? m_contact->state(balance, left) : thresholdState(C, 4 * A, left);
        return m_width[j] * (m_law.ks * u * u + m_law.kr * v);
    }
    double u = left > 0 ? 2 * left / (C + std::sqrt(C * C + 4 * A * left)) : 0;
    if (m_contact) {
        u = m_contact->root(balance, left, u);
    }
    return m_width[j] * u * (m_law.ks * u + m_law.kr);
}

// Newton's for the sections with a force, the others keep theirs: none.
void CoupledSections::Solver::descentDirection() {
    m_free.clear();
    for (Index j = 0; j < m_count; ++j) {
        if (m_now.f[j] > 0) {
            m_free.push_back(j);
            m_added[j] = slope(j, m_now.u[j], m_now.f[j]);
        }
    }
    m_direction = -m_now.r;
    m_influence.solve(m_added.data(), m_free, m_direction.data());
}

// m_next = m_now + share of the way along the direction, up to where the first force vanishes.
void CoupledSections::Solver::moveTo(double share, double whole, const MapConst& h) {
    for (const Index j : m_free) {
        const double step = m_direction[j] * whole;
        const bool gone = share == 1 && step <= -m_now.f[j] * (1 - 1e-12);
        m_next.f[j] = gone ? 0 : std::max(m_now.f[j] + share * step, 0.0);
    }
    evaluate(m_next, h);
}

// dΨ/dt along the direction at m_next.
double CoupledSections::Solver::slopeAlong() const {
    return (m_next.r * m_direction.array()).sum();
}

// The residual of the sections with a force, including those whose force the step has made zero.
double CoupledSections::Solver::freeResidual() const {
    double largest = 0;
    for (const Index j : m_free) {
        largest = m_now.f[j] > 0 ? std::max(largest, std::abs(m_now.r[j])) : largest;
    }
    return largest;
}

// Steps along the direction into m_now so that Ψ falls. Ψ is convex along it, so its slope rises:
// where it still falls, Ψ is lower; beyond, as long as the possible rise is less than half the fall
// before. False if it was not found.
bool CoupledSections::Solver::searchAlong(const MapConst& h) {
    double whole = 1;
    for (const Index j : m_free) {
        if (m_direction[j] < 0) {
            whole = std::min(whole, -m_now.f[j] / m_direction[j]);
        }
    }
    if (!m_direction.allFinite() || !(whole > 0)) {
        return false;
    }
    m_next.f = m_now.f;
    double low = 0;
    double high = 1;
    moveTo(high, whole, h);
    double highSlope = slopeAlong();
    for (int halvings = 0; highSlope > 0; ++halvings) {
        constexpr int mostHalvings = 60;
        const double middle = low + (high - low) / 2;
        moveTo(middle, whole, h);
        const double middleSlope = slopeAlong();
        if (middleSlope > 0) {
            high = middle;
            highSlope = middleSlope;
        } else if (highSlope * (high - middle) <= -middleSlope * (middle - low) / 2) {
            moveTo(high, whole, h);
            break;
        } else {
            low = middle;
        }
        if (halvings == mostHalvings) {
            moveTo(low, whole, h);
            break;
        }
    }
    std::swap(m_now, m_next);
    return true;
}

CoupledSections::CoupledSections(const std::vector<double>& influence_mm_n,
                                 const std::vector<double>& widths_mm, const ForceLaw& law,
                                 std::optional<ContactCompliance> contact)
    : m_solver(std::make_unique<Solver>(influence_mm_n, widths_mm, law, std::move(contact))) {
    assert(influence_mm_n.size() == widths_mm.size() * widths_mm.size());
    assert(law.ks > 0 && law.kr >= 0);
}

CoupledSections::~CoupledSections() = default;
CoupledSections::CoupledSections(const CoupledSections& other)
    : m_solver(std::make_unique<Solver>(*other.m_solver)) {}
CoupledSections::CoupledSections(CoupledSections&&) noexcept = default;
CoupledSections& CoupledSections::operator=(CoupledSections&&) noexcept = default;

CoupledSections::Outcome CoupledSections::solve(const double* lag_mm, double* root,
                                                const std::stop_token& stop, double* rubbing) {
    return m_solver->solve(lag_mm, root, stop, rubbing);
}

void CoupledSections::begin(const double* lag_mm, double* root) const {
    const auto count = static_cast<Index>(size());
    m_solver->begin(MapConst(lag_mm, count), Eigen::Map<ArrayXd>(root, count));
}

std::size_t CoupledSections::size() const {
    return static_cast<std::size_t>(m_solver->count());
}

const SectionInfluence& CoupledSections::influence() const {
    return m_solver->influence();
}

} // namespace sparkout
