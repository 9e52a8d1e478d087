// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/iso286.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <string>
#include <utility>

namespace sparkout {

namespace {

constexpr std::size_t ranges = 13;
using ByRange = std::array<double, ranges>;

/// Each range excludes the bound before it and includes its own [mm].
constexpr ByRange upTo{3, 6, 10, 18, 30, 50, 80, 120, 180, 250, 315, 400, 500};

constexpr int finestGrade = 4, coarsestGrade = 14;

/// IT3 (only for the Δ of IT4) to IT14 [µm], ISO 286-1 table 1.
constexpr std::array<ByRange, 12> tolerances{{
    {2, 2.5, 2.5, 3, 4, 4, 5, 6, 8, 10, 12, 13, 15},
    {3, 4, 4, 5, 6, 7, 8, 10, 12, 14, 16, 18, 20},
    {4, 5, 6, 8, 9, 11, 13, 15, 18, 20, 23, 25, 27},
    {6, 8, 9, 11, 13, 16, 19, 22, 25, 29, 32, 36, 40},
    {10, 12, 15, 18, 21, 25, 30, 35, 40, 46, 52, 57, 63},
    {14, 18, 22, 27, 33, 39, 46, 54, 63, 72, 81, 89, 97},
    {25, 30, 36, 43, 52, 62, 74, 87, 100, 115, 130, 140, 155},
    {40, 48, 58, 70, 84, 100, 120, 140, 160, 185, 210, 230, 250},
    {60, 75, 90, 110, 130, 160, 190, 220, 250, 290, 320, 360, 400},
    {100, 120, 150, 180, 210, 250, 300, 350, 400, 460, 520, 570, 630},
    {140, 180, 220, 270, 330, 390, 460, 540, 630, 720, 810, 890, 970},
    {250, 300, 360, 430, 520, 620, 740, 870, 1000, 1150, 1300, 1400, 1550},
}};

/// Fundamental deviations of shafts [µm]: es of d…h, ei of j…p; ISO 286-1 tables 4 and 5.
namespace shafts {
constexpr ByRange d{-20, -30, -40, -50, -65, -80, -100, -120, -145, -170, -190, -210, -230};
constexpr ByRange e{-14, -20, -25, -32, -40, -50, -60, -72, -85, -100, -110, -125, -135};
constexpr ByRange f{-6, -10, -13, -16, -20, -25, -30, -36, -43, -50, -56, -62, -68};
constexpr ByRange g{-2, -4, -5, -6, -7, -9, -10, -12, -14, -15, -17, -18, -20};
constexpr ByRange h{};
constexpr ByRange j5and6{-2, -2, -2, -3, -4, -5, -7, -9, -11, -13, -16, -18, -20};
constexpr ByRange j7{-4, -4, -5, -6, -8, -10, -12, -15, -18, -21, -26, -28, -32};
constexpr ByRange k4to7{0, 1, 1, 1, 2, 2, 2, 3, 3, 4, 4, 4, 5};
constexpr ByRange m{2, 4, 6, 7, 8, 9, 11, 13, 15, 17, 20, 21, 23};
constexpr ByRange n{4, 8, 10, 12, 15, 17, 20, 23, 27, 31, 34, 37, 40};
constexpr ByRange p{6, 12, 15, 18, 22, 26, 32, 37, 43, 50, 56, 62, 68};
} // namespace shafts

/// ES of J6, J7, J8 [µm], ISO 286-1 table 2.
constexpr std::array<ByRange, 3> J6to8{{
    {2, 5, 5, 6, 8, 10, 13, 16, 18, 22, 25, 29, 33},
    {4, 6, 8, 10, 12, 14, 18, 22, 26, 30, 36, 39, 43},
    {6, 10, 12, 15, 20, 24, 28, 34, 41, 47, 55, 60, 66},
}};

std::optional<std::size_t> rangeOf(double nominal) {
    if (!(nominal > 0) || nominal > upTo.back()) {
        return {};
    }
    return static_cast<std::size_t>(std::lower_bound(upTo.begin(), upTo.end(), nominal)
                                    - upTo.begin());
}

double tolerance(int grade, std::size_t range) {
    return tolerances[static_cast<std::size_t>(grade - finestGrade) + 1][range];
}

SizeDeviations below(double upper, double width) {
    return {upper, upper - width};
}
SizeDeviations above(double lower, double width) {
    return {lower + width, lower};
}

std::optional<SizeDeviations> shaft(char letter, int grade, std::size_t range) {
    const double IT = tolerance(grade, range);
    switch (letter) {
    case 'd': return below(shafts::d[range], IT);
    case 'e': return below(shafts::e[range], IT);
    case 'f': return below(shafts::f[range], IT);
    case 'g': return below(shafts::g[range], IT);
    case 'h': return below(shafts::h[range], IT);
    case 'j':
        if (grade < 5 || grade > 7) {
            return {};
        }
        return above((grade == 7 ? shafts::j7 : shafts::j5and6)[range], IT);
    case 'k': return above(grade <= 7 ? shafts::k4to7[range] : 0, IT);
    case 'm': return above(shafts::m[range], IT);
    case 'n': return above(shafts::n[range], IT);
    case 'p': return above(shafts::p[range], IT);
    default: return {};
    }
}

/// ES of K, M, N (to IT8) and P (to IT7): −ei + Δ, Δ = IT_n − IT_(n−1), none up to 3 mm. Coarser
/// grades have −ei, but N none at all (over 3 mm), and K is not used. M6 of 250…315 mm is −9.
std::optional<double> upperOfInterference(char letter, int grade, std::size_t range) {
    const bool smallest = range == 0;
    const int finer = letter == 'P' ? 7 : 8;
    const double Delta = tolerance(grade, range) - tolerance(grade - 1, range);
    const double raised = smallest || grade > finer ? 0 : Delta;
    switch (letter) {
    case 'K':
        if (grade > finer && !smallest) {
            return {};
        }
        return -shafts::k4to7[range] + raised;
    case 'M': return grade == 6 && upTo[range] == 315 ? -9 : -shafts::m[range] + raised;
    case 'N': return grade > finer && !smallest ? 0 : -shafts::n[range] + raised;
    case 'P': return -shafts::p[range] + raised;
    default: return {};
    }
}

std::optional<SizeDeviations> hole(char letter, int grade, std::size_t range) {
    const double IT = tolerance(grade, range);
    if (letter >= 'D' && letter <= 'H') { // holes: EI = −es of the shaft
        const auto mirrored = shaft(static_cast<char>(letter - 'A' + 'a'), grade, range);
        return above(-mirrored->upper_um, IT);
    }
    if (letter == 'J') {
        if (grade < 6 || grade > 8) {
            return {};
        }
        return below(J6to8[static_cast<std::size_t>(grade - 6)][range], IT);
    }
    const auto upper = upperOfInterference(letter, grade, range);
    return upper ? std::optional(below(*upper, IT)) : std::nullopt;
}

/// Removes a token from the front of a text; false if it is not there.
bool take(std::string_view& text, std::string_view token) {
    if (!text.starts_with(token)) {
        return false;
    }
    text.remove_prefix(token.size());
    return true;
}

void skipBlanks(std::string_view& text) {
    while (take(text, " ") || take(text, "\u00a0")) {
    }
}

/// Takes a letter of a tolerance field, as a Latin one.
std::optional<char> takeLetter(std::string_view& text) {
    constexpr std::array<std::pair<std::string_view, char>, 11> lookalikes{{{"Е", 'E'},
                                                                            {"К", 'K'},
                                                                            {"М", 'M'},
                                                                            {"Н", 'H'},
                                                                            {"Р", 'P'},
                                                                            {"Ј", 'J'},
                                                                            {"Ѕ", 'S'},
                                                                            {"е", 'e'},
                                                                            {"к", 'k'},
                                                                            {"м", 'm'},
                                                                            {"р", 'p'}}};
    for (const auto& [cyrillic, latin] : lookalikes) {
        if (take(text, cyrillic)) {
            return latin;
        }
    }
    const char c = text.empty() ? '\0' : text.front();
    if (!(c >= 'a' && c <= 'z') && !(c >= 'A' && c <= 'Z')) {
        return {};
    }
    text.remove_prefix(1);
    return c;
}

template <class Number>
std::optional<Number> takeNumber(std::string_view& text) {
    std::string digits;
    while (!text.empty()
           && ((text.front() >= '0' && text.front() <= '9')
               || (std::is_floating_point_v<
                       Number> && (text.front() == '.' || text.front() == ',')))) {
        digits += text.front() == ',' ? '.' : text.front();
        text.remove_prefix(1);
    }
    Number value{};
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + digits.size(), value);
    const bool whole = error == std::errc() && end == digits.data() + digits.size();
    return whole && digits.size() < 20 ? std::optional(value) : std::nullopt;
}

} // namespace

std::optional<SizeDesignation> parseSizeDesignation(std::string_view text) {
    skipBlanks(text);
    if (take(text, "Ø") || take(text, "⌀") || take(text, "ø")) {
        skipBlanks(text);
    }
    const auto nominal = takeNumber<double>(text);
    skipBlanks(text);
    SizeDesignation found;
    while (const auto letter = takeLetter(text)) {
        found.letters += *letter;
    }
    const auto grade = takeNumber<int>(text);
    skipBlanks(text);
    if (!nominal || found.letters.empty() || found.letters.size() > 2 || !grade || !text.empty()) {
        return {};
    }
    found.nominal_mm = *nominal;
    found.grade = *grade;
    return found;
}

std::optional<KeywayDesignation> parseKeyway(std::string_view text) {
    KeywayDesignation found;
    skipBlanks(text);
    const auto width = takeNumber<double>(text);
    skipBlanks(text);
    const std::string_view rest = text;
    while (const auto letter = takeLetter(text)) {
        if (*letter == 'x' || *letter == 'X') { // the sign between width and length
            text = rest;
            found.field.clear();
            break;
        }
        found.field += *letter;
    }
    if (!found.field.empty()) {
        const auto grade = takeNumber<int>(text);
        if (!grade || found.field.size() > 2) {
            return {};
        }
        found.field += std::to_string(*grade);
        skipBlanks(text);
    }
    if (take(text, "×") || take(text, "x") || take(text, "X") || take(text, "х") || take(text, "Х")
        || take(text, "*")) {
        skipBlanks(text);
        const std::size_t comma = text.find(", "); // else one of the number itself
        std::string_view length = text.substr(0, std::min(comma, text.find(';')));
        text.remove_prefix(length.size());
        found.length_mm = takeNumber<double>(length);
        skipBlanks(length);
        if (!found.length_mm || *found.length_mm <= 0 || !length.empty()) {
            return {};
        }
    }
    if (take(text, ",") || take(text, ";")) {
        skipBlanks(text);
        found.at_deg = takeNumber<double>(text);
        skipBlanks(text);
        if (!found.at_deg || *found.at_deg > 360 || !take(text, "°")) {
            return {};
        }
        skipBlanks(text);
    }
    if (!width || *width <= 0 || !text.empty()) {
        return {};
    }
    found.width_mm = *width;
    return found;
}

std::optional<double> keywayAngle(double width_mm, double diameter_mm) {
    constexpr double halfTurn_deg = 180;
    if (!(width_mm > 0 && width_mm < diameter_mm)) {
        return {};
    }
    return 2 * std::asin(width_mm / diameter_mm) * halfTurn_deg / std::numbers::pi;
}

std::optional<double> standardTolerance(double nominal_mm, int grade) {
    const auto range = rangeOf(nominal_mm);
    if (!range || grade < finestGrade || grade > coarsestGrade) {
        return {};
    }
    return tolerance(grade, *range);
}

std::optional<SizeDeviations> sizeDeviations(const SizeDesignation& designation) {
    const auto range = rangeOf(designation.nominal_mm);
    const int grade = designation.grade;
    if (!range || grade < finestGrade || grade > coarsestGrade) {
        return {};
    }
    constexpr int coarsestOfSmall = 13, finestOfCoarseN = 9;
    const std::string& letters = designation.letters;
    if (designation.nominal_mm <= 1
        && (grade > coarsestOfSmall || (letters == "N" && grade >= finestOfCoarseN))) {
        return {}; // not used up to 1 mm
    }
    if (letters == "js" || letters == "JS") {
        const double half = tolerance(grade, *range) / 2;
        return SizeDeviations{half, -half};
    }
    if (letters.size() != 1) {
        return {};
    }
    return designation.isHole() ? hole(letters[0], grade, *range)
                                : shaft(letters[0], grade, *range);
}

} // namespace sparkout
