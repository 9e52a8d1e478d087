// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/wheel.h"

#include "core/digits.h"
#include "core/project/conditions.h"
#include "core/project/validate.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <iterator>
#include <numbers>
#include <utility>

namespace sparkout {

namespace {

/// Converts to capitals; a Cyrillic letter that looks like a Latin one becomes that letter.
std::string inLatin(std::string_view text) {
    constexpr std::pair<std::string_view, char> alike[] = {
        {"А", 'A'}, {"В", 'B'}, {"Е", 'E'}, {"К", 'K'}, {"М", 'M'},     {"Н", 'H'},
        {"О", 'O'}, {"Р", 'P'}, {"С", 'C'}, {"Т", 'T'}, {"Х", 'X'},     {"Л", 'L'},
        {"Ф", 'F'}, {"а", 'A'}, {"в", 'B'}, {"е", 'E'}, {"к", 'K'},     {"м", 'M'},
        {"н", 'H'}, {"о", 'O'}, {"р", 'P'}, {"с", 'C'}, {"т", 'T'},     {"х", 'X'},
        {"л", 'L'}, {"ф", 'F'}, {"×", 'X'}, {",", '.'}, {"\u00a0", ' '}};
    std::string out;
    for (std::size_t i = 0; i < text.size();) {
        const auto found = std::find_if(std::begin(alike), std::end(alike), [&](const auto& pair) {
            return text.substr(i, pair.first.size()) == pair.first;
        });
        if (found != std::end(alike)) {
            out += found->second;
            i += found->first.size();
        } else {
            const char c = text[i++];
            out += c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
        }
    }
    return out;
}
bool isLetter(char c) {
    return c >= 'A' && c <= 'Z';
}

/// Reads from left to right; each function takes its part if it is there, or else changes nothing.
class Scanner {
public:
    explicit Scanner(std::string text) : m_text(std::move(text)) {}

    void skipSpace() {
        while (m_at < m_text.size() && m_text[m_at] == ' ') {
            ++m_at;
        }
    }
    [[nodiscard]] bool done() {
        skipSpace();
        return m_at == m_text.size();
    }
    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return m_at + ahead < m_text.size() ? m_text[m_at + ahead] : '\0';
    }
    bool take(std::string_view word) {
        const bool here = m_text.compare(m_at, word.size(), word) == 0;
        m_at += here ? word.size() : 0;
        return here;
    }
    std::optional<double> number() {
        double value = 0;
        const char* begin = m_text.data() + m_at;
        const auto [end, error] =
            std::from_chars(begin, m_text.data() + m_text.size(), value, std::chars_format::fixed);
        if (error != std::errc() || !isDecimalDigit(*begin)) {
            return std::nullopt;
        }
        m_at += static_cast<std::size_t>(end - begin);
        return value;
    }
    std::optional<int> wholeNumber(std::size_t mostDigits) {
        int value = 0;
        std::size_t digits = 0;
        while (digits < mostDigits && isDecimalDigit(peek(digits))) {
            value = 10 * value + (peek(digits++) - '0');
        }
        if (digits == 0 || isDecimalDigit(peek(digits))) {
            return std::nullopt;
        }
        m_at += digits;
        return value;
    }
    char letter() { return isLetter(peek()) ? m_text[m_at++] : '\0'; }
    std::size_t place() const { return m_at; }
    void back(std::size_t place) { m_at = place; }

private:
    std::string m_text;
    std::size_t m_at = 0;
};

/// "1 500x50x203": the type may lead, the bore may be missing.
void readSizes(Scanner& scan, WheelMarking& marking) {
    const std::size_t start = scan.place();
    for (const bool withType : {true, false}) {
        scan.back(start);
        scan.skipSpace();
        if (withType && (!scan.wholeNumber(2) || scan.peek() != ' ')) {
            continue;
        }
        scan.skipSpace();
        const auto diameter = scan.number();
        if (!diameter || !scan.take("X")) {
            continue;
        }
        const auto width = scan.number();
        if (!width) {
            continue;
        }
        const auto bore = scan.take("X") ? scan.number() : std::nullopt;
        marking.diameter_mm = diameter;
        marking.width_mm = width;
        marking.bore_mm = bore;
        return;
    }
    scan.back(start);
}

/// "25A" or "63C": one to three digits, one or two letters; a plain "A" or "C" too.
bool readAbrasive(Scanner& scan, WheelMarking& marking) {
    scan.skipSpace();
    for (int digits = 0; digits < 3 && isDecimalDigit(scan.peek()); ++digits) {
        marking.abrasive += scan.peek();
        scan.take(std::string_view(&marking.abrasive.back(), 1));
    }
    const char letter = scan.letter();
    if (letter != 'A' && letter != 'C') {
        return false;
    }
    marking.abrasive += letter == 'A' ? "А" : "С";
    return true;
}

bool readBond(Scanner& scan, WheelMarking& marking) {
    scan.skipSpace();
    for (const char* bond : {"V", "BF", "B", "RF", "R", "E", "MG", "PL"}) {
        if (scan.take(bond)) {
            marking.bond = bond;
            return true;
        }
    }
    return false;
}

/// Skips "35 м/с" or "50" and the classes of accuracy and balance that follow.
void readSpeed(Scanner& scan, WheelMarking& marking) {
    const std::size_t start = scan.place();
    scan.skipSpace();
    marking.speed_m_s = scan.number();
    scan.skipSpace();
    if (scan.take("KL")) { // it was the class, not the speed
        scan.take(".");
        marking.speed_m_s.reset();
        return;
    }
    if (!marking.speed_m_s) {
        scan.back(start);
        return;
    }
    if (!scan.take("M/C")) {
        scan.take("M/S");
    }
    scan.skipSpace();
    const std::size_t afterSpeed = scan.place();
    if (!(scan.wholeNumber(1) && (scan.skipSpace(), scan.take("KL")))) {
        scan.back(afterSpeed);
    } else {
        scan.take(".");
    }
}

constexpr std::pair<int, int> grains_um[] = { // F grit, mean size
    {16, 1230}, {20, 1040}, {22, 885},  {24, 745}, {30, 625}, {36, 525},
    {40, 438},  {46, 370},  {54, 310},  {60, 260}, {70, 218}, {80, 185},
    {90, 154},  {100, 129}, {120, 109}, {150, 82}, {180, 69}, {220, 58}};

} // namespace

std::optional<double> grainOfGrit(int grit) {
    for (const auto& [number, size_um] : grains_um) {
        if (number == grit) {
            return size_um / 1000.0;
        }
    }
    return std::nullopt;
}

double grainShareOfStructure(int structure) {
    return (62 - 2 * structure) / 100.0;
}

std::optional<WheelMarking> readWheelMarking(std::string_view text) {
    constexpr std::size_t longest = 200;
    if (text.size() > longest) {
        return std::nullopt;
    }
    WheelMarking marking;
    Scanner scan(inLatin(text));
    readSizes(scan, marking);
    if (!readAbrasive(scan, marking)) {
        return std::nullopt;
    }
    scan.skipSpace();
    const int grit = scan.take("F") ? scan.wholeNumber(4).value_or(0) : 0;
    scan.skipSpace();
    marking.hardness = scan.letter();
    if (!grainOfGrit(grit) || marking.hardness == '\0') {
        return std::nullopt;
    }
    marking.grit = grit;
    scan.skipSpace();
    marking.structure = scan.wholeNumber(2);
    constexpr int mostOpen = 20;
    if ((marking.structure && *marking.structure > mostOpen) || !readBond(scan, marking)) {
        return std::nullopt;
    }
    readSpeed(scan, marking);
    return scan.done() ? std::optional(std::move(marking)) : std::nullopt;
}

std::string markingText(const WheelMarking& marking) {
    std::string text;
    if (marking.diameter_mm && marking.width_mm) {
        text = numberText(*marking.diameter_mm) + "×" + numberText(*marking.width_mm);
        text += marking.bore_mm ? "×" + numberText(*marking.bore_mm) + " " : " ";
    }
    text += marking.abrasive + " F" + std::to_string(marking.grit) + ' ' + marking.hardness;
    text += marking.structure ? ' ' + std::to_string(*marking.structure) : std::string();
    text += ' ' + marking.bond;
    return marking.speed_m_s ? text + ' ' + numberText(*marking.speed_m_s) + " м/с" : text;
}

void applyMarking(const WheelMarking& marking, Wheel& wheel) {
    wheel.marking = markingText(marking);
    wheel.grain_mm = grainOfGrit(marking.grit).value_or(wheel.grain_mm);
    if (marking.structure) {
        wheel.grain_share = grainShareOfStructure(*marking.structure);
    }
    wheel.diameter_mm = marking.diameter_mm.value_or(wheel.diameter_mm);
    wheel.width_mm = marking.width_mm.value_or(wheel.width_mm);
    if (marking.speed_m_s) {
        wheel.max_speed_m_s = marking.speed_m_s;
    }
}

namespace {

bool dullnessCounts(const Project& p, const void*) {
    const auto& recipe = p.wheel->force_recipe;
    return !recipe || !recipe->wear_flat_mm;
}

bool isBalanced(const Project& p, const void* owner) {
    return conditions::wheelRunout(p, owner) && !conditions::unbalanced(p, owner);
}
bool hasGrade(const Project& p, const void*) {
    return p.wheel->runout && p.wheel->runout->balance_grade_mm_s;
}

bool isNoAmplitude(const Project& p, const void*) {
    return p.wheel->runout && !p.wheel->runout->amplitude_um;
}

double sineOf(double angle_deg) {
    constexpr double halfTurn_deg = 180;
    return std::sin(angle_deg * std::numbers::pi / halfTurn_deg);
}

} // namespace

RecipeShares recipeShares(const Wheel& wheel, const ForceRecipe& recipe) {
    const double Wg = wheel.grain_share, Wb = wheel.bond_share, dg = wheel.grain_mm;
    RecipeShares shares;
    shares.cuttingGrains_mm2 = recipe.contact_factor * Wg * Wb / ((1 - Wg - Wb) * dg * dg);
    const double balanced = // b_j·n_c of κ = 1
        recipe.grains_per_mm * sineOf(recipe.shear_angle_deg) / 2;
    shares.cutWidth_mm = recipe.cut_width_mm.value_or(balanced / shares.cuttingGrains_mm2);
    const double perMm = shares.cutWidth_mm * shares.cuttingGrains_mm2;
    shares.shear = recipe.cut_width_mm ? perMm / balanced : 1;
    shares.dullness = recipe.wear_flat_mm ? *recipe.wear_flat_mm * perMm : wheel.dullness;
    return shares;
}

template <>
const StructInfo& tableOf<ForceRecipe>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            ForceRecipe, contact_factor, .label = SPARKOUT_NOOP("Input", "Contact factor"),
            .symbol = "k_Y", .hard = {0, 1000, true}, .soft = {0.05, 20}, .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Factor of the number of cutting grains in the contact, "
                                           "of the conditions of grinding; to be calibrated."),
            .formula = "n_c = k_Y·W_g·W_b/((1 − W_g − W_b)·d_g²)", .source = "PEREVERZEV1999"),
        SPARKOUT_FIELD(
            ForceRecipe, grains_per_mm,
            .label = SPARKOUT_NOOP("Input", "Cutting grains per length"), .symbol = "m_D",
            .unit = "1/mm", .hard = {0, 1000, true}, .soft = {0.1, 20}, .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Cutting grains on a millimetre of the wheel's "
                                           "circumference; they set the thickness of a chip."),
            .formula = "a_k = 2·(V_d/V_k)·√(a/D_e)/m_D", .source = "PEREVERZEV1999"),
        SPARKOUT_FIELD(ForceRecipe, shear_angle_deg, .label = SPARKOUT_NOOP("Input", "Shear angle"),
                       .symbol = "β_1", .unit = "°", .hard = {1, 89}, .soft = {15, 60},
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Angle of the plane in which a grain's "
                                                      "chip shears."),
                       .source = "PEREVERZEV1999"),
        SPARKOUT_FIELD(
            ForceRecipe, cut_width_mm, .label = SPARKOUT_NOOP("Input", "Width of a grain's cut"),
            .symbol = "b_j", .unit = "mm", .hard = {0, 10, true}, .soft = {0.001, 1},
            .nullMeaning = SPARKOUT_NOOP("Input", "chips make up the metal removed"),
            .page = Page::wheel,
            .hint =
                SPARKOUT_NOOP("Input", "Width of the cut of one grain. Where it is not given, it "
                                       "is chosen so that the chips add up to the metal removed."),
            .formula = "κ = 2·b_j·n_c/(m_D·sin β_1)", .source = "PEREVERZEV1999"),
        SPARKOUT_FIELD(
            ForceRecipe, wear_flat_mm, .label = SPARKOUT_NOOP("Input", "Length of a wear flat"),
            .symbol = "l_g", .unit = "mm", .hard = {0, 10}, .soft = {0, 0.2},
            .nullMeaning = SPARKOUT_NOOP("Input", "from the dullness"), .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Length of the wear flat of one grain; with it the "
                                           "dullness follows from the recipe."),
            .formula = "η = l_g·b_j·n_c", .source = "PEREVERZEV1999"),
    };
    static const StructInfo info =
        makeTable<ForceRecipe>(SPARKOUT_NOOP("Struct", "Force by the wheel's recipe"), rows);
    return info;
}

template <>
const StructInfo& tableOf<MeasuredRa>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            MeasuredRa, ra_um, .label = SPARKOUT_NOOP("Input", "Measured Ra"), .unit = "µm",
            .hard = {0, 100, true}, .soft = {0.02, 5}, .required = conditions::always,
            .page = Page::wheel, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Ra of a part ground with this wheel, dressed as it is. "
                                           "It sets the roughness calibration."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            MeasuredRa, infeed_um, .label = SPARKOUT_NOOP("Input", "Infeed it was measured at"),
            .symbol = "a", .unit = "µm", .hard = {0, 1000, true}, .soft = {0.05, 50},
            .nullMeaning = SPARKOUT_NOOP("Input", "of the cycle's last feed"), .page = Page::wheel,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Per revolution of the part in a plunge, otherwise per "
                                           "double stroke, at the speeds and diameters stated."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            MeasuredRa, spark_out_steps,
            .label = SPARKOUT_NOOP("Input", "Spark-out it was measured at"), .hard = {0, 1e5},
            .soft = {0, 200}, .nullMeaning = SPARKOUT_NOOP("Input", "as many as in the cycle"),
            .page = Page::wheel, .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input", "Revolutions in a plunge, otherwise double strokes, after that infeed."),
            .formula = "Ra_e = Ra·(½ + ½·exp(−t/τ))", .source = "MODEL-8"),
    };
    static const StructInfo info =
        makeTable<MeasuredRa>(SPARKOUT_NOOP("Struct", "Measured Ra"), rows);
    return info;
}

void keepRunoutForm(std::optional<WheelRunout>& runout, std::string_view key) {
    constexpr std::pair<std::string_view, std::optional<double> WheelRunout::*> forms[] = {
        {"amplitude_um", &WheelRunout::amplitude_um},
        {"unbalance_g_mm", &WheelRunout::unbalance_g_mm},
        {"balance_grade_mm_s", &WheelRunout::balance_grade_mm_s}};
    const auto given = std::ranges::find(forms, key, [](const auto& form) { return form.first; });
    if (!runout || given == std::end(forms) || !(*runout.*(given->second))) {
        return;
    }
    for (const auto& [name, form] : forms) {
        if (name != key) {
            (*runout.*form).reset();
        }
    }
    constexpr double ordinary_kg = 20; // of a wheel of 500 mm with flanges and spindle
    if (runout->balance_grade_mm_s && !runout->rotor_mass_kg) {
        runout->rotor_mass_kg = ordinary_kg;
    }
}

template <>
const StructInfo& tableOf<WheelRunout>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            WheelRunout, amplitude_um, .label = SPARKOUT_NOOP("Input", "Runout amplitude"),
            .symbol = "e", .unit = "µm", .hard = {0, 100, true}, .soft = {0.05, 5},
            .nullMeaning = SPARKOUT_NOOP("Input", "from the unbalance"), .page = Page::wheel,
            .hint =
                SPARKOUT_NOOP("Input", "Half of the total runout of the cutting surface at the "
                                       "working speed, as it has become since the last "
                                       "dressing: a wheel just dressed at that speed has none."),
            .formula = "h = t_П + e·cos ψ − (R_max0 − R_k)", .source = "MODEL-16"),
        SPARKOUT_FIELD(WheelRunout, lobes, .label = SPARKOUT_NOOP("Input", "Waves of the wheel"),
                       .symbol = "L", .hard = {1, 100}, .soft = {1, 10}, .relevant = isBalanced,
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Number of waves around the wheel; 1: the "
                                                      "surface is eccentric."),
                       .formula = "ψ = ψ_0 + 2π·∫L·n_k dt", .source = "MODEL-16"),
        SPARKOUT_FIELD(
            WheelRunout, unbalance_g_mm, .label = SPARKOUT_NOOP("Input", "Unbalance"),
            .symbol = "U", .unit = "g·mm", .hard = {0, 1e6, true}, .soft = {1, 1e4},
            .nullMeaning = SPARKOUT_NOOP("Input", "from the grade, or none"), .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Mass out of balance times its radius, as it has become "
                                           "since the last dressing. It acts as a force on the "
                                           "wheel head, whose stiffness it needs."),
            .formula = "e = U·ω²/(j_w·√((1 − (ω/ω_0)²)²))", .source = "HON174"),
        SPARKOUT_FIELD(
            WheelRunout, balance_grade_mm_s, .label = SPARKOUT_NOOP("Input", "Balance grade"),
            .symbol = "G", .unit = "mm/s", .hard = {0, 4000, true}, .soft = {0.1, 16},
            .nullMeaning = SPARKOUT_NOOP("Input", "not used"), .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Balance quality of the wheel with its spindle, 1 for "
                                           "the drives of grinders, 0.4 for the spindles of "
                                           "precision grinders."),
            .formula = "U = M·G/ω", .source = "ISO21940"),
        SPARKOUT_FIELD(
            WheelRunout, rotor_mass_kg, .label = SPARKOUT_NOOP("Input", "Mass of the rotor"),
            .symbol = "M", .unit = "kg", .hard = {0, 10000, true}, .soft = {0.1, 500},
            .nullMeaning = SPARKOUT_NOOP("Input", "not known"), .required = hasGrade,
            .relevant = isNoAmplitude, .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Mass of the wheel with its flanges and spindle; the "
                                           "balance grade needs it."),
            .formula = "U = M·G/ω", .source = "ISO21940"),
        SPARKOUT_FIELD(
            WheelRunout, phase_deg, .label = SPARKOUT_NOOP("Input", "Phase of the wheel"),
            .symbol = "ψ_0", .unit = "°", .hard = {0, 360}, .page = Page::wheel,
            .hint =
                SPARKOUT_NOOP("Input", "Angle of the runout at the beginning of the cycle; at 0 "
                                       "the wheel stands nearest to the part. In a batch it "
                                       "may scatter over the whole turn."),
            .formula = "ψ = ψ_0 + 2π·∫L·n_k dt", .source = "MODEL-16"),
    };
    static const StructInfo info =
        makeTable<WheelRunout>(SPARKOUT_NOOP("Struct", "Wheel runout"), rows);
    return info;
}

namespace {

Field wheelRunout() {
    return SPARKOUT_FIELD(
        Wheel, runout, .label = SPARKOUT_NOOP("Input", "Wheel runout"),
        .nullMeaning = SPARKOUT_NOOP("Input", "not known"), .sparse = true, .page = Page::wheel,
        .hint =
            SPARKOUT_NOOP("Input", "How far the wheel runs out of true since its last dressing: "
                                   "an amplitude, an unbalance or a balance grade. It prints "
                                   "waves onto the part; not given, the waviness is not known."),
        .formula = "h = t_П + e·cos ψ − (R_max0 − R_k)", .source = "MODEL-16");
}

Field radiusWear() {
    return SPARKOUT_FIELD(
        Wheel, radius_wear_um, .label = SPARKOUT_NOOP("Input", "Wear since the last compensation"),
        .symbol = "w_k", .unit = "µm", .hard = {0, 1e6}, .soft = {0, 200},
        .relevant = conditions::byPosition, .sparse = true, .page = Page::wheel,
        .hint = SPARKOUT_NOOP("Input",
                              "Wheel radius assumed by the position control minus the actual wheel "
                              "radius. Each dressing compensates it: the control is set to the new "
                              "radius. In a set-up the wear of the wheel adds to it."),
        .formula = "h = t_П − w_k − (R_max0 − R_k)", .source = "MODEL-7");
}

} // namespace

template <>
const StructInfo& tableOf<Wheel>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Wheel, marking, .label = SPARKOUT_NOOP("Input", "Marking"), .page = Page::wheel,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Marking of the wheel, for example 25А F60 L 6 V.")),
        SPARKOUT_FIELD(Wheel, diameter_mm, .label = SPARKOUT_NOOP("Input", "Wheel diameter"),
                       .symbol = "D", .unit = "mm", .hard = {0.5, 2000}, .soft = {5, 1100},
                       .required = conditions::always, .page = Page::wheel, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Diameter of the wheel; D_e = d·D/(D ± d) sets the contact "
                                    "length √(a·D_e)."),
                       .source = "MODEL-1"),
        SPARKOUT_FIELD(Wheel, width_mm, .label = SPARKOUT_NOOP("Input", "Wheel width"),
                       .symbol = "B", .unit = "mm", .hard = {0.5, 1000}, .soft = {3, 250},
                       .required = conditions::always, .page = Page::wheel, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Width of the wheel. A plunge wheel covers the ground length."),
                       .formula = "b = min(S_ax/n, B)", .source = "MODEL-1"),
        SPARKOUT_FIELD(Wheel, dullness, .label = SPARKOUT_NOOP("Input", "Dullness"), .symbol = "η",
                       .hard = {0, 1}, .soft = {0.005, 0.25}, .required = conditions::always,
                       .relevant = dullnessCounts, .slider = true, .page = Page::wheel,
                       .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Share of the working surface that is wear flats: 0 is ideally "
                                    "sharp. It drives the friction term k_r = η·σ_i·√D_e/3."),
                       .source = "MODEL-2"),
        radiusWear(),
        SPARKOUT_FIELD(Wheel, grain_mm, .label = SPARKOUT_NOOP("Input", "Grain size"),
                       .symbol = "d_g", .unit = "mm", .hard = {0.001, 5}, .soft = {0.05, 1},
                       .page = Page::wheel, .hint = SPARKOUT_NOOP("Input", "Mean grain size."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, grain_share, .label = SPARKOUT_NOOP("Input", "Grain share"),
                       .symbol = "W_g", .hard = {0.01, 0.6199}, .soft = {0.38, 0.6},
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Share of grain in the wheel's volume."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, bond_share, .label = SPARKOUT_NOOP("Input", "Bond share"),
                       .symbol = "W_b", .hard = {0.001, 0.6}, .soft = {0.02, 0.3},
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Share of bond in the wheel's volume."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Wheel, grain_tip_angle_deg, .label = SPARKOUT_NOOP("Input", "Grain tip angle"),
            .symbol = "φ", .unit = "°", .hard = {1, 89}, .soft = {30, 75}, .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Angle of the grain tips."), .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, dressing_chipping_mm,
                       .label = SPARKOUT_NOOP("Input", "Dressing chipping level"), .symbol = "Δ",
                       .unit = "mm", .hard = {1e-6, 10}, .soft = {0.005, 0.5}, .page = Page::wheel,
                       .hint =
                           SPARKOUT_NOOP("Input", "Depth over which dressing chips the grains."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Wheel, roughness_factor, .label = SPARKOUT_NOOP("Input", "Roughness calibration"),
            .hard = {0, mostRoughnessFactor, true}, .soft = {0.2, 10}, .page = Page::wheel,
            .usual = true,
            .hint =
                SPARKOUT_NOOP("Input", "Measured Ra divided by computed Ra. At 1 it is not known, "
                                       "and Ra is given as a range. A measured Ra sets it."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, grain_surface_energy_j_m2,
                       .label = SPARKOUT_NOOP("Input", "Grain surface energy"), .symbol = "γ_g",
                       .unit = "J/m²", .hard = {0, 1e4, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "self-sharpening not checked"),
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Fracture surface energy of the grain."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, grain_modulus_gpa, .label = SPARKOUT_NOOP("Input", "Grain modulus"),
                       .symbol = "E_g", .unit = "GPa", .hard = {0, 2000, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "self-sharpening not checked"),
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Young's modulus of the grain."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, bond_surface_energy_j_m2,
                       .label = SPARKOUT_NOOP("Input", "Bond surface energy"), .symbol = "γ_b",
                       .unit = "J/m²", .hard = {0, 1e4, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "self-sharpening not checked"),
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Fracture surface energy of the bond."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, bond_modulus_gpa, .label = SPARKOUT_NOOP("Input", "Bond modulus"),
                       .symbol = "E_b", .unit = "GPa", .hard = {0, 2000, true},
                       .nullMeaning = SPARKOUT_NOOP("Input", "self-sharpening not checked"),
                       .page = Page::wheel,
                       .hint = SPARKOUT_NOOP("Input", "Young's modulus of the bond."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Wheel, bond_bridge_mm, .label = SPARKOUT_NOOP("Input", "Bond bridge"), .symbol = "D_b",
            .unit = "mm", .hard = {0, 10, true},
            .nullMeaning = SPARKOUT_NOOP("Input", "from the grain lattice"), .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Diameter of a bond bridge."), .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Wheel, grains_per_mm2, .label = SPARKOUT_NOOP("Input", "Grains per area"),
            .symbol = "n_g", .unit = "1/mm²", .hard = {0, 1e6, true},
            .nullMeaning = SPARKOUT_NOOP("Input", "from the grain lattice"), .page = Page::wheel,
            .hint = SPARKOUT_NOOP("Input", "Grains on a square millimetre of the wheel."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(Wheel, max_speed_m_s, .label = SPARKOUT_NOOP("Input", "Maximum wheel speed"),
                       .symbol = "V_m", .unit = "m/s", .hard = {1, 400}, .soft = {15, 160},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .page = Page::wheel,
                       .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Working speed marked on the wheel, which "
                                                      "the machine may not exceed.")),
        SPARKOUT_FIELD(Wheel, dressing, .label = SPARKOUT_NOOP("Input", "Dressing"), .sparse = true,
                       .page = Page::wheel, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Dressing tool and how it is used, for the "
                                                      "operation card.")),
        SPARKOUT_FIELD(
            Wheel, force_recipe, .label = SPARKOUT_NOOP("Input", "Force by the wheel's recipe"),
            .nullMeaning = SPARKOUT_NOOP("Input", "by the law's coefficients"), .page = Page::wheel,
            .hint = SPARKOUT_NOOP(
                "Input", "The cutting force from grain size and structure, summed over the grains "
                         "in contact, instead of the law for all chips together."),
            .source = "PEREVERZEV1999"),
        SPARKOUT_FIELD(Wheel, measured_ra, .label = SPARKOUT_NOOP("Input", "Measured Ra"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "Ra is an estimate"),
                       .page = Page::wheel, .usual = true,
                       .hint = SPARKOUT_NOOP("Input",
                                             "Ra of a ground part, with the infeed and spark-out "
                                             "that it was measured at."),
                       .source = "MODEL-8"),
        wheelRunout(),
    };
    static const StructInfo info = makeTable<Wheel>(SPARKOUT_NOOP("Struct", "Wheel"), rows);
    return info;
}

} // namespace sparkout
