// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/table_text.h"

#include "core/digits.h"
#include "core/measured/column_match.h"
#include "core/printable.h"
#include "core/trimmed.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace sparkout {

namespace {

constexpr std::string_view aroundCell = " \t\r"; ///< what is no part of a cell

/// What the first lines have of each character that could take a text apart.
struct Marks {
    int tabs = 0, semicolons = 0, bars = 0, commas = 0;
    int decimalCommas = 0, decimalPoints = 0; ///< between digits
    int quotedCommas = 0;                     ///< the same within quotation marks
    int lines = 0;
};

Marks marksOf(std::string_view text) {
    constexpr int linesLookedAt = 60;
    Marks marks;
    TableLines lines(text);
    while (!lines.atEnd() && marks.lines < linesLookedAt) {
        const std::string_view line = lines.next();
        marks.lines += trimmed(line, aroundCell).empty() ? 0 : 1;
        bool quoted = false;
        for (std::size_t i = 0; i < line.size(); ++i) {
            quoted = quoted != (line[i] == '"');
            const bool between = i > 0 && i + 1 < line.size() && isDecimalDigit(line[i - 1])
                                 && isDecimalDigit(line[i + 1]);
            marks.decimalCommas += line[i] == ',' && between && !quoted ? 1 : 0;
            marks.quotedCommas += line[i] == ',' && between && quoted ? 1 : 0;
            marks.decimalPoints += line[i] == '.' && between ? 1 : 0;
            marks.tabs += line[i] == '\t' && !quoted ? 1 : 0;
            marks.semicolons += line[i] == ';' && !quoted ? 1 : 0;
            marks.bars += line[i] == '|' && !quoted ? 1 : 0;
            marks.commas += line[i] == ',' && !quoted ? 1 : 0;
        }
    }
    return marks;
}

} // namespace

TableDialect dialectOf(std::string_view text) {
    const Marks marks = marksOf(text);
    const char decimal = marks.decimalCommas + marks.quotedCommas > marks.decimalPoints ? ',' : '.';
    // Once or more in nearly every line.
    const auto takesApart = [&marks](int count) { return count >= std::max(1, marks.lines - 1); };
    for (const auto& [count, delimiter] :
         {std::pair(marks.tabs, '\t'), {marks.semicolons, ';'}, {marks.bars, '|'}}) {
        if (takesApart(count)) {
            return {delimiter, decimal};
        }
    }
    // "Diameter, mm" above 29,991: the comma of a heading stands before a unit alone.
    std::vector<std::string_view> heads;
    splitCells(TableLines(text).next(), ',', heads);
    const bool oneColumn = heads.size() == 2 && unitNamed(heads[1]) && marks.decimalPoints == 0;
    if (oneColumn) {
        return {';', ','};
    }
    return {',', marks.quotedCommas > marks.decimalPoints ? ',' : '.'};
}

TableLines::TableLines(std::string_view text) : m_rest(text) {
    constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
    if (m_rest.starts_with(byteOrderMark)) {
        m_rest.remove_prefix(byteOrderMark.size());
    }
}

std::string_view TableLines::next() {
    ++m_number;
    const std::size_t end = m_rest.find('\n');
    const std::string_view line = m_rest.substr(0, end);
    m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
    return line;
}

void splitCells(std::string_view line, char delimiter, std::vector<std::string_view>& cells) {
    cells.clear();
    std::size_t from = 0;
    bool quoted = false;
    const auto add = [&](std::size_t to) {
        std::string_view cell = trimmed(line.substr(from, to - from), aroundCell);
        if (cell.size() >= 2 && cell.front() == '"' && cell.back() == '"') {
            cell = trimmed(cell.substr(1, cell.size() - 2), aroundCell);
        }
        cells.push_back(cell);
        from = to + 1;
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        quoted = quoted != (line[i] == '"');
        if (line[i] == delimiter && !quoted) {
            add(i);
        }
    }
    add(line.size());
}

std::optional<double> cellNumber(std::string_view cell, char decimal) {
    constexpr std::string_view minus = "\xE2\x88\x92"; // U+2212
    constexpr std::size_t longest = 60;
    std::array<char, longest> digits{};
    std::size_t size = 0;
    if (cell.starts_with(minus)) {
        digits[size++] = '-';
        cell.remove_prefix(minus.size());
    } else if (cell.starts_with('+')) {
        cell.remove_prefix(1);
    }
    if (cell.empty() || cell.size() >= longest - 1) {
        return std::nullopt;
    }
    for (const char c : cell) {
        if (c == ',' || c == '.') {
            if (c != decimal) {
                return std::nullopt;
            }
            digits[size++] = '.';
        } else {
            digits[size++] = c;
        }
    }
    double value = 0;
    const auto [end, error] = std::from_chars(digits.data(), digits.data() + size, value);
    const bool whole = error == std::errc() && end == digits.data() + size;
    return whole && std::isfinite(value) ? std::optional(value + 0.0) : std::nullopt;
}

Quoted quotedCell(std::string_view cell) {
    constexpr std::size_t longest = 60;
    std::size_t end = std::min(cell.size(), longest);
    while (end < cell.size() && end > 0
           && (static_cast<unsigned char>(cell[end]) & 0xC0U) == 0x80U) {
        --end; // not inside a character
    }
    const char* const rest = end < cell.size() ? "…" : "";
    return {'"' + printable(cell.substr(0, end)) + rest + '"'};
}

std::string lowerCase(std::string_view text) {
    std::string lower;
    lower.reserve(text.size());
    for (std::size_t i = 0; i < text.size(); ++i) {
        const auto c = static_cast<unsigned char>(text[i]);
        const auto next = i + 1 < text.size() ? static_cast<unsigned char>(text[i + 1]) : 0U;
        if (c >= 'A' && c <= 'Z') {
            lower += static_cast<char>(c + ('a' - 'A'));
        } else if (c == 0xD0 && next >= 0x90 && next <= 0x9F) { // А…П
            lower += {'\xD0', static_cast<char>(next + 0x20)};
            ++i;
        } else if (c == 0xD0 && next >= 0xA0 && next <= 0xAF) { // Р…Я
            lower += {'\xD1', static_cast<char>(next - 0x20)};
            ++i;
        } else if ((c == 0xD0 && next == 0x81) || (c == 0xD1 && next == 0x91)) { // Ё and ё are е
            lower += "\xD0\xB5";
            ++i;
        } else {
            lower += text[i];
        }
    }
    return lower;
}

} // namespace sparkout
