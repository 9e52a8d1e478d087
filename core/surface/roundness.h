// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace sparkout {

/// cos φ_k and sin φ_k at φ_k = 2πk/K, the directions of a section's radii. Made once for all
/// sections of a part; K ≥ 4.
class Directions {
public:
    explicit Directions(std::size_t K);
    /// The directions of some radii, by rising k; at least 4.
    Directions(const Directions& all, std::span<const std::size_t> radii);
    [[nodiscard]] std::size_t size() const { return m_cos.size(); }
    [[nodiscard]] bool areEven() const { return m_even; } ///< all K: Σ cos = Σ sin = 0 and so on
    [[nodiscard]] const std::vector<double>& cosines() const { return m_cos; }
    [[nodiscard]] const std::vector<double>& sines() const { return m_sin; }

private:
    std::vector<double> m_cos, m_sin;
    bool m_even = true;
};

/// The radii of equally interrupted sections, without the NaN values of gaps: a form is that of the
/// ground parts.
class GroundRadii {
public:
    explicit GroundRadii(std::span<const double> radii_mm); ///< of one of the sections
    [[nodiscard]] bool areAll() const { return m_ground.size() == m_count; }
    [[nodiscard]] const std::vector<std::size_t>& indices() const { return m_ground; } ///< k
    [[nodiscard]] std::vector<double> of(std::span<const double> radii_mm) const;

private:
    std::size_t m_count;
    std::vector<std::size_t> m_ground;
};

/// Two concentric circles that contain a section's points between them [ISO12181]. x points at
/// radius 0, y a quarter turn further; both are relative to the centre axis of the machine.
struct RoundnessZone {
    double x_mm = 0, y_mm = 0; ///< centre
    double inner_mm = 0;       ///< radius of the inner circle
    double outer_mm = 0;       ///< radius of the outer circle
    double reference_mm = 0;   ///< least squares: the fitted radius; minimum zone: the middle
    /// Minimum zone: radii with alternating contacts to the outer and inner circle, by rising k.
    std::array<std::size_t, 4> contacts{};

    [[nodiscard]] double deviation() const { return outer_mm - inner_mm; }
};

/// The curves of a zone. About a centre at the distance e from the axis the radius of a limaçon, R
/// + x·cos φ + y·sin φ, differs from a circle's by at most e²/(2(R − e)), which also bounds the
/// difference of the two roundness values: 0.01 µm for e = 17 µm, R = 15 mm.
enum class ZoneModel { circles, limacons };

/// Least-squares circle: the centre and radius with the smallest Σ(distance − radius)². Here and
/// below NaN radii, in gaps, are ignored. Gauss's conditions are met for the true distances; takes
/// a few steps, each smaller by max(e, form)/R.
[[nodiscard]] RoundnessZone leastSquaresCircle(std::span<const double> radii_mm,
                                               const Directions& directions);

/// Minimum zone: the centre with the smallest outer − inner; external and internal surfaces alike.
///
/// Limaçons: the best uniform approximation of R_k by r + x·cos φ_k + y·sin φ_k, a Haar system, so
/// it is unique, characterised by four alternating contacts, and the exchange (Remez) converges to
/// it. Circles: the distances are recomputed about the new centre until four true distances
/// alternate and no other point has an excess. No centre in the neighbourhood is better; any other
/// centre is better by at most w²/(2(R − w)·cos²(π/K)), w the zone found: 0.004 µm for w = 10 µm, R
/// = 15 mm, and as w² below. (For a centre v: Σλ·d over the outer points less Σμ·d over the inner,
/// weights that balance the directions, is no greater than the zone about v and no smaller than w −
/// v²/(2(R − v)); and v ≤ w/cos(π/K) when the zone about v is not wider than w.)
[[nodiscard]] RoundnessZone minimumZoneCircles(std::span<const double> radii_mm,
                                               const Directions& directions,
                                               ZoneModel model = ZoneModel::circles);

[[nodiscard]] RoundnessZone minimumZoneCircles(std::span<const double> radii_mm,
                                               const Directions& directions,
                                               const RoundnessZone& leastSquares);

/// Minimum circumscribed circle (MCC) of a section: the smallest circle about all its points, a
/// ring gauge; `reference_mm` is its radius, the roundness deviation the largest distance from it
/// inwards [ISO12181].
///
/// About a trial centre the distances are linear in its shift up to their curvature; that problem,
/// the least r with r ≥ d_k − n_k·shift, is a linear programme in three unknowns, solved exactly by
/// the simplex method on its dual: three points whose directions balance define the circle, and the
/// point with the largest excess replaces one of them. Then the distances are recomputed, until the
/// circle becomes no smaller.
///
/// Empty if no three directions balance, as with a gap of half a turn: the circle is then
/// undefined.
[[nodiscard]] std::optional<RoundnessZone>
minimumCircumscribedCircle(std::span<const double> radii_mm, const Directions& directions);

/// Maximum inscribed circle (MIC): the largest within all the points, a plug gauge; the deviation
/// is the largest distance from it outwards. As above with the greatest r with r ≤ d_k −
/// n_k·shift.
[[nodiscard]] std::optional<RoundnessZone> maximumInscribedCircle(std::span<const double> radii_mm,
                                                                  const Directions& directions);

} // namespace sparkout
