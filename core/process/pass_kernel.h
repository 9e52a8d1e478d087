// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <vector>

/// One pass under the wheel for many independent lanes (a lane is one radius of one zone, section
/// or scenario): the elastic balance [MODEL-3]
///
///     a + γ·P_y(a) = h,    h = t_П − depth,    a = 0 if h ≤ 0
///     A = 1 + γ·b·k_s,  C = γ·b·k_r
///     √a = ( √(C² + 4·A·h) − C ) / (2·A)
///     depth ← depth + a
///
/// This multiplied form loses at most ε·C/A ≤ ε·k_r/k_s in √a, hence 2ε·√a·k_r/k_s in a: with
/// k_r/k_s up to `multipliedFormLimit` that is below 1e-13 mm. Beyond it (a very dull wheel on very
/// slow work) the pass takes the form that does not cancel, √a = 2h/(C + √(C² + 4·A·h)). √(C·C) is
/// C exactly in binary floating point, so h = 0 gives a = 0 exactly in both.
///
/// The surface of a wheel out of true stands w = e·cos ψ nearer to the work [MODEL-16], and h is
/// t_П + w − depth. With ψ = α + β, α at the beginning of the pass and β what it advances up to the
/// visit of the radius, w = e·cos α·cos β − e·sin α·sin β: the feed has the first factors, the
/// lanes the second ones.
namespace sparkout {

/// Largest k_r/k_s [1/√mm] at which a pass takes the multiplied form; usual cuts are below 1.
inline constexpr double multipliedFormLimit = 500;

/// The programmed infeed of one pass: t_П = min(base + min(offset + rate·share, cap) + drift·share,
/// most) [mm], rounded as min(min((base + offset) + rate·share, base + cap) + drift·share, most).
struct PassFeed {
    double base = 0, offset = 0, rate = 0, cap = 0;
    double drift = 0; ///< ≥ 0: of a continuous infeed, in the whole pass
    double most = std::numeric_limits<double>::infinity(); ///< upper limit of the infeed, ≥ base
    double waveCos_mm = 0, waveSin_mm = 0; ///< e·cos α, −e·sin α of a wheel out of true

    [[nodiscard]] double at(double share) const {
        return std::min(std::min(base + offset + rate * share, base + cap) + drift * share, most);
    }
    /// An upper bound of where the wheel's surface stands at any share.
    [[nodiscard]] double greatest() const {
        return std::min(base + cap + drift, most) + (std::abs(waveCos_mm) + std::abs(waveSin_mm));
    }
};

/// The lanes' state.
struct Lanes {
    explicit Lanes(std::size_t count)
        : depth_mm(count), root(count), rootSum(count), peakRoot(count), share(count) {}
    /// Makes each later pass keep every lane's rubbing share, for a force with a threshold.
    void keepRubbing() {
        rubbing.assign(root.size(), 0.0);
        peakRubbing.assign(root.size(), 0.0);
    }
    /// w at the visit of a lane [mm].
    [[nodiscard]] double waveAt(std::size_t lane, const PassFeed& feed) const {
        return waveCos.empty() ? 0
                               : feed.waveCos_mm * waveCos[lane] + feed.waveSin_mm * waveSin[lane];
    }
    /// Where the surface of the wheel stands at the visit of a lane: t_П + w [mm].
    [[nodiscard]] double wheelAt(std::size_t lane, const PassFeed& feed) const {
        return feed.at(share[lane]) + waveAt(lane, feed);
    }
    std::vector<double> depth_mm; ///< depth of the radius below first touch
    std::vector<double> root;     ///< u = √a of the last pass [√mm]
    std::vector<double> rootSum; ///< Σ√a since the owner last cleared it [√mm]; Σv with rubbing
    std::vector<double> peakRoot;    ///< largest √a since the owner last cleared it [√mm]
    std::vector<double> rubbing;     ///< v of the last pass; empty without a threshold of the force
    std::vector<double> peakRubbing; ///< largest v
    std::vector<double> share; ///< (k+1)/K, share of the revolution at which the radius is visited
    std::vector<double> waveCos, waveSin; ///< cos β, sin β; empty: the wheel runs true
};

/// The balance's coefficients for each lane at one width of cut.
struct LaneCoefficients {
    explicit LaneCoefficients(std::size_t count)
        : C(count), C2(count), A4(count), inverse2A(count) {}
    /// Sets `count` equal lanes, one by default: γ [mm/N], b·k_s [N/mm], b·k_r [N/√mm].
    void set(std::size_t first, double gamma, double bks, double bkr, std::size_t count = 1);

    std::vector<double> C, C2, A4, inverse2A;
};

/// The balance's coefficients of one lane at one width of cut.
struct LaneBalance {
    double C = 0, C2 = 0, A4 = 0, inverse2A = 0;
    bool multiplied = true;
    bool threshold = false; ///< force with a threshold: b·k_s is b·K, b·k_r is b·F'_0
    LaneBalance() = default;
    /// γ [mm/N], b·k_s [N/mm], b·k_r [N/√mm].
    LaneBalance(double gamma, double bks, double bkr, bool hasThreshold = false)
        : C(gamma * bkr)
        , C2(C * C)
        , A4(4 * (1 + gamma * bks))
        , inverse2A(1 / (2 * (1 + gamma * bks)))
        , multiplied(bkr <= multipliedFormLimit * bks && !hasThreshold)
        , threshold(hasThreshold) {}
    /// √a [√mm] for an infeed of h [mm] beyond the radius, as in a pass up to rounding.
    [[nodiscard]] double root(double h) const {
        const double infeed = h > 0 ? h : 0;
        const double q = std::sqrt(C2 + A4 * infeed);
        return multiplied  ? (q - C) * inverse2A
               : threshold ? rootBeyond(infeed)
                           : 2 * infeed / (C + q);
    }

private:
    [[nodiscard]] double rootBeyond(double infeed) const {
        return infeed > C ? std::sqrt(4 * (infeed - C) / A4) : 0;
    }
};

/// A range of lanes in one pass.
struct PassRange {
    std::size_t first = 0, count = 0;
    double bks = 0, bkr = 0; ///< coefficients of the force P_y = bks·a + bkr·√a
};

/// Cuts the lanes of the range once; returns the largest √a [√mm].
using PassFunction = double (*)(Lanes& lanes, const LaneCoefficients& coefficients,
                                const PassFeed& feed, const PassRange& range);

/// AVX-512 is left out: √ takes as long per lane, and its wide stores cross cache lines (a pass
/// over 36 radii took 65 ns against 47 ns with AVX2).
enum class VectorUnit { baseline, avx2 };

[[nodiscard]] bool isSupported(VectorUnit unit);
/// The widest unit of this processor.
[[nodiscard]] VectorUnit widestUnit();
[[nodiscard]] PassFunction passFunction(VectorUnit unit);

/// The pass for widestUnit(). All units give bit-identical results.
[[nodiscard]] PassFunction widestPassFunction();

/// The largest P_y of each zone or section so far [N].
///
/// P_y rises with √a, and so do its rounded products and their sum: of the passes at one width the
/// largest √a bears the largest force, to the last bit. So a pass keeps only that, and the force
/// is computed where a section's width changes, and at the end. With a threshold the force rises
/// with the rubbing share, too, and both peak together.
class PeakForces {
public:
    PeakForces(std::size_t sections, std::size_t radii) : m_radii(radii), m_sections(sections) {}
    /// Called before a pass over `count` sections from `first` on.
    void passBegins(Lanes& lanes, const PassRange& range, std::size_t first, std::size_t count) {
        for (std::size_t section = first; section < first + count; ++section) {
            const Section& before = m_sections[section];
            if (before.bks != range.bks || before.bkr != range.bkr) {
                turnTo(lanes, range, section);
            }
        }
    }
    [[nodiscard]] double of(const Lanes& lanes, std::size_t section) const;

private:
    struct Section {
        double bks = 0, bkr = 0; ///< coefficients of the passes whose force is not computed yet
        double peak_n = 0;       ///< peak of the earlier passes
    };
    void turnTo(Lanes& lanes, const PassRange& range, std::size_t section);

    std::size_t m_radii;
    std::vector<Section> m_sections;
};

} // namespace sparkout
