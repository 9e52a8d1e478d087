// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <array>
#include <cstddef>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Multiplies every elastic deflection under a given force by the factor: scales a given γ, or
/// divides the stiffnesses from which γ is computed (machine, shaft, steady rests), and the wheel
/// contact.
void scaleCompliance(Project& project, double factor);

enum class Mounting; // core/project/part.h

/// A cylindrical segment of a stepped shaft.
struct BeamSegment {
    double length_mm = 0;   ///< along the axis, > 0 [mm]
    double diameter_mm = 0; ///< d, > 0 [mm]
};

/// A steady rest: a spring between a point of the shaft and the ground.
struct SupportSpring {
    double position_mm = 0;    ///< from the headstock end of the shaft [mm]
    double stiffness_n_mm = 0; ///< k >= 0; infinity: rigid [N/mm]
};

/// The elastic system: wheel head and shaft on its supports. Stiffnesses are > 0; infinity means
/// rigid.
struct ShaftModel {
    std::vector<BeamSegment> segments; ///< from the headstock end; their lengths add up to L_s
    double youngsModulus_n_mm2 = 0;    ///< E; infinity: a rigid shaft [N/mm^2]
    Mounting mounting{};               ///< the first: between centres
    double headstock_n_mm = 0;         ///< j_h [N/mm]
    double tailstock_n_mm = 0;         ///< j_t, unused for a chuck [N/mm]
    double wheelHead_n_mm = 0;         ///< j_w [N/mm]
    std::vector<SupportSpring> rests;  ///< steady rests, in any order
};

/// The parts of gamma(x) = G(x,x) [mm/N]; `rests`, the part of the steady rests, is <= 0.
struct ComplianceParts {
    double wheelHead = 0;
    double headstock = 0;
    double tailstock = 0;
    double bending = 0;
    double rests = 0;
};

/// Influence function of the technological system [MODEL §6]: G(x,s) [mm/N] is how far wheel and
/// shaft move apart at x under a unit radial force at s. Positions [mm] are counted from the
/// headstock end of the shaft (centre or chuck face) and lie on the shaft. With M_x(xi) the bending
/// moment from a unit force at x and I = pi d^4/64,
///
///     centres: G = 1/j_w + (1-x/L)(1-s/L)/j_h + (x/L)(s/L)/j_t + integral of M_x M_s/(E I),
///     chuck:   G = 1/j_w + 1/j_h + the same integral, M_x = max(0, x - xi);
///
/// the integrals extend over the shaft.
///
/// Each rest (stiffness k at p) then changes the part of the shaft, g = G - 1/j_w, to g(x,s) -
/// g(x,p) g(p,s)/(1/k + g(p,p)). Exact for stepped shafts up to rounding: the integrand is
/// piecewise quadratic, G piecewise cubic in s, and Simpson's rule is exact for both. Shear is left
/// out (slender shafts).
///
/// With many segments or rests the same integrals are taken as running sums along the shaft: with
/// the moment M_s under a load, unit force or evenly spread, the shaft bends at x by
///
///     centres: (1-x/L) integral_0^x xi M_s/(E I) + (x/L) integral_x^L (L-xi) M_s/(E I)
///     chuck:   y(x), y' = integral_0^x M_s/(E I)
///
/// Every term is positive, so nothing cancels and the sums agree with the integrals to rounding.
/// The rests remain the Cholesky factor of 1/k + g(p,p'). (A stiffness matrix of the shaft's joints
/// would be banded, but its condition rises with the fourth power of the number of segments: 1,000
/// of them would leave four of sixteen digits.)
class Compliance {
public:
    /// A stop leaves out the remaining rests; the object must not be used afterwards.
    explicit Compliance(ShaftModel model, const std::stop_token& stop = {});

    /// L_s, the sum of the segments [mm].
    double length() const { return m_joints.back(); }

    /// G(x,s) [mm/N]; G(x,s) = G(s,x) to the last bit.
    double between(double x, double s) const;

    /// G(x,s) for each x of `at` (rows) and s of `from` (columns), row by row. Zeros after a stop.
    std::vector<double> rows(const std::vector<double>& at, const std::vector<double>& from,
                             const std::stop_token& stop = {}) const;

    /// gamma(x) = G(x,x) [mm/N].
    double at(double x) const { return between(x, x); }

    /// 1/(to-from) * integral of G(x,s) ds, from <= s <= to [mm/N]: gamma(x) of a plunge cut that
    /// bears evenly on from...to. An interval without length gives G(x,from).
    double mean(double x, double from, double to) const;

    /// The terms of at(x); they add up to it.
    ComplianceParts partsAt(double x) const;

private:
    struct Rest {
        double position;
        double pivot;            // square root of 1/k + g(p,p) with the earlier rests included
        std::vector<double> row; // terms of the earlier rests at p
    };

    class BentLine;

    double onShaft(double x) const;
    bool isLarge() const;
    double springs(double x, double s) const;
    double with(const std::vector<double>& atX, const std::vector<double>& atS, double g) const;
    double moment(double xi, double x) const;
    double bending(double x, double s) const;
    double bare(double x, double s) const;
    double bareMean(double x, double from, double to) const;
    std::vector<double> restTerms(std::vector<double> g) const;
    std::vector<double> restTermsAt(double x) const;

    ShaftModel m_model;
    std::vector<double> m_joints;     // ends of the segments, from 0 to L_s [mm]
    std::vector<double> m_rigidities; // E I of each segment [N mm^2]
    std::vector<Rest> m_rests;        // a Cholesky factor of 1/k + g(p,p'), row by row
};

/// gamma of internal grinding [mm/N]: 1/j_w + 1/j_h + L^3/(3 E I), I = pi d^4/64 [MODEL §6]. The
/// quill is a uniform cantilever from the wheel head's spindle, the force acts at its free end,
/// where the wheel sits; the part is rigid and held in a chuck on the headstock. So gamma is the
/// same at each point of the bore, and between any two of them. Lengths [mm], E [N/mm^2],
/// stiffnesses [N/mm], > 0.
double quillCompliance(double length_mm, double diameter_mm, double youngsModulus_n_mm2,
                       double wheelHead_n_mm, double headstock_n_mm);

/// The parts of γ(x), from the bottom; the part of the steady rests is subtracted.
enum class CompliancePart { wheelHead, headstock, tailstock, bending, rests };

inline constexpr std::array allComplianceParts{CompliancePart::wheelHead, CompliancePart::headstock,
                                               CompliancePart::tailstock, CompliancePart::bending,
                                               CompliancePart::rests};

[[nodiscard]] double valueOf(const ComplianceParts& parts, CompliancePart part); ///< [mm/N]
[[nodiscard]] double sumOf(const ComplianceParts& parts);                        ///< [mm/N]

} // namespace sparkout
