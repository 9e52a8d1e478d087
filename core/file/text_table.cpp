// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/text_table.h"

#include "core/digits.h"
#include "core/file/csv_line.h"
#include "core/printable.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <system_error>

namespace sparkout {

namespace {

struct UnitName {
    std::string_view text;
    ColumnUnit unit;
};

constexpr auto unitNames = std::to_array<UnitName>({
    {"mm", ColumnUnit::mm},   {"мм", ColumnUnit::mm},   {"um", ColumnUnit::um},
    {"µm", ColumnUnit::um},   {"μm", ColumnUnit::um},   {"мкм", ColumnUnit::um},
    {"s", ColumnUnit::s},     {"sec", ColumnUnit::s},   {"с", ColumnUnit::s},
    {"сек", ColumnUnit::s},   {"ms", ColumnUnit::ms},   {"мс", ColumnUnit::ms},
    {"min", ColumnUnit::min}, {"мин", ColumnUnit::min}, {"kw", ColumnUnit::kw},
    {"квт", ColumnUnit::kw},  {"w", ColumnUnit::w},     {"вт", ColumnUnit::w},
    {"n", ColumnUnit::n},     {"н", ColumnUnit::n},     {"kn", ColumnUnit::kn},
    {"кн", ColumnUnit::kn},   {"a", ColumnUnit::a},     {"а", ColumnUnit::a},
});

} // namespace

std::optional<double> cellNumber(std::string_view cell, char decimal) {
    constexpr std::string_view minus = "\xE2\x88\x92"; // U+2212
    constexpr std::size_t longest = 60;
    std::array<char, longest> digits{};
    std::size_t size = 0;
    cell = trimmed(cell, " \t\r\n");
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
        --end; // inside a character
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

std::optional<ColumnUnit> unitNamed(std::string_view text) {
    const std::string lower = lowerCase(text);
    const auto* const found = std::ranges::find(unitNames, lower, &UnitName::text);
    return found == unitNames.end() ? std::nullopt : std::optional(found->unit);
}

std::string_view nameOf(ColumnUnit unit) {
    const auto* const found = std::ranges::find(unitNames, unit, &UnitName::unit);
    return found == unitNames.end() ? std::string_view() : found->text;
}

namespace {

constexpr char quotationMark = '"';

/// Statistics of the first rows for a delimiter.
struct Marks {
    int rows = 0;
    int parted = 0;             ///< delimiters between cells
    int commas = 0, points = 0; ///< between digits, within cells
    std::vector<std::string> heads;

    [[nodiscard]] char decimal() const { return commas > points ? ',' : '.'; }
};

Marks marksOf(std::string_view text, char delimiter) {
    constexpr int rowsLookedAt = 60;
    Marks marks;
    TableReader rows(text, delimiter);
    while (marks.rows < rowsLookedAt && rows.next()) {
        if (marks.heads.empty()) {
            marks.heads.assign(rows.cells().begin(), rows.cells().end());
        }
        marks.rows += rows.isBlank() ? 0 : 1;
        // A delimiter that splits quoted cells is not one.
        marks.parted += rows.hasStrayMark() ? 0 : static_cast<int>(rows.cells().size()) - 1;
        for (const std::string_view cell : rows.cells()) {
            for (std::size_t i = 1; i + 1 < cell.size(); ++i) {
                const bool isBetween = isDecimalDigit(cell[i - 1]) && isDecimalDigit(cell[i + 1]);
                marks.commas += isBetween && cell[i] == ',' ? 1 : 0;
                marks.points += isBetween && cell[i] == '.' ? 1 : 0;
            }
        }
    }
    return marks;
}

} // namespace

TableDialect dialectOf(std::string_view text) {
    for (const char delimiter : {'\t', ';', '|'}) {
        const Marks marks = marksOf(text, delimiter);
        // At least once in nearly every row.
        if (marks.parted >= std::max(1, marks.rows - 1)) {
            return {delimiter, marks.decimal()};
        }
    }
    const Marks marks = marksOf(text, ',');
    // "Diameter, mm" above 29,991: the comma of a heading precedes only a unit.
    const bool isOneColumn =
        marks.heads.size() == 1
        || (marks.heads.size() == 2 && unitNamed(marks.heads[1]) && marks.points == 0);
    return isOneColumn ? TableDialect{';', marksOf(text, ';').decimal()}
                       : TableDialect{',', marks.decimal()};
}

TableReader::TableReader(std::string_view text, char delimiter, Spaces spaces)
    : m_text(text), m_delimiter(delimiter), m_spaces(spaces) {}

bool TableReader::isEmpty() const {
    return std::all_of(m_cells.begin(), m_cells.end(),
                       [](std::string_view cell) { return cell.empty(); });
}

bool TableReader::next() {
    m_cells.clear();
    if (m_at >= m_text.size()) {
        return false;
    }
    m_line = m_nextLine;
    m_places.clear();
    m_unescaped.clear();
    m_hasStrayMark = false;
    readCell();
    while (m_at < m_text.size() && m_text[m_at] == m_delimiter) {
        ++m_at;
        readCell();
    }
    skipLineEnd();
    unescapeCells();
    return true;
}

void TableReader::readCell() {
    const std::size_t open = behindSpaces(m_at);
    if (open < m_text.size() && m_text[open] == quotationMark) {
        if (const std::size_t close = closingMark(open); close != m_text.npos) {
            readQuoted(open, close);
            return;
        }
        m_hasStrayMark = true;
    }
    const std::size_t from = m_at;
    while (!endsCell(m_at)) {
        ++m_at;
    }
    std::string_view cell = m_text.substr(from, m_at - from);
    if (m_spaces == Spaces::trimmed) {
        cell = trimmed(cell, " \t");
    }
    const auto at = cell.empty() ? from : static_cast<std::size_t>(cell.data() - m_text.data());
    m_places.push_back({at, cell.size(), false});
}

void TableReader::readQuoted(std::size_t open, std::size_t close) {
    const std::string_view inside = m_text.substr(open + 1, close - open - 1);
    for (std::size_t i = 0; i < inside.size(); ++i) {
        const bool isPair = inside[i] == '\r' && i + 1 < inside.size() && inside[i + 1] == '\n';
        m_nextLine += (inside[i] == '\n' || inside[i] == '\r') && !isPair ? 1 : 0;
    }
    m_at = behindSpaces(close + 1);
    if (inside.find(quotationMark) == inside.npos) {
        m_places.push_back({open + 1, inside.size(), false});
        return;
    }
    const std::size_t from = m_unescaped.size();
    for (std::size_t i = 0; i < inside.size(); ++i) {
        m_unescaped += inside[i];
        i += inside[i] == quotationMark ? 1 : 0; // it is doubled
    }
    m_places.push_back({from, m_unescaped.size() - from, true});
}

/// The position of the closing quotation mark; npos if the first one does not open a quoted cell.
std::size_t TableReader::closingMark(std::size_t open) const {
    std::size_t at = open + 1;
    const std::size_t last = std::min(m_text.size(), at + limits::cellBytes);
    while (true) {
        const std::string_view left = m_text.substr(at, last - at);
        const std::size_t mark = left.find(quotationMark);
        if (mark == left.npos) {
            return m_text.npos;
        }
        at += mark;
        if (at + 1 < last && m_text[at + 1] == quotationMark) {
            at += 2;
            continue;
        }
        return endsCell(behindSpaces(at + 1)) ? at : m_text.npos;
    }
}

std::size_t TableReader::behindSpaces(std::size_t at) const {
    if (m_spaces == Spaces::trimmed) {
        while (at < m_text.size() && m_text[at] != m_delimiter
               && (m_text[at] == ' ' || m_text[at] == '\t')) {
            ++at;
        }
    }
    return at;
}

bool TableReader::endsCell(std::size_t at) const {
    return at >= m_text.size() || m_text[at] == m_delimiter || m_text[at] == '\n'
           || m_text[at] == '\r';
}

void TableReader::skipLineEnd() {
    const std::string_view rest = m_text.substr(std::min(m_at, m_text.size()));
    ++m_nextLine;
    // The first occurs in a text whose CR LF was written as text again.
    for (const std::string_view end : {"\r\r\n", "\r\n", "\r", "\n"}) {
        if (rest.starts_with(end)) {
            m_at += end.size();
            return;
        }
    }
}

void TableReader::unescapeCells() {
    // Pointers are taken after all growing.
    for (Place& place : m_places) {
        const std::string_view source = place.isUnescaped ? std::string_view(m_unescaped) : m_text;
        const std::string_view cell = source.substr(place.from, place.size);
        if (isChangedInCell(cell)) {
            const std::string text = textOfCell(cell);
            place = {m_unescaped.size(), text.size(), true};
            m_unescaped += text;
        }
    }
    for (const Place& place : m_places) {
        const std::string_view source = place.isUnescaped ? std::string_view(m_unescaped) : m_text;
        m_cells.push_back(source.substr(place.from, place.size));
    }
}

} // namespace sparkout
