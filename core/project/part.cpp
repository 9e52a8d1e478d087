// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/part.h"

#include "core/digits.h"
#include "core/project/conditions.h"
#include "core/project/project.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>

namespace sparkout {

std::optional<double> steelMass_kg(const Shaft& shaft) {
    constexpr double density_kg_mm3 = 7850e-9; // 7,850 kg/m³
    if (shaft.segments.empty()) {
        return std::nullopt;
    }
    double volume_mm3 = 0;
    for (const ShaftSegment& segment : shaft.segments) {
        volume_mm3 +=
            std::numbers::pi / 4 * segment.diameter_mm * segment.diameter_mm * segment.length_mm;
    }
    const double mass_kg = volume_mm3 * density_kg_mm3;
    const double scale = std::pow(10.0, decimalsOf(mass_kg, 3));
    return std::round(mass_kg * scale) / scale;
}

template <>
const StructInfo& tableOf<CardEntries>() {
    static const std::array rows{
        SPARKOUT_FIELD(CardEntries, part_number,
                       .label = SPARKOUT_NOOP("Input", "Designation of the part"), .sparse = true,
                       .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "The number of the drawing.")),
        SPARKOUT_FIELD(CardEntries, document_number,
                       .label = SPARKOUT_NOOP("Input", "Document number"), .sparse = true,
                       .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Designation of the operation card.")),
        SPARKOUT_FIELD(
            CardEntries, operation_number, .label = SPARKOUT_NOOP("Input", "Operation number"),
            .sparse = true, .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Number of the operation in the part's route.")),
        SPARKOUT_FIELD(CardEntries, letter, .label = SPARKOUT_NOOP("Input", "Letter"),
                       .sparse = true, .page = Page::part,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Letter of the document by GOST 3.1102, for example A.")),
        SPARKOUT_FIELD(
            CardEntries, program, .label = SPARKOUT_NOOP("Input", "NC program"), .sparse = true,
            .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Designation of the program of the numerical control.")),
        SPARKOUT_FIELD(
            CardEntries, mass_kg, .label = SPARKOUT_NOOP("Input", "Mass of the part"), .unit = "kg",
            .hard = {0, 100000, true}, .soft = {0.001, 2000},
            .nullMeaning = SPARKOUT_NOOP("Input", "not given"), .page = Page::part,
            .hint = SPARKOUT_NOOP(
                "Input", "Mass by the drawing, or by the steps of the shaft as solid steel.")),
        SPARKOUT_FIELD(
            CardEntries, blank, .label = SPARKOUT_NOOP("Input", "Profile and sizes"),
            .sparse = true, .page = Page::part,
            .hint = SPARKOUT_NOOP(
                "Input", "Profile and sizes of the blank, for example round bar ⌀50 × 325.")),
        SPARKOUT_FIELD(
            CardEntries, blank_mass_kg, .label = SPARKOUT_NOOP("Input", "Mass of the blank"),
            .unit = "kg", .hard = {0, 100000, true}, .soft = {0.001, 2000},
            .nullMeaning = SPARKOUT_NOOP("Input", "not given"), .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Mass of the blank that the part is made of.")),
    };
    static const StructInfo info =
        makeTable<CardEntries>(SPARKOUT_NOOP("Struct", "Operation card"), rows);
    return info;
}

namespace {

bool lobed(const Project& p, const void*) {
    return p.part->profile == ProfileForm::lobes;
}
bool measured(const Project& p, const void*) {
    return p.part->profile == ProfileForm::measured;
}
bool boreWithTravel(const Project& p, const void*) {
    return p.part->surface == Surface::internal && p.operation->travels;
}
bool notMeasured(const Project& p, const void*) {
    return !measured(p, nullptr);
}

} // namespace

double lengthOf(const Shaft& shaft) {
    return std::accumulate(
        shaft.segments.begin(), shaft.segments.end(), 0.0,
        [](double sum, const ShaftSegment& segment) { return sum + segment.length_mm; });
}

std::vector<ZoneBlank> zoneBlanks(const Part& part) {
    const auto size = [](const std::optional<std::vector<double>>& own) {
        return own ? own->size() : 0;
    };
    std::vector<ZoneBlank> zones(std::max(size(part.zone_stock_mm), size(part.zone_runout_mm)));
    for (std::size_t i = 0; i < zones.size(); ++i) {
        zones[i].stock_mm = i < size(part.zone_stock_mm) ? (*part.zone_stock_mm)[i] : 0;
        zones[i].runout_mm = i < size(part.zone_runout_mm) ? (*part.zone_runout_mm)[i] : 0;
    }
    return zones;
}

double furthestZone_mm(const Part& part) {
    const std::vector<ZoneBlank> zones = zoneBlanks(part);
    double furthest = zones.empty() ? 0 : zones.front().stock_mm + zones.front().runout_mm;
    for (const ZoneBlank& zone : zones) {
        furthest = std::max(furthest, zone.stock_mm + zone.runout_mm);
    }
    return furthest;
}

double engagedShare(const Part& part) {
    const std::vector<bool> inside = inGaps(part);
    const auto ground = std::count(inside.begin(), inside.end(), false);
    return static_cast<double>(ground) / static_cast<double>(inside.size());
}

int mostRadiiPerSection(const Project& project) {
    const int inZone = project.operation->travels ? project.zone_sections : 1;
    return std::min(mostRadii, mostRadiiOfPart / (placeCount(project) * inZone) / 2 * 2);
}

Range measuredRange(const Part& part) {
    const std::vector<bool> inside = inGaps(part);
    Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
    for (std::size_t k = 0; part.radii_um && k < part.radii_um->size(); ++k) {
        if (k >= inside.size() || !inside[k]) {
            range.low = std::min(range.low, (*part.radii_um)[k]);
            range.high = std::max(range.high, (*part.radii_um)[k]);
        }
    }
    return range;
}

std::vector<bool> inGaps(const Part& part) {
    constexpr double turn_deg = 360, same_deg = 1e-9;
    std::vector<bool> inside(
        static_cast<std::size_t>(std::clamp(part.radii_per_section, 0, mostRadii))); // unchecked
    for (const SurfaceGap& gap : part.gaps) {
        for (std::size_t k = 0; k < inside.size(); ++k) {
            const double phi = turn_deg * static_cast<double>(k) / part.radii_per_section;
            double beyond = std::fmod(phi - gap.from_deg + turn_deg, turn_deg);
            beyond = beyond > turn_deg - same_deg ? 0 : beyond;
            inside[k] = inside[k] || beyond < gap.width_deg - same_deg;
        }
    }
    return inside;
}

template <>
std::span<const Choice> choicesOf<Surface>() {
    static const std::array choices{Choice{"external", SPARKOUT_NOOP("Choice", "external (shaft)")},
                                    Choice{"internal", SPARKOUT_NOOP("Choice", "internal (bore)")}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<ProfileForm>() {
    static const std::array choices{
        Choice{"ellipse", SPARKOUT_NOOP("Choice", "ellipse")},
        Choice{"eccentric", SPARKOUT_NOOP("Choice", "eccentric circle")},
        Choice{"lobes", SPARKOUT_NOOP("Choice", "lobed")},
        Choice{"measured", SPARKOUT_NOOP("Choice", "measured")}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<Mounting>() {
    static const std::array choices{Choice{"centres", SPARKOUT_NOOP("Choice", "between centres")},
                                    Choice{"chuck", SPARKOUT_NOOP("Choice", "in a chuck")}};
    return choices;
}

template <>
const StructInfo& tableOf<Tolerance>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Tolerance, roundness_um, .label = SPARKOUT_NOOP("Input", "Roundness"), .symbol = "Δ_r",
            .unit = "µm", .hard = {0, 1000, true}, .soft = {0.1, 100},
            .nullMeaning = SPARKOUT_NOOP("Input", "not required"), .page = Page::part,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Maximum roundness deviation the drawing allows."),
            .source = "ISO12181"),
        SPARKOUT_FIELD(
            Tolerance, radial_runout_um, .label = SPARKOUT_NOOP("Input", "Radial runout"),
            .symbol = "Δ_b", .unit = "µm", .hard = {0, 1000, true}, .soft = {0.1, 100},
            .nullMeaning = SPARKOUT_NOOP("Input", "not required"), .page = Page::part,
            .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input",
                "Maximum R_max − R_min of a section about the centre axis the drawing allows."),
            .source = "MODEL-7"),
        SPARKOUT_FIELD(
            Tolerance, cylindricity_um, .label = SPARKOUT_NOOP("Input", "Cylindricity"),
            .symbol = "Δ_c", .unit = "µm", .hard = {0, 1000, true}, .soft = {0.1, 100},
            .nullMeaning = SPARKOUT_NOOP("Input", "not required"), .page = Page::part,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Maximum cylindricity deviation the drawing allows."),
            .source = "ISO12180"),
        SPARKOUT_FIELD(
            Tolerance, total_runout_um, .label = SPARKOUT_NOOP("Input", "Total radial runout"),
            .symbol = "Δ_t", .unit = "µm", .hard = {0, 1000, true}, .soft = {0.1, 100},
            .nullMeaning = SPARKOUT_NOOP("Input", "not required"), .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Maximum radial runout over the whole ground length."),
            .source = "MODEL-7"),
        SPARKOUT_FIELD(
            Tolerance, roughness_ra_um, .label = SPARKOUT_NOOP("Input", "Roughness"),
            .symbol = "Ra", .unit = "µm", .hard = {0, 100, true}, .soft = {0.05, 6.3},
            .nullMeaning = SPARKOUT_NOOP("Input", "not required"), .page = Page::part,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Maximum arithmetic mean roughness the drawing allows."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Tolerance, waviness_um, .label = SPARKOUT_NOOP("Input", "Waviness"), .symbol = "W",
            .unit = "µm", .hard = {0, 1000, true}, .soft = {0.1, 20},
            .nullMeaning = SPARKOUT_NOOP("Input", "not required"), .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Maximum height of the waves around the part, from peak "
                                           "to valley. It is decided where the runout of the wheel "
                                           "is given."),
            .formula = "W = e·(1 − cos(π/q)), L·n_k/n = p/q", .source = "MODEL-16"),
    };
    static const StructInfo info =
        makeTable<Tolerance>(SPARKOUT_NOOP("Struct", "Tolerances"), rows);
    return info;
}

template <>
const StructInfo& tableOf<ShaftSegment>() {
    static const std::array rows{
        SPARKOUT_FIELD(ShaftSegment, length_mm, .label = SPARKOUT_NOOP("Input", "Segment length"),
                       .symbol = "l", .unit = "mm", .hard = {0.01, 20000}, .soft = {1, 2000},
                       .required = conditions::always, .page = Page::part, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Length of one step of the shaft, from the headstock on."),
                       .column = SPARKOUT_NOOP("InputBrief", "Length"), .source = "MODEL-6"),
        SPARKOUT_FIELD(ShaftSegment, diameter_mm,
                       .label = SPARKOUT_NOOP("Input", "Segment diameter"), .symbol = "d",
                       .unit = "mm", .hard = {0.1, 3000}, .soft = {3, 500},
                       .required = conditions::always, .page = Page::part, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Diameter of one step of the shaft."),
                       .formula = "I = π·d⁴/64", .column = SPARKOUT_NOOP("InputBrief", "Diameter"),
                       .source = "MODEL-6"),
    };
    static const StructInfo info =
        makeTable<ShaftSegment>(SPARKOUT_NOOP("Struct", "Shaft segment"), rows);
    return info;
}

template <>
const StructInfo& tableOf<SteadyRest>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            SteadyRest, position_mm, .label = SPARKOUT_NOOP("Input", "Position of the steady rest"),
            .symbol = "x", .unit = "mm", .hard = {0, 20000}, .required = conditions::always,
            .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Distance from the headstock end of the shaft."),
            .column = SPARKOUT_NOOP("InputBrief", "Position"), .source = "MODEL-6"),
        SPARKOUT_FIELD(SteadyRest, stiffness_n_um,
                       .label = SPARKOUT_NOOP("Input", "Stiffness of the steady rest"),
                       .symbol = "j", .unit = "N/µm", .hard = {1e-3, 1e5}, .soft = {5, 500},
                       .required = conditions::always, .page = Page::part,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Force at the rest for one micrometre of deflection there."),
                       .column = SPARKOUT_NOOP("InputBrief", "Stiffness"), .source = "MODEL-6"),
    };
    static const StructInfo info =
        makeTable<SteadyRest>(SPARKOUT_NOOP("Struct", "Steady rest"), rows);
    return info;
}

template <>
const StructInfo& tableOf<SurfaceGap>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            SurfaceGap, from_deg, .label = SPARKOUT_NOOP("Input", "Gap begins at"), .symbol = "φ_0",
            .unit = "°", .hard = {0, 360}, .required = conditions::always, .page = Page::part,
            .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input",
                "Angle of the gap's first edge, counted as the radii are, from radius 0 on."),
            .column = SPARKOUT_NOOP("InputBrief", "From"), .source = "MODEL-4"),
        SPARKOUT_FIELD(
            SurfaceGap, width_deg, .label = SPARKOUT_NOOP("Input", "Gap width"), .symbol = "Δφ",
            .unit = "°", .hard = {0, 350}, .soft = {0, 120}, .required = conditions::always,
            .page = Page::part, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Angle from edge to edge; of a keyway of width w about "
                                           "115°·w/d. The radii within are not ground."),
            .formula = "φ_0 ≤ φ_k < φ_0 + Δφ", .column = SPARKOUT_NOOP("InputBrief", "Width"),
            .source = "MODEL-4"),
    };
    static const StructInfo info =
        makeTable<SurfaceGap>(SPARKOUT_NOOP("Struct", "Gap of the surface"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Quill>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Quill, length_mm, .label = SPARKOUT_NOOP("Input", "Quill length"), .symbol = "L",
            .unit = "mm", .hard = {0.01, 2000}, .soft = {5, 300}, .required = conditions::always,
            .page = Page::part, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Overhang of the wheel's spindle in internal grinding."),
            .formula = "G(x,x) = 1/j_w + 1/j_h + x³/(3·E·I)", .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Quill, diameter_mm, .label = SPARKOUT_NOOP("Input", "Quill diameter"), .symbol = "d",
            .unit = "mm", .hard = {0.1, 1000}, .soft = {3, 150}, .required = conditions::always,
            .page = Page::part, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Diameter of the wheel's spindle in internal grinding."),
            .formula = "I = π·d⁴/64", .source = "MODEL-6"),
    };
    static const StructInfo info = makeTable<Quill>(SPARKOUT_NOOP("Struct", "Quill"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Shaft>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Shaft, segments, .label = SPARKOUT_NOOP("Input", "Segments of the shaft"),
            .hard = {0, 100}, .relevant = conditions::external, .page = Page::part, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Steps of the shaft from the headstock on; needed when "
                                           "the compliance is computed from the stiffness."),
            .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Shaft, ground_from_mm, .label = SPARKOUT_NOOP("Input", "Ground length begins at"),
            .symbol = "x_0", .unit = "mm", .hard = {0, 20000}, .relevant = conditions::external,
            .page = Page::part, .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input", "Distance from the headstock end of the shaft to the ground length."),
            .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Shaft, youngs_modulus_gpa, .label = SPARKOUT_NOOP("Input", "Modulus of elasticity"),
            .symbol = "E", .unit = "GPa", .hard = {1, 1000}, .soft = {60, 230}, .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Young's modulus of the shaft: steel about 210."),
            .formula = "G_beam(x,x) = x²·(L_s − x)²/(3·E·I·L_s)", .source = "MODEL-6"),
        SPARKOUT_FIELD(Shaft, mounting, .label = SPARKOUT_NOOP("Input", "Mounting"),
                       .relevant = conditions::external, .page = Page::part, .usual = true,
                       .hint =
                           SPARKOUT_NOOP("Input", "Between centres, or overhanging from a chuck."),
                       .source = "MODEL-6"),
        SPARKOUT_FIELD(
            Shaft, steady_rests, .label = SPARKOUT_NOOP("Input", "Steady rests"), .hard = {0, 20},
            .relevant = conditions::external, .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Springs that support the shaft along its length."),
            .source = "MODEL-6"),
        SPARKOUT_FIELD(Shaft, quill, .label = SPARKOUT_NOOP("Input", "Quill"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "none"),
                       .relevant = conditions::internal, .page = Page::part, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "The wheel's spindle in internal grinding, a cantilever."),
                       .source = "MODEL-6"),
    };
    static const StructInfo info = makeTable<Shaft>(SPARKOUT_NOOP("Struct", "Shaft"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Part>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Part, name, .label = SPARKOUT_NOOP("Input", "Part"), .page = Page::part, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Name of the part, as it stands in the drawing.")),
        SPARKOUT_FIELD(
            Part, surface, .label = SPARKOUT_NOOP("Input", "Surface"), .page = Page::part,
            .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input", "External: a shaft. Internal: a bore, ground by a wheel on a quill."),
            .source = "MODEL-3"),
        SPARKOUT_FIELD(
            Part, blind_bore, .label = SPARKOUT_NOOP("Input", "Blind bore"),
            .relevant = boreWithTravel, .sparse = true, .page = Page::part, .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input",
                "A bore with a wall at its headstock end, where the wheel cannot leave it: the "
                "overrun there is 0, or negative where the wheel turns before the wall."),
            .source = "MODEL-5"),
        SPARKOUT_FIELD(Part, diameter_mm, .label = SPARKOUT_NOOP("Input", "Diameter"),
                       .symbol = "d", .unit = "mm", .hard = {1, 2000}, .soft = {3, 500},
                       .required = conditions::always, .page = Page::part, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Nominal diameter of the drawing."),
                       .source = "MODEL-1"),
        SPARKOUT_FIELD(Part, upper_deviation_um, .label = SPARKOUT_NOOP("Input", "Upper deviation"),
                       .symbol = "es", .unit = "µm", .hard = {-5000, 5000}, .soft = {-500, 500},
                       .required = conditions::always, .page = Page::part, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Upper limit of the diameter minus the nominal diameter."),
                       .formula = "D_max = d + es", .source = "MODEL-4"),
        SPARKOUT_FIELD(Part, lower_deviation_um, .label = SPARKOUT_NOOP("Input", "Lower deviation"),
                       .symbol = "ei", .unit = "µm", .hard = {-5000, 5000}, .soft = {-500, 500},
                       .required = conditions::always, .page = Page::part, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Lower limit of the diameter minus the nominal diameter."),
                       .formula = "D_min = d + ei", .source = "MODEL-4"),
        SPARKOUT_FIELD(Part, length_mm, .label = SPARKOUT_NOOP("Input", "Ground length"),
                       .symbol = "L_p", .unit = "mm", .hard = {0.1, 10000}, .soft = {2, 2000},
                       .required = conditions::always, .page = Page::part, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Length of the ground surface."),
                       .source = "MODEL-1"),
        SPARKOUT_FIELD(
            Part, stock_mm, .label = SPARKOUT_NOOP("Input", "Stock per side"), .symbol = "Π",
            .unit = "mm", .hard = {0, 5, true}, .soft = {0.01, 0.6}, .required = conditions::always,
            .slider = true, .page = Page::part, .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input",
                "Minimum radial stock: minimum radius of the blank minus the target radius."),
            .formula = "R_max = R_t + Π + ΔR", .source = "MODEL-4"),
        SPARKOUT_FIELD(Part, initial_runout_mm, .label = SPARKOUT_NOOP("Input", "Initial runout"),
                       .symbol = "ΔR", .unit = "mm", .hard = {0, 2}, .soft = {0, 0.2},
                       .required = conditions::always, .relevant = notMeasured, .slider = true,
                       .page = Page::part, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "R_max − R_min of the blank. R_max = R_t + Π "
                                                      "+ ΔR is where the wheel touches first."),
                       .source = "MODEL-4"),
        SPARKOUT_FIELD(
            Part, radii_per_section, .label = SPARKOUT_NOOP("Input", "Radii per section"),
            .symbol = "K", .hard = {4, mostRadii}, .soft = {12, 1200}, .page = Page::part,
            .hint = SPARKOUT_NOOP(
                "Input", "Radii followed in each cross-section at equal angles, an even number."),
            .formula = "φ_k = 2π·k/K", .source = "MODEL-4"),
        SPARKOUT_FIELD(
            Part, profile, .label = SPARKOUT_NOOP("Input", "Form of the blank"), .page = Page::part,
            .hint = SPARKOUT_NOOP("Input",
                                  "Out-of-roundness of the blank: ellipse R = pq/√((q·cos φ)² + "
                                  "(p·sin φ)²), eccentric circle, n lobes, or a measured profile."),
            .source = "MODEL-4"),
        SPARKOUT_FIELD(
            Part, lobes, .label = SPARKOUT_NOOP("Input", "Lobes"), .symbol = "n_l",
            .hard = {2, 180}, .soft = {2, 30}, .relevant = lobed, .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Number of lobes: R = R_max − ΔR/2·(1 − cos nφ)."),
            .source = "MODEL-4"),
        SPARKOUT_FIELD(
            Part, radii_um, .label = SPARKOUT_NOOP("Input", "Measured profile"), .unit = "µm",
            .hard = {-10000, 10000}, .nullMeaning = SPARKOUT_NOOP("Input", "not measured"),
            .required = measured, .relevant = measured, .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Deviations from the maximum radius at equal angles, "
                                           "one a radius; only their differences matter."),
            .source = "MODEL-4"),
        SPARKOUT_FIELD(
            Part, gaps, .label = SPARKOUT_NOOP("Input", "Gaps of the surface"), .hard = {0, 60},
            .sparse = true, .page = Page::part, .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input", "Keyways, splines, flats: ranges of angle without a surface, the same all "
                         "along the ground length. Their radii are not ground, gauged or judged."),
            .source = "MODEL-4"),
        SPARKOUT_FIELD(
            Part, zone_stock_mm, .label = SPARKOUT_NOOP("Input", "Further stock by zone"),
            .symbol = "δΠ", .unit = "mm", .hard = {-5, 5}, .soft = {-0.2, 0.2},
            .nullMeaning = SPARKOUT_NOOP("Input", "the same everywhere"), .sparse = true,
            .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Difference of the stock per side of each zone or "
                                           "section, in their order, from that of the part."),
            .source = "MODEL-4"),
        SPARKOUT_FIELD(
            Part, zone_runout_mm, .label = SPARKOUT_NOOP("Input", "Further runout by zone"),
            .symbol = "δ(ΔR)", .unit = "mm", .hard = {-5, 5}, .soft = {-0.2, 0.2},
            .nullMeaning = SPARKOUT_NOOP("Input", "the same everywhere"), .sparse = true,
            .page = Page::part,
            .hint = SPARKOUT_NOOP("Input", "Difference of the initial runout of each zone or "
                                           "section, in their order, from that of the part."),
            .source = "MODEL-4"),
        SPARKOUT_FIELD(Part, target_diameter_mm, .label = SPARKOUT_NOOP("Input", "Target diameter"),
                       .symbol = "2R_t", .unit = "mm", .hard = {1, 2000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "middle of the tolerance band"),
                       .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "The diameter the gauge is set to."),
                       .formula = "R_t = d/2 + (es + ei)/4", .source = "MODEL-4"),
        SPARKOUT_FIELD(Part, tolerance, .label = SPARKOUT_NOOP("Input", "Tolerances"),
                       .page = Page::part, .usual = true),
        SPARKOUT_FIELD(Part, shaft, .label = SPARKOUT_NOOP("Input", "Shaft"), .page = Page::part,
                       .usual = true),
    };
    static const StructInfo info = makeTable<Part>(SPARKOUT_NOOP("Struct", "Part"), rows);
    return info;
}

} // namespace sparkout
