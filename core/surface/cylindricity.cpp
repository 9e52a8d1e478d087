// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/cylindricity.h"

#include "core/surface/roundness.h"
#include "core/surface/section_points.h"

#include <Eigen/LU>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

namespace sparkout {

namespace {

constexpr int n = static_cast<int>(ChebyshevFit::size);
using Matrix = Eigen::Matrix<double, n, n>;
using Vector = Eigen::Matrix<double, n, 1>;

/// (s·g; 1) of a point.
Vector column(const AxisView& view, const ChebyshevFit::Point& point) {
    const std::size_t i = point.index;
    const double s = point.sign, nx = view.nx[i], ny = view.ny[i], zeta = view.zetaOf(i);
    return Vector{{s, s * nx, s * ny, s * nx * zeta, s * ny * zeta, 1}};
}

Matrix basisMatrix(const AxisView& view,
                   const std::array<ChebyshevFit::Point, ChebyshevFit::size>& basis) {
    Matrix M;
    for (int m = 0; m < n; ++m) {
        M.col(m) = column(view, basis[static_cast<std::size_t>(m)]);
    }
    return M;
}

/// An orthonormal basis of the added vectors, by Gram–Schmidt with reorthogonalisation.
class Span {
public:
    /// The part of v outside the span, 0 if it is rounding.
    [[nodiscard]] Vector outside(const Vector& v) const {
        Vector rest = v;
        for (int pass = 0; pass < 2; ++pass) {
            for (int m = 0; m < m_count; ++m) {
                rest -= rest.dot(m_unit.col(m)) * m_unit.col(m);
            }
        }
        return rest.norm() > 1e-11 * v.norm() ? rest : Vector(Vector::Zero());
    }
    void take(const Vector& v) {
        const Vector rest = outside(v);
        if (const double norm = rest.norm(); norm > 0) {
            m_unit.col(m_count++) = rest / norm;
        }
    }

private:
    Matrix m_unit;
    int m_count = 0;
};

double residual(const AxisView& view, const AxisFit& fit, std::size_t i) {
    const double zeta = view.zetaOf(i);
    return view.d[i] - fit.r - view.nx[i] * (fit.x + zeta * fit.u)
           - view.ny[i] * (fit.y + zeta * fit.v);
}

} // namespace

ChebyshevFit::ChebyshevFit(const AxisView& view, std::size_t firstSection, std::size_t lastSection)
    : m_residuals(view.K) {
    for (std::size_t m = 0; m < size; ++m) {
        const std::size_t section = m < size / 2 ? firstSection : lastSection;
        m_basis[m].index = section * view.K + m % 3 * view.K / 3;
        m_candidates.push_back(m_basis[m].index);
    }
}

AxisFit ChebyshevFit::run(const AxisView& view, double tolerance) {
    makeFeasible(view);
    AxisFit fit = runOnCandidates(view, tolerance);
    while (addCandidates(view, fit, tolerance)) {
        fit = runOnCandidates(view, tolerance);
    }
    return nearest(view, fit, tolerance);
}

// With fewer than six contacts there are many best fits. Moves from the smallest shift and lean
// that keep the contacts towards the simplex method's fit, as far as the other points require:
// their excess falls linearly on the way. The radius is free, so the contacts fix shift and lean
// only by their differences: the smallest fit that keeps them is the part within the span of these
// differences.
AxisFit ChebyshevFit::nearest(const AxisView& view, const AxisFit& fit, double tolerance) const {
    const std::vector<Point> touching = contacts();
    if (touching.empty()) { // NaN weights
        return fit;
    }
    const auto direction = [&](const Point& point) {
        const double nx = view.nx[point.index], ny = view.ny[point.index];
        const double zeta = view.zetaOf(point.index);
        return Vector{{nx, ny, nx * zeta, ny * zeta, 0, 0}};
    };
    Span differences;
    for (const Point& point : touching) {
        differences.take(direction(point) - direction(touching.front()));
    }
    const Vector own{{fit.x, fit.y, fit.u, fit.v, 0, 0}};
    const Vector spare = differences.outside(own);
    const Vector p = own - spare;
    const AxisFit near{
        fit.r + direction(touching.front()).dot(spare), p[0], p[1], p[2], p[3], fit.level};
    double share = 0;
    for (std::size_t i = 0; i < view.d.size(); ++i) {
        const double from = residual(view, near, i);
        const double excess = std::abs(from) - fit.level - tolerance;
        if (excess > 0) {
            const double to = residual(view, fit, i);
            share = std::max(share, excess / (std::abs(from) - (from < 0 ? -to : to)));
        }
    }
    share = std::min(share, 1.0);
    return {near.r + share * (fit.r - near.r), near.x + share * (fit.x - near.x),
            near.y + share * (fit.y - near.y), near.u + share * (fit.u - near.u),
            near.v + share * (fit.v - near.v), fit.level};
}

std::vector<ChebyshevFit::Point> ChebyshevFit::contacts() const {
    constexpr double carries = 1e-9;
    std::vector<Point> found;
    for (std::size_t m = 0; m < size; ++m) {
        if (m_weights[m] > carries) {
            found.push_back(m_basis[m]);
        }
    }
    return found;
}

// Six points have one vector η with Σ η_i·g_i = 0; its signs are those of the basis.
void ChebyshevFit::makeFeasible(const AxisView& view) {
    for (Point& point : m_basis) {
        point.sign = 1;
    }
    const Matrix M = basisMatrix(view, m_basis);
    Span rows;
    for (int row = 0; row < n - 1; ++row) {
        rows.take(M.row(row));
    }
    Vector eta = Vector::Zero();
    for (int m = 0; m < n; ++m) {
        const Vector rest = rows.outside(Vector::Unit(m));
        if (rest.norm() > eta.norm()) {
            eta = rest;
        }
    }
    for (std::size_t m = 0; m < size; ++m) {
        m_basis[m].sign = eta[static_cast<int>(m)] < 0 ? -1 : 1;
    }
}

// Weights from M·y = e₆ and the fit from Mᵀ·(fit; level) = s·d, M the basis.
AxisFit ChebyshevFit::solve(const AxisView& view) {
    const Eigen::PartialPivLU<Matrix> lu(basisMatrix(view, m_basis));
    Vector d;
    for (int m = 0; m < n; ++m) {
        const Point& point = m_basis[static_cast<std::size_t>(m)];
        d[m] = point.sign * view.d[point.index];
    }
    const Vector x = lu.transpose().solve(d);
    const Vector y = lu.solve(Vector::Unit(n - 1));
    for (std::size_t m = 0; m < size; ++m) {
        m_weights[m] = std::max(y[static_cast<int>(m)], 0.0);
    }
    return {x[0], x[1], x[2], x[3], x[4], x[5]};
}

ChebyshevFit::Entering ChebyshevFit::choose(const AxisView& view, const AxisFit& fit,
                                            double tolerance, bool bland) const {
    Entering found{{}, tolerance};
    for (const std::size_t i : m_candidates) {
        const double off = residual(view, fit, i);
        const double excess = std::abs(off) - fit.level;
        if (excess > found.excess) {
            found = {{i, off < 0 ? -1.0 : 1.0}, excess};
            if (bland) {
                break;
            }
        }
    }
    return found;
}

// The weights along the entering column: the point with θ = min y_m/z_m over z_m > 0 leaves the
// basis. Ties are broken by the largest z, which keeps the basis well-conditioned, or by Bland's
// rule, by the first point.
bool ChebyshevFit::pivot(const AxisView& view, const Point& entering, bool bland) {
    const Vector z =
        Eigen::PartialPivLU<Matrix>(basisMatrix(view, m_basis)).solve(column(view, entering));
    constexpr double least = 1e-11;
    constexpr double equal = 1e-13;
    std::size_t leaving = size;
    double best = 0;
    for (std::size_t m = 0; m < size; ++m) {
        const double zm = z[static_cast<int>(m)];
        if (zm <= least) {
            continue;
        }
        const double ratio = m_weights[m] / zm;
        const bool tie = leaving < size && std::abs(ratio - best) <= equal;
        const bool better = leaving == size
                            || (tie ? (bland ? m_basis[m].index < m_basis[leaving].index
                                             : zm > z[static_cast<int>(leaving)])
                                    : ratio < best);
        if (better) {
            leaving = m;
            best = ratio;
        }
    }
    if (leaving == size) {
        return false;
    }
    m_basis[leaving] = entering;
    return true;
}

AxisFit ChebyshevFit::runOnCandidates(const AxisView& view, double tolerance) {
    constexpr int mostPivots = 5000;
    constexpr int patience = 12; ///< pivots without a gain before Bland's rule
    std::sort(m_candidates.begin(), m_candidates.end());
    AxisFit fit = solve(view);
    int stalled = 0;
    for (int step = 0; step < mostPivots; ++step) {
        const bool bland = stalled > patience;
        const Entering entering = choose(view, fit, tolerance, bland);
        if (entering.excess <= tolerance || !pivot(view, entering.point, bland)) {
            break;
        }
        const AxisFit next = solve(view);
        stalled = next.level > fit.level + tolerance / 16 ? 0 : stalled + 1;
        fit = next;
    }
    return fit;
}

// Vectorised: with 200 sections of 360 radii this takes most of the time.
void ChebyshevFit::takeResiduals(const AxisView& view, const AxisFit& fit, std::size_t section) {
    const std::size_t K = view.K;
    const double* __restrict d = view.d.data() + section * K;
    const double* __restrict nx = view.nx.data() + section * K;
    const double* __restrict ny = view.ny.data() + section * K;
    double* __restrict off = m_residuals.data();
    const double r = fit.r;
    const double x = fit.x + view.zeta[section] * fit.u;
    const double y = fit.y + view.zeta[section] * fit.v;
#pragma omp simd
    for (std::size_t k = 0; k < K; ++k) {
        off[k] = d[k] - r - nx[k] * x - ny[k] * y;
    }
}

/// Adds the furthest points of each section with an excess, on either side.
bool ChebyshevFit::addCandidates(const AxisView& view, const AxisFit& fit, double tolerance) {
    const std::size_t before = m_candidates.size();
    const auto isCandidate = [&](std::size_t i) { // the earlier ones are sorted
        return std::binary_search(m_candidates.begin(),
                                  m_candidates.begin() + static_cast<std::ptrdiff_t>(before), i);
    };
    for (std::size_t j = 0; j < view.sections; ++j) {
        const std::size_t first = j * view.K;
        takeResiduals(view, fit, j);
        const ValueRange range = rangeOf(m_residuals);
        for (const double extreme : {range.low, range.high}) {
            if (!(std::abs(extreme) > fit.level + tolerance)) { // also for NaN
                continue;
            }
            const auto found = std::find(m_residuals.begin(), m_residuals.end(), extreme);
            const std::size_t i = first + static_cast<std::size_t>(found - m_residuals.begin());
            if (!isCandidate(i)) {
                m_candidates.push_back(i);
            }
        }
    }
    return m_candidates.size() > before;
}

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

/// A trial axis: it passes (x, y) at ζ = 0 and (x + u, y + v) at ζ = 1.
struct Axis {
    double x = 0, y = 0, u = 0, v = 0;
};

/// The sections along the axis, ζ from their mean position on, 1 at the farthest.
class Surface3d {
public:
    Surface3d(std::span<const SectionShape> sections, const Directions& directions)
        : m_sections(sections), m_directions(directions), m_zeta(sections.size()) {
        for (const SectionShape& section : sections) {
            assert(section.radii_mm.size() == directions.size());
            m_middle += section.position_mm / static_cast<double>(sections.size());
        }
        for (const SectionShape& section : sections) {
            m_reach = std::max(m_reach, std::abs(section.position_mm - m_middle));
        }
        for (std::size_t j = 0; j < sections.size(); ++j) {
            m_zeta[j] = (sections[j].position_mm - m_middle) / m_reach;
            m_zetaSquares += m_zeta[j] * m_zeta[j];
        }
    }

    [[nodiscard]] AxisView emptyView() const {
        AxisView view(m_sections.size(), m_directions.size());
        view.zeta = m_zeta;
        return view;
    }

    // Offset q from the axis at the point's own position; along the leaning axis, direction (t, 1),
    // the foot is λ = q·t/(1 + t²) further. d = |q − λ·(t, 1)|, and as the foot is the nearest
    // point of the axis, ∂d/∂(shift) = −(nx, ny) and ∂d/∂(lean) = −ζ_foot·(nx, ny). The section's
    // place approximates that of the foot: λ is about R·t.
    void look(const Axis& axis, AxisView& view) const {
        const double tx = axis.u / m_reach, ty = axis.v / m_reach, t2 = tx * tx + ty * ty;
        const double along = 1 / (1 + t2);
        const std::size_t K = view.K;
        const double* __restrict c = m_directions.cosines().data();
        const double* __restrict s = m_directions.sines().data();
        for (std::size_t j = 0; j < view.sections; ++j) {
            const double cx = axis.x + m_zeta[j] * axis.u, cy = axis.y + m_zeta[j] * axis.v;
            const double* __restrict R = m_sections[j].radii_mm.data();
            double* __restrict d = view.d.data() + j * K;
            double* __restrict nx = view.nx.data() + j * K;
            double* __restrict ny = view.ny.data() + j * K;
#pragma omp simd
            for (std::size_t k = 0; k < K; ++k) {
                const double qx = R[k] * c[k] - cx, qy = R[k] * s[k] - cy;
                const double foot = (qx * tx + qy * ty) * along;
                const double rx = qx - foot * tx, ry = qy - foot * ty;
                const double distance = std::sqrt(rx * rx + ry * ry + foot * foot);
                const double inverse = 1 / distance;
                d[k] = distance;
                nx[k] = rx * inverse;
                ny[k] = ry * inverse;
            }
        }
    }

    [[nodiscard]] CylinderZone zone(const Axis& axis, const AxisView& view) const {
        const auto [low, high] = rangeOf(view.d);
        CylinderZone found;
        found.position_mm = m_middle;
        found.x_mm = axis.x;
        found.y_mm = axis.y;
        found.slopeX = axis.u / m_reach;
        found.slopeY = axis.v / m_reach;
        found.inner_mm = low;
        found.outer_mm = high;
        found.reference_mm = (low + high) / 2;
        return found;
    }

    [[nodiscard]] Axis axisOf(const CylinderZone& zone) const {
        return {zone.x_mm, zone.y_mm, zone.slopeX * m_reach, zone.slopeY * m_reach};
    }
    /// The regression line through the sections' centres, an approximation up to form/R.
    [[nodiscard]] Axis throughCentres() const {
        const std::vector<double>& c = m_directions.cosines();
        const std::vector<double>& s = m_directions.sines();
        const double share = 2 / static_cast<double>(c.size());
        const auto J = static_cast<double>(m_sections.size());
        Axis axis;
        if (!m_directions.areEven()) { // the machine's own axis is near enough
            return axis;
        }
        for (std::size_t j = 0; j < m_sections.size(); ++j) {
            double x = 0, y = 0;
            for (std::size_t k = 0; k < c.size(); ++k) {
                x += share * m_sections[j].radii_mm[k] * c[k];
                y += share * m_sections[j].radii_mm[k] * s[k];
            }
            axis.x += x / J;
            axis.y += y / J;
            axis.u += m_zeta[j] * x / m_zetaSquares;
            axis.v += m_zeta[j] * y / m_zetaSquares;
        }
        return axis;
    }
    [[nodiscard]] double reach() const {
        return m_reach;
    }
    [[nodiscard]] double zetaSquares() const {
        return m_zetaSquares;
    }

private:
    std::span<const SectionShape> m_sections;
    const Directions& m_directions;
    std::vector<double> m_zeta;
    double m_middle = 0, m_reach = 0, m_zetaSquares = 0;
};

CylinderZone fromCircles(const SectionShape& section, const RoundnessZone& circles) {
    CylinderZone found;
    found.position_mm = section.position_mm;
    found.x_mm = circles.x_mm;
    found.y_mm = circles.y_mm;
    found.inner_mm = circles.inner_mm;
    found.outer_mm = circles.outer_mm;
    found.reference_mm = circles.reference_mm;
    return found;
}

/// Mean distance r and the Gauss-Newton step of the axis, up to about form/R of it: the directions
/// are nearly orthogonal. The foot of a point is λ = d·(n·t) from its section.
AxisFit leastSquaresStep(const AxisView& view, const Surface3d& surface, const Axis& axis) {
    const std::size_t K = view.K;
    double sum = 0;
    for (const double d : view.d) {
        sum += d - view.d[0];
    }
    AxisFit by;
    by.r = view.d[0] + sum / static_cast<double>(view.d.size());
    const double lean = 2 / (static_cast<double>(K) * surface.zetaSquares());
    const double shift = 2 / static_cast<double>(view.d.size());
    const double perReach = 1 / surface.reach();
    const double tx = axis.u * perReach * perReach, ty = axis.v * perReach * perReach;
    for (std::size_t j = 0; j < view.sections; ++j) {
        const double* __restrict d = view.d.data() + j * K;
        const double* __restrict nx = view.nx.data() + j * K;
        const double* __restrict ny = view.ny.data() + j * K;
        double x = 0, y = 0, u = 0, v = 0;
#pragma omp simd reduction(+ : x, y, u, v)
        for (std::size_t k = 0; k < K; ++k) {
            const double ex = (d[k] - by.r) * nx[k], ey = (d[k] - by.r) * ny[k];
            const double beside = d[k] * (nx[k] * tx + ny[k] * ty);
            x += ex;
            y += ey;
            u += ex * beside;
            v += ey * beside;
        }
        by.x += shift * x;
        by.y += shift * y;
        by.u += lean * (view.zeta[j] * x + u);
        by.v += lean * (view.zeta[j] * y + v);
    }
    return by;
}

/// For uneven directions: the least Σ(d − r − n·(shift + ζ·lean))², ζ of the foot.
AxisFit leastSquaresOfSome(const AxisView& view, const Surface3d& surface, const Axis& axis) {
    using Vector5 = Eigen::Matrix<double, 5, 1>;
    const double perReach = 1 / surface.reach();
    const double tx = axis.u * perReach * perReach, ty = axis.v * perReach * perReach;
    Eigen::Matrix<double, 5, 5> normal = Eigen::Matrix<double, 5, 5>::Zero();
    Vector5 right = Vector5::Zero();
    for (std::size_t i = 0; i < view.d.size(); ++i) {
        const double nx = view.nx[i], ny = view.ny[i];
        const double zeta = view.zetaOf(i) + view.d[i] * (nx * tx + ny * ty);
        const Vector5 row{{1, nx, ny, zeta * nx, zeta * ny}};
        normal += row * row.transpose();
        right += row * (view.d[i] - view.d[0]);
    }
    const Vector5 found = normal.partialPivLu().solve(right);
    return {view.d[0] + found[0], found[1], found[2], found[3], found[4], 0};
}

/// The ground parts of interrupted sections, whose gaps are the same.
class GroundSections {
public:
    GroundSections(std::span<const SectionShape> sections, const Directions& directions)
        : m_ground(sections.front().radii_mm), m_directions(directions, m_ground.indices()) {
        for (const SectionShape& section : sections) {
            m_radii.push_back(m_ground.of(section.radii_mm));
        }
        for (std::size_t j = 0; j < sections.size(); ++j) {
            m_shapes.push_back({sections[j].position_mm, m_radii[j]});
        }
    }
    [[nodiscard]] std::span<const SectionShape> shapes() const { return m_shapes; }
    [[nodiscard]] const Directions& directions() const { return m_directions; }
    [[nodiscard]] CylinderZone withRadii(CylinderZone zone) const {
        for (CylinderContact& contact : zone.contacts) {
            contact.radius = m_ground.indices()[contact.radius];
        }
        return zone;
    }

private:
    GroundRadii m_ground;
    Directions m_directions;
    std::vector<std::vector<double>> m_radii;
    std::vector<SectionShape> m_shapes;
};

bool isInterrupted(std::span<const SectionShape> sections) {
    return !GroundRadii(sections.front().radii_mm).areAll();
}

Axis moved(const Axis& axis, const AxisFit& fit, double share) {
    return {axis.x + share * fit.x, axis.y + share * fit.y, axis.u + share * fit.u,
            axis.v + share * fit.v};
}

/// Gauss-Newton on the axis: each step is the best axis of the distances linearised about the last
/// one, halved until the true zone becomes narrower.
class ZoneSearch {
public:
    ZoneSearch(const Surface3d& surface, const CylinderZone& start)
        : m_surface(surface)
        , m_axis(surface.axisOf(start))
        , m_view(surface.emptyView())
        , m_tolerance(8 * epsilon * start.outer_mm) {
        surface.look(m_axis, m_view);
        m_best = surface.zone(m_axis, m_view);
    }

    CylinderZone run() {
        constexpr int mostSteps = 50;
        ChebyshevFit chebyshev(m_view, 0, m_view.sections - 1);
        for (int step = 0; step < mostSteps; ++step) {
            const AxisFit fit = chebyshev.run(m_view, m_tolerance / 2);
            m_gain = m_best.deviation() - 2 * fit.level;
            if (m_gain <= m_tolerance + curvature(fit) || !narrow(fit)) {
                break;
            }
        }
        m_surface.look(m_axis, m_view);
        takeContacts(chebyshev.contacts());
        return m_best;
    }

private:
    /// The error of a step by the curvature of the distances: a smaller gain is not significant.
    [[nodiscard]] double curvature(const AxisFit& fit) const {
        const double R = m_best.inner_mm;
        const double shift = std::hypot(fit.x, fit.y) + std::hypot(fit.u, fit.v);
        const double lean = std::hypot(fit.u, fit.v) / m_surface.reach();
        return shift * shift / (2 * R) + R * lean * lean / 2;
    }
    bool narrow(const AxisFit& fit) {
        for (double share = 1; share > 1e-3; share /= 2) {
            const Axis tried = moved(m_axis, fit, share);
            m_surface.look(tried, m_view);
            const CylinderZone zone = m_surface.zone(tried, m_view);
            if (zone.deviation() < m_best.deviation()) {
                m_best = zone;
                m_axis = tried;
                return true;
            }
        }
        return false;
    }
    void takeContacts(const std::vector<ChebyshevFit::Point>& points) {
        const double near = std::max(m_gain, 0.0) + m_tolerance;
        for (const ChebyshevFit::Point& point : points) {
            const bool outer = point.sign > 0;
            const double radius = outer ? m_best.outer_mm : m_best.inner_mm;
            if (std::abs(m_view.d[point.index] - radius) <= near) {
                m_best.contacts.push_back({point.index / m_view.K, point.index % m_view.K, outer});
            }
        }
    }

    const Surface3d& m_surface;
    Axis m_axis;
    AxisView m_view;
    CylinderZone m_best;
    double m_tolerance;
    double m_gain = 0; ///< predicted by the last linear step
};

} // namespace

CylinderZone leastSquaresCylinder(std::span<const SectionShape> sections,
                                  const Directions& directions) {
    if (sections.size() == 1) {
        return fromCircles(sections[0], leastSquaresCircle(sections[0].radii_mm, directions));
    }
    if (isInterrupted(sections)) {
        const GroundSections ground(sections, directions);
        return leastSquaresCylinder(ground.shapes(), ground.directions());
    }
    constexpr int mostSteps = 200;
    const Surface3d surface(sections, directions);
    AxisView view = surface.emptyView();
    Axis axis = surface.throughCentres();
    double r = 0, share = 1;
    double last = std::numeric_limits<double>::infinity();
    for (int step = 0; step < mostSteps; ++step) {
        surface.look(axis, view);
        const AxisFit by = directions.areEven() ? leastSquaresStep(view, surface, axis)
                                                : leastSquaresOfSome(view, surface, axis);
        r = by.r;
        const double size = std::abs(by.x) + std::abs(by.y) + std::abs(by.u) + std::abs(by.v);
        if (size <= 256 * epsilon * r || step + 1 == mostSteps) {
            break;
        }
        share = size > last ? share / 2 : share; // far from round the steps may overshoot
        last = size;
        axis = moved(axis, by, share);
    }
    CylinderZone found = surface.zone(axis, view);
    found.reference_mm = r;
    return found;
}

CylinderZone minimumZoneCylinder(std::span<const SectionShape> sections,
                                 const Directions& directions) {
    return minimumZoneCylinder(sections, directions, leastSquaresCylinder(sections, directions));
}

CylinderZone minimumZoneCylinder(std::span<const SectionShape> sections,
                                 const Directions& directions, const CylinderZone& leastSquares) {
    if (sections.size() == 1) {
        const RoundnessZone circles = minimumZoneCircles(sections[0].radii_mm, directions);
        CylinderZone found = fromCircles(sections[0], circles);
        for (std::size_t m = 0; m < circles.contacts.size(); ++m) {
            found.contacts.push_back({0, circles.contacts[m], m % 2 == 0});
        }
        return found;
    }
    if (isInterrupted(sections)) {
        const GroundSections ground(sections, directions);
        return ground.withRadii(
            minimumZoneCylinder(ground.shapes(), ground.directions(), leastSquares));
    }
    const Surface3d surface(sections, directions);
    ZoneSearch search(surface, leastSquares);
    return search.run();
}

} // namespace sparkout
