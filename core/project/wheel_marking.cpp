// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/wheel_marking.h"

#include "core/digits.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"

#include <algorithm>
#include <charconv>
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

} // namespace sparkout
