// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

struct Shaft;

/// Entries in the heads of the operation card and the sketch sheet that no cycle uses. All may be
/// empty.
struct CardEntries {
    std::string part_number;      ///< designation of the part
    std::string document_number;  ///< designation of the card
    std::string operation_number; ///< number of the operation in the route of the part
    std::string letter;           ///< letter of the document
    std::string program;          ///< designation of the NC program
    std::optional<double> mass_kg;
    std::string blank; ///< profile and sizes
    std::optional<double> blank_mass_kg;
};

/// The mass of a shaft by its segments, solid, of steel, to three digits; empty without segments.
/// An estimate: chamfers, keyways and bores are not known.
[[nodiscard]] std::optional<double> steelMass_kg(const Shaft& shaft);

template <>
const StructInfo& tableOf<CardEntries>();

/// The mounting of the part: between two centres, or overhanging from a chuck that clamps the end x
/// = 0.
enum class Mounting { centres, chuck };

enum class Surface { external, internal };
enum class ProfileForm { ellipse, eccentric, lobes, measured };

/// The drawing's tolerances of form and surface; not given: not required.
/// Greatest number of radii of a section, which resolves 300 waves of a wheel, and of all sections
/// together.
inline constexpr int mostRadii = 3600, mostRadiiOfPart = 72'000;
/// An even number for the zones or sections of the project.
[[nodiscard]] int mostRadiiPerSection(const Project& project);

struct Tolerance {
    std::optional<double> roundness_um;     ///< roundness [µm]
    std::optional<double> radial_runout_um; ///< R_max − R_min about the centre axis [µm]
    std::optional<double> cylindricity_um;  ///< [µm]
    std::optional<double> total_runout_um;  ///< [µm]
    std::optional<double> roughness_ra_um;  ///< Ra [µm]
    std::optional<double> waviness_um;      ///< from peak to valley [µm]
};

struct ShaftSegment {
    double length_mm = 100;  ///< [mm]
    double diameter_mm = 30; ///< [mm]
};

struct SteadyRest {
    double position_mm = 0;     ///< from the headstock end of the shaft [mm]
    double stiffness_n_um = 50; ///< [N/µm]
};

/// A range of angle without a surface: a keyway, the space between two splines.
struct SurfaceGap {
    double from_deg = 0;  ///< angle like φ_k [°]
    double width_deg = 0; ///< [°]
};

/// The wheel's spindle extension in internal grinding, a cantilever.
struct Quill {
    double length_mm = 60;   ///< [mm]
    double diameter_mm = 20; ///< [mm]
};

struct Shaft {
    std::vector<ShaftSegment> segments; ///< from the headstock end
    double ground_from_mm = 0;          ///< beginning of the ground length [mm]
    double youngs_modulus_gpa = 210;    ///< E [GPa]
    Mounting mounting = Mounting::centres;
    std::vector<SteadyRest> steady_rests;
    std::optional<Quill> quill;
};

/// The sum of the steps' lengths [mm].
[[nodiscard]] double lengthOf(const Shaft& shaft);

/// The workpiece: drawing, blank, and the body that bends.
struct Part {
    std::string name;
    Surface surface = Surface::external;
    bool blind_bore = false;         ///< a bore with a wall at its headstock end
    double diameter_mm = 30;         ///< d, nominal [mm]
    double upper_deviation_um = 0;   ///< upper deviation from the nominal diameter [µm]
    double lower_deviation_um = -16; ///< lower deviation from the nominal diameter [µm]
    double length_mm = 92;           ///< L_p, ground length [mm]
    double stock_mm = 0.15;          ///< Π, minimum radial stock, per side [mm]
    double initial_runout_mm = 0.02; ///< ΔR = R_max − R_min of the blank [mm]
    int radii_per_section = 36;      ///< K
    ProfileForm profile = ProfileForm::ellipse;
    int lobes = 3;                               ///< n of an n-lobe form
    std::optional<std::vector<double>> radii_um; ///< measured profile, from the largest radius [µm]
    std::vector<SurfaceGap> gaps;             ///< interruptions, constant along the ground length
    std::optional<double> target_diameter_mm; ///< 2·R_t [mm]; not given: middle of the tolerance
    /// δΠ and δ(ΔR) of each zone or section, in addition to those of the part; not given: none [mm]
    std::optional<std::vector<double>> zone_stock_mm, zone_runout_mm;
    Tolerance tolerance;
    Shaft shaft;
};

/// The additional stock and runout of a zone or section [mm].
struct ZoneBlank {
    double stock_mm = 0, runout_mm = 0;
};
/// Zone by zone; empty: all are like the part.
[[nodiscard]] std::vector<ZoneBlank> zoneBlanks(const Part& part);
/// The greatest sum of both additions [mm]; 0 without zones.
[[nodiscard]] double furthestZone_mm(const Part& part);

/// The share of the K radii outside the gaps.
[[nodiscard]] double engagedShare(const Part& part);

/// Minimum and maximum of a measured profile outside the gaps [µm].
[[nodiscard]] Range measuredRange(const Part& part);

/// Marks the radii inside a gap: φ_k in [from, from + width), to 1e-9°.
[[nodiscard]] std::vector<bool> inGaps(const Part& part);

template <>
std::span<const Choice> choicesOf<Surface>();
template <>
std::span<const Choice> choicesOf<ProfileForm>();
template <>
std::span<const Choice> choicesOf<Mounting>();
template <>
const StructInfo& tableOf<Tolerance>();
template <>
const StructInfo& tableOf<ShaftSegment>();
template <>
const StructInfo& tableOf<SteadyRest>();
template <>
const StructInfo& tableOf<SurfaceGap>();
template <>
const StructInfo& tableOf<Quill>();
template <>
const StructInfo& tableOf<Shaft>();
template <>
const StructInfo& tableOf<Part>();

} // namespace sparkout
