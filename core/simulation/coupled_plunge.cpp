// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/simulation/coupled_plunge.h"

#include "core/process/section_influence.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/part.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace sparkout {

namespace {

std::vector<double> positionsOf(const std::vector<CompliantPoint>& points, std::size_t count) {
    std::vector<double> positions;
    for (std::size_t i = 0; i < count; ++i) {
        positions.push_back(points[i].position_mm);
    }
    return positions;
}

std::vector<double> gaugeInfluence(const Project& project,
                                   const std::vector<CompliantPoint>& points,
                                   const std::stop_token& stop) {
    if (!project.gauge->position_mm) {
        return {};
    }
    const auto sections = static_cast<std::size_t>(project.sections);
    if (project.gauge->compliance_mm_per_n) {
        return std::vector<double>(sections, *project.gauge->compliance_mm_per_n);
    }
    return influenceRows(project, {points.back().position_mm}, positionsOf(points, sections), stop);
}

constexpr std::size_t sideBySide = CoupledRadii::sideBySide;

CoupledSections balanceOf(const Project& project, const std::vector<CompliantPoint>& points,
                          const std::stop_token& stop) {
    const auto sections = static_cast<std::size_t>(project.sections);
    const std::vector<double> middles = positionsOf(points, sections);
    const std::vector<double> widths(sections, project.part->length_mm / project.sections);
    return {influenceRows(project, middles, middles, stop), widths, forceLaw(project),
            wheelContact(project)};
}

/// C² for which the divided form, 2h/(C + √(C² + 4A·h)) with C = 4A = 0, gives this root; infinite
/// for the root 0, which 2h/√C² then gives.
double dividedC2(double root, double lag_mm) {
    const double q = 2 * lag_mm / root;
    return root > 0 ? q * q : std::numeric_limits<double>::infinity();
}

using Row = CoupledRadii::Row;

// Adds the depths of cut of a block of radii in the last revolution to `depth`, computes the lags,
// and extrapolates the roots of the last three revolutions by a parabola: `root` has those of the
// third-last and receives the result. All arrays have a row for each section.
[[gnu::always_inline]] inline void expectRoots(std::size_t sections, const Row* last,
                                               const Row* second, const Row& fedTo, Row* depth,
                                               Row* lag, Row* root) {
    const Row fed = fedTo; // so that no store can change it
    for (std::size_t j = 0; j < sections; ++j) {
#pragma GCC unroll 12
        for (std::size_t k = 0; k < sideBySide; ++k) {
            const double u = last[j].of[k];
            depth[j].of[k] += u * u;
            lag[j].of[k] = fed.of[k] - depth[j].of[k];
            const double expected = 3 * (u - second[j].of[k]) + root[j].of[k];
            root[j].of[k] = expected > 0 ? expected : u;
        }
    }
}

// Sums up u and u² over the sections.
[[gnu::always_inline]] inline void sumUp(std::size_t sections, const Row* root, Row& roots,
                                         Row& squares) {
    Row sum = {}, sumOfSquares = {}; // so that no store can change it
    for (std::size_t j = 0; j < sections; ++j) {
        for (std::size_t k = 0; k < sideBySide; ++k) {
            sum.of[k] += root[j].of[k];
            sumOfSquares.of[k] += root[j].of[k] * root[j].of[k];
        }
    }
    roots = sum;
    squares = sumOfSquares;
}

// One source, compiled for each vector unit, as in the pass.
void expectRootsBaseline(std::size_t sections, const Row* last, const Row* second, const Row& fed,
                         Row* depth, Row* lag, Row* root) {
    expectRoots(sections, last, second, fed, depth, lag, root);
}
[[gnu::target("avx2")]] void expectRootsAvx2(std::size_t sections, const Row* last,
                                             const Row* second, const Row& fed, Row* depth,
                                             Row* lag, Row* root) {
    expectRoots(sections, last, second, fed, depth, lag, root);
}
void sumUpBaseline(std::size_t sections, const Row* root, Row& roots, Row& squares) {
    sumUp(sections, root, roots, squares);
}
[[gnu::target("avx2")]] void sumUpAvx2(std::size_t sections, const Row* root, Row& roots,
                                       Row& squares) {
    sumUp(sections, root, roots, squares);
}

} // namespace

SectionCoupling::SectionCoupling(const Project& project, const std::vector<CompliantPoint>& points,
                                 const Blank& blank, const std::stop_token& stop)
    : m_radii(blank.depth_mm.size())
    , m_sections(static_cast<std::size_t>(project.sections))
    , m_sliceWidth(project.part->length_mm / project.sections)
    , m_law(forceLaw(project))
    , m_contact(wheelContact(project))
    , m_balance(balanceOf(project, points, stop))
    , m_gaugeInfluence(gaugeInfluence(project, points, stop))
    , m_lag(m_sections)
    , m_oneLag(m_sections)
    , m_oneRoot(m_sections)
    , m_cutAll(m_radii, false)
    , m_fed((m_radii + sideBySide - 1) / sideBySide)
    , m_normal(m_fed.size())
    , m_tangential(m_fed.size())
    , m_wheelSpeed_m_s(project.machine->wheel_speed_m_s)
    , m_peaks(project.cycle->stages.size()) {
    for (std::vector<Row>* rows : {&m_depth, &m_root, &m_rootBefore, &m_rootTwoBefore}) {
        rows->resize(m_fed.size() * m_sections);
    }
    if (m_law.threshold) {
        m_rubbing.resize(m_root.size());
        m_oneRubbing.resize(m_sections);
    }
    for (std::size_t j = 0; j < m_sections; ++j) {
        const std::vector<double>& depths = blank.depthAt(placeOfPoint(project, j));
        for (std::size_t k = 0; k < m_radii; ++k) {
            m_depth[k / sideBySide * m_sections + j].of[k % sideBySide] = depths[k];
        }
    }
    if (!m_gaugeInfluence.empty()) {
        m_gaugeDepth = blank.depthAt(placeOfPoint(project, m_sections));
    }
    if (!m_contact && !m_law.threshold && m_balance.influence().isShort()) {
        m_sideBySide.emplace(m_balance.influence(), std::vector(m_sections, m_sliceWidth), m_law);
    }
}

SectionCoupling::Outcome SectionCoupling::solve(const Run& run, const PassFeed& feed,
                                                const Place& at, CutWidth& width,
                                                const std::stop_token& stop) {
    for (std::size_t k = 0; k < m_radii; ++k) {
        m_fed[k / sideBySide].of[k % sideBySide] = run.wheelAt(k, feed);
    }
    m_root.swap(m_rootBefore); // the oldest of the three are overwritten by the next
    m_root.swap(m_rootTwoBefore);
    for (std::size_t block = 0; block < m_fed.size(); ++block) {
        if (stop.stop_requested()) {
            return Outcome::stopped;
        }
        expect(block);
        if (!balance(block, stop)) {
            return stop.stop_requested() ? Outcome::stopped : Outcome::notSolved;
        }
        sumForces(block);
    }
    impose(width);
    keepPeaks(at);
    if (!m_gaugeInfluence.empty()) {
        imposeGauge(width);
    }
    return Outcome::solved;
}

void SectionCoupling::expect(std::size_t block) {
    const std::size_t first = block * m_sections;
    const auto kernel = widestUnit() == VectorUnit::avx2 ? expectRootsAvx2 : expectRootsBaseline;
    kernel(m_sections, &m_rootBefore[first], &m_rootTwoBefore[first], m_fed[block], &m_depth[first],
           m_lag.data(), &m_root[first]);
}

bool SectionCoupling::balance(std::size_t block, const std::stop_token& stop) {
    const std::size_t count = countIn(block);
    const std::size_t firstRadius = block * sideBySide;
    CoupledRadii::Set solved;
    if (m_sideBySide) {
        CoupledRadii::Set asked;
        for (std::size_t k = 0; k < count; ++k) {
            asked[k] = m_cutAll[firstRadius + k] || begin(block, k);
        }
        solved = m_sideBySide->solve(m_lag.data(), &m_root[block * m_sections], asked);
    }
    for (std::size_t k = 0; k < count; ++k) {
        if (!solved[k] && !balanceAlone(block, k, stop)) {
            return false;
        }
        m_cutAll[firstRadius + k] =
            solved[k] || std::ranges::all_of(m_oneRoot, [](double u) { return u > 0; });
    }
    return true;
}

// The start of a radius that not all sections cut; false if the wheel does not reach all.
bool SectionCoupling::begin(std::size_t block, std::size_t k) {
    for (std::size_t j = 0; j < m_sections; ++j) {
        m_oneLag[j] = m_lag[j].of[k];
        if (!(m_oneLag[j] > 0)) {
            return false;
        }
    }
    m_balance.begin(m_oneLag.data(), m_oneRoot.data());
    for (std::size_t j = 0; j < m_sections; ++j) {
        m_root[block * m_sections + j].of[k] = m_oneRoot[j];
    }
    return true;
}

bool SectionCoupling::balanceAlone(std::size_t block, std::size_t k, const std::stop_token& stop) {
    const std::size_t first = block * m_sections;
    for (std::size_t j = 0; j < m_sections; ++j) {
        m_oneLag[j] = m_lag[j].of[k];
        m_oneRoot[j] = m_rootBefore[first + j].of[k];
    }
    for (std::size_t j = 0; j < m_oneRubbing.size(); ++j) {
        m_oneRubbing[j] = m_rubbing[first + j].of[k];
    }
    double* const rubbing = m_law.threshold ? m_oneRubbing.data() : nullptr;
    if (std::ranges::all_of(m_oneLag, [](double h) { return h <= 0; })) {
        std::ranges::fill(m_oneRoot, 0.0); // the wheel has no contact
        std::ranges::fill(m_oneRubbing, 0.0);
    } else if (!m_balance.solve(m_oneLag.data(), m_oneRoot.data(), stop, rubbing).converged) {
        return false;
    }
    for (std::size_t j = 0; j < m_sections; ++j) {
        m_root[first + j].of[k] = m_oneRoot[j];
    }
    for (std::size_t j = 0; j < m_oneRubbing.size(); ++j) {
        m_rubbing[first + j].of[k] = m_oneRubbing[j];
    }
    return true;
}

// The pass computes q = √(C² + 4A·h) and u = (q − C)/(2A), or 2h/(C + q) with a very dull wheel:
// with C = 4A = 0 and the right C² both give the required root.
void SectionCoupling::takeOver(CutWidth& width) {
    width.asGiven = true;
    std::ranges::fill(width.coefficients.C, 0.0);
    std::ranges::fill(width.coefficients.A4, 0.0);
    std::ranges::fill(width.coefficients.inverse2A, 1.0);
}

// The forces of all sections.
void SectionCoupling::sumForces(std::size_t block) {
    Row roots, cuts;
    const auto kernel = widestUnit() == VectorUnit::avx2 ? sumUpAvx2 : sumUpBaseline;
    kernel(m_sections, &m_root[block * m_sections], roots, cuts);
    if (m_law.threshold) { // v replaces the root
        roots = {};
        for (std::size_t j = 0; j < m_sections; ++j) {
            for (std::size_t k = 0; k < sideBySide; ++k) {
                roots.of[k] += m_rubbing[block * m_sections + j].of[k];
            }
        }
    }
    for (std::size_t k = 0; k < sideBySide; ++k) {
        m_normal[block].of[k] = m_law.normalOfAll(m_sliceWidth, cuts.of[k], roots.of[k]);
        m_tangential[block].of[k] = m_law.tangentialOfAll(m_sliceWidth, cuts.of[k], roots.of[k]);
    }
}

// Sets the coefficients of rubbing section by section.
void SectionCoupling::imposeRubbing(CutWidth& width) {
    double* C = width.coefficients.C.data();
    for (std::size_t j = 0; j < m_sections; ++j) {
        for (std::size_t k = 0; k < m_radii; ++k) {
            *C++ = m_rubbing[k / sideBySide * m_sections + j].of[k % sideBySide];
        }
    }
}

// Sets the coefficients section by section.
void SectionCoupling::impose(CutWidth& width) {
    if (m_law.threshold) {
        imposeRubbing(width);
    }
    const bool divides = !m_law.threshold && width.bkr > multipliedFormLimit * width.bks;
    double* C2 = width.coefficients.C2.data();
    for (std::size_t j = 0; j < m_sections; ++j) {
        for (std::size_t block = 0; block < m_fed.size(); ++block) {
            const Row& root = m_root[block * m_sections + j];
            Row needed;
            for (std::size_t k = 0; k < sideBySide; ++k) {
                needed.of[k] = root.of[k] * root.of[k];
            }
            if (divides) {
                const Row& depth = m_depth[block * m_sections + j];
                for (std::size_t k = 0; k < sideBySide; ++k) {
                    needed.of[k] = dividedC2(root.of[k], m_fed[block].of[k] - depth.of[k]);
                }
            }
            const std::size_t count = countIn(block);
            if (count == sideBySide) {
                std::memcpy(C2, &needed, sizeof needed);
            } else {
                std::copy_n(needed.of, count, C2);
            }
            C2 += count;
        }
    }
}

std::size_t SectionCoupling::countIn(std::size_t block) const {
    return std::min(sideBySide, m_radii - block * sideBySide);
}

// P_y of a section.
double SectionCoupling::forceOf(const Row* roots, std::size_t block, std::size_t section,
                                std::size_t k) const {
    const double u = roots[section].of[k];
    return m_law.threshold ? m_law.normalOfAll(m_sliceWidth, u * u,
                                               m_rubbing[block * m_sections + section].of[k])
                           : m_law.normal(m_sliceWidth, u);
}

// All forces deflect a free gauge.
void SectionCoupling::imposeGauge(CutWidth& width) {
    for (std::size_t k = 0; k < m_radii; ++k) {
        const double lag = m_fed[k / sideBySide].of[k % sideBySide] - m_gaugeDepth[k];
        const Row* roots = &m_root[k / sideBySide * m_sections];
        double a = lag;
        for (std::size_t l = 0; l < m_sections; ++l) {
            a -= m_gaugeInfluence[l] * forceOf(roots, k / sideBySide, l, k % sideBySide);
        }
        const double across = m_sliceWidth * static_cast<double>(m_sections);
        const ContactCompliance::Balance balance{1, 0, across * m_law.ks, across * m_law.kr};
        if (m_contact) {
            m_gaugeRoot = m_law.threshold ? m_contact->state(balance, a).root
                                          : m_contact->root(balance, a, m_gaugeRoot);
        } else {
            m_gaugeRoot = std::sqrt(std::max(0.0, a));
        }
        const bool divides = !m_law.threshold && width.bkr > multipliedFormLimit * width.bks;
        width.coefficients.C2[m_sections * m_radii + k] =
            divides ? dividedC2(m_gaugeRoot, lag) : m_gaugeRoot * m_gaugeRoot;
        m_gaugeDepth[k] += m_gaugeRoot * m_gaugeRoot;
    }
}

void SectionCoupling::keepPeaks(const Place& at) {
    Place place = at;
    std::size_t placed = m_radii; // radius for which the section is known
    const auto keep = [&](Peak& peak, const std::vector<Row>& values, double factor) {
        std::size_t largest = 0;
        const auto value = [&](std::size_t k) {
            return values[k / sideBySide].of[k % sideBySide] * factor;
        };
        for (std::size_t k = 1; k < m_radii; ++k) {
            largest = value(k) > value(largest) ? k : largest;
        }
        if (value(largest) > peak.value) {
            if (largest != placed) {
                place.section = static_cast<int>(deepest(largest));
                placed = largest;
            }
            peak = {value(largest), place};
        }
    };
    StagePeaks& peaks = m_peaks[static_cast<std::size_t>(at.stage - 1)];
    keep(peaks.normalForce_n, m_normal, 1);
    keep(peaks.power_w, m_tangential, m_wheelSpeed_m_s);
}

/// The first of the sections with the deepest cut of radius k.
std::size_t SectionCoupling::deepest(std::size_t k) const {
    const Row* roots = &m_root[k / sideBySide * m_sections];
    std::size_t most = 0;
    for (std::size_t j = 1; j < m_sections; ++j) {
        most = roots[j].of[k % sideBySide] > roots[most].of[k % sideBySide] ? j : most;
    }
    return most;
}

void SectionCoupling::putPeaks(SimulationResult& result) const {
    for (std::size_t stage = 0; stage < m_peaks.size(); ++stage) {
        result.sumsByStage[stage].normalForce_n = m_peaks[stage].normalForce_n;
        result.sumsByStage[stage].power_w = m_peaks[stage].power_w;
    }
    keepLargestPeaks(result);
}

} // namespace sparkout
