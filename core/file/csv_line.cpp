// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/csv_line.h"

#include "core/printable.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstdio>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

constexpr char backslash = '\\';
constexpr std::size_t codeSize = 5; ///< length of u202E

/// Tabs and line ends are quoted, which every spreadsheet understands.
bool standsInQuotes(unsigned code) {
    return code == '\t' || code == '\n' || code == '\r';
}

/// Whether a character is written as its code. A byte order mark would be taken for that of the
/// file.
bool isWrittenAsCode(unsigned code) {
    constexpr unsigned byteOrderMark = 0xFEFF;
    return (steersTheDisplay(code) && !standsInQuotes(code)) || code == byteOrderMark;
}

std::string codeText(unsigned code) {
    std::array<char, 8> text{};
    std::snprintf(text.data(), text.size(), "\\u%04X", code);
    return text.data();
}

/// The character named by a text such as u202E, if it is one that is written so.
std::optional<unsigned> codeNamed(std::string_view text) {
    if (text.size() < codeSize || text.front() != 'u') {
        return std::nullopt;
    }
    unsigned code = 0;
    constexpr int hexadecimal = 16;
    const char* const end = text.data() + codeSize;
    const auto [read, error] = std::from_chars(text.data() + 1, end, code, hexadecimal);
    const bool isCode =
        error == std::errc() && read == end && (isWrittenAsCode(code) || standsInQuotes(code));
    return isCode ? std::optional(code) : std::nullopt;
}

std::size_t escapesIn(std::string_view text) {
    return std::min(text.find_first_not_of(backslash), text.size());
}

std::string escaped(std::string_view text) {
    std::string cell;
    cell.reserve(text.size());
    while (!text.empty()) {
        const std::size_t escapes = escapesIn(text);
        cell += text.substr(0, escapes);
        text.remove_prefix(escapes);
        const std::size_t size = text.empty() ? 0 : characterBytes(text);
        const unsigned code = size > 0 ? characterCode(text.substr(0, size)) : 0;
        const bool isCode = size > 0 && isWrittenAsCode(code);
        if (isCode || (escapes > 0 && codeNamed(text))) {
            cell.append(escapes, backslash); // doubles each of them before a code
        }
        // Bytes that are not UTF-8 are shown as codes.
        cell += isCode      ? codeText(code)
                : size == 0 ? printable(text.substr(0, 1))
                            : std::string(text.substr(0, size));
        text.remove_prefix(std::min(text.size(), std::max<std::size_t>(size, 1)));
    }
    return cell;
}

std::string_view withoutApostrophes(std::string_view text) {
    return text.substr(std::min(text.find_first_not_of('\''), text.size()));
}

void appendUtf8(std::string& text, unsigned code) {
    constexpr unsigned oneByte = 0x80, twoBytes = 0x800;
    if (code < oneByte) {
        text += static_cast<char>(code);
        return;
    }
    if (code < twoBytes) {
        text += static_cast<char>(0xC0U | code >> 6U);
    } else {
        text += static_cast<char>(0xE0U | code >> 12U);
        text += static_cast<char>(0x80U | (code >> 6U & 0x3FU));
    }
    text += static_cast<char>(0x80U | (code & 0x3FU));
}

bool isMarkedFormula(std::string_view cell) {
    return cell.size() > 1 && cell.front() == '\'' && readsAsFormula(withoutApostrophes(cell));
}

} // namespace

bool readsAsFormula(std::string_view text) {
    return !text.empty() && std::string_view("=+-@\t\r").find(text.front()) != text.npos;
}

std::string csvCell(std::string_view text, char delimiter) {
    const bool isMarked = readsAsFormula(withoutApostrophes(text));
    std::string cell = (isMarked ? "'" : "") + escaped(text);
    const auto isAtEnd = [&cell](char c) { return cell.front() == c || cell.back() == c; };
    const bool isPlain = cell.find_first_of("\"\t\n\r") == cell.npos
                         && cell.find(delimiter) == cell.npos && (cell.empty() || !isAtEnd(' '));
    if (isPlain) {
        return cell;
    }
    for (std::size_t at = 0; (at = cell.find('"', at)) != cell.npos; at += 2) {
        cell.insert(at, 1, '"');
    }
    return '"' + cell + '"';
}

bool isChangedInCell(std::string_view cell) {
    return isMarkedFormula(cell) || cell.find(backslash) != cell.npos;
}

std::string textOfCell(std::string_view cell) {
    cell.remove_prefix(isMarkedFormula(cell) ? 1 : 0);
    std::string text;
    text.reserve(cell.size());
    while (!cell.empty()) {
        const std::size_t escapes = escapesIn(cell);
        cell.remove_prefix(escapes);
        const auto code = escapes > 0 ? codeNamed(cell) : std::nullopt;
        text.append(code ? escapes / 2 : escapes, backslash);
        if (code && escapes % 2 == 1) {
            appendUtf8(text, *code);
            cell.remove_prefix(codeSize);
            continue;
        }
        const std::size_t next = std::min(cell.find(backslash), cell.size());
        text += cell.substr(0, next);
        cell.remove_prefix(next);
    }
    return text;
}

CsvLine& CsvLine::put(std::string_view cell) {
    if (std::exchange(m_hasCells, true)) {
        m_line += m_dialect.delimiter;
    }
    m_line += cell;
    return *this;
}

CsvLine& CsvLine::text(std::string_view text) {
    return put(csvCell(text, m_dialect.delimiter));
}

CsvLine& CsvLine::number(double value) {
    if (!std::isfinite(value)) {
        return put({});
    }
    std::array<char, 32> buffer{};
    char* const end = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value).ptr;
    std::replace(buffer.data(), end, '.', m_dialect.decimal);
    const std::string_view digits(buffer.data(), static_cast<std::size_t>(end - buffer.data()));
    const bool isParted = digits.find(m_dialect.delimiter) != digits.npos;
    return isParted ? put('"' + std::string(digits) + '"') : put(digits);
}

CsvLine& CsvLine::whole(std::int64_t value) {
    return put(std::to_string(value));
}

std::string CsvLine::end(std::string_view lineEnd) {
    std::string line = std::exchange(m_line, {});
    const bool isOneEmptyCell = std::exchange(m_hasCells, false) && line.empty();
    return (isOneEmptyCell ? "\"\"" : line) + std::string(lineEnd);
}

} // namespace sparkout
