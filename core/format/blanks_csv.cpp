// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/format/blanks_csv.h"

#include "core/project/batch.h"
#include "core/trimmed.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>

namespace sparkout {

namespace {

constexpr std::string_view aroundBlank = " \t\r\""; ///< what is no part of a cell

std::vector<std::string_view> cellsOf(std::string_view line, char separator) {
    std::vector<std::string_view> cells;
    while (true) {
        const std::size_t end = line.find(separator);
        cells.push_back(trimmed(line.substr(0, end), aroundBlank));
        if (end == std::string_view::npos) {
            return cells;
        }
        line.remove_prefix(end + 1);
    }
}

std::optional<double> numberOf(std::string_view cell) {
    std::string text(cell);
    std::replace(text.begin(), text.end(), ',', '.');
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    const bool whole = error == std::errc() && end == text.data() + text.size();
    return whole && std::isfinite(value) ? std::optional(value) : std::nullopt;
}

std::optional<FactorKind> factorOf(std::string_view heading) {
    const auto fields = tableOf<Factors>().fields;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        if (heading == fields[i].key) {
            return static_cast<FactorKind>(i);
        }
    }
    return std::nullopt;
}

char separatorOf(std::string_view headings) {
    for (const char separator : {';', '\t'}) {
        if (headings.find(separator) != std::string_view::npos) {
            return separator;
        }
    }
    return ',';
}

/// The lines of a text one by one.
class Lines {
public:
    explicit Lines(std::string_view text) : m_rest(text) {
        constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
        if (m_rest.starts_with(byteOrderMark)) {
            m_rest.remove_prefix(byteOrderMark.size());
        }
    }
    [[nodiscard]] int number() const { return m_number; }
    [[nodiscard]] bool atEnd() const { return m_rest.empty(); }
    std::string_view next() {
        ++m_number;
        const std::size_t end = m_rest.find('\n');
        const std::string_view line = m_rest.substr(0, end);
        m_rest.remove_prefix(end == std::string_view::npos ? m_rest.size() : end + 1);
        return line;
    }

private:
    std::string_view m_rest;
    int m_number = 0;
};

} // namespace

std::variant<std::vector<MeasuredColumn>, TableFault> readMeasuredBlanks(std::string_view csv) {
    Lines lines(csv);
    const std::string_view headings = lines.next();
    const char separator = separatorOf(headings);
    std::vector<MeasuredColumn> columns;
    std::vector<std::size_t> places;
    const auto heads = cellsOf(headings, separator);
    for (std::size_t i = 0; i < heads.size(); ++i) {
        if (const auto kind = factorOf(heads[i])) {
            const bool twice = std::any_of(columns.begin(), columns.end(),
                                           [&](const auto& one) { return one.kind == *kind; });
            if (twice) {
                return TableFault{lines.number(), std::string(heads[i])};
            }
            columns.push_back({*kind, {}});
            places.push_back(i);
        }
    }
    if (columns.empty()) {
        return TableFault{lines.number(), {}};
    }
    while (!lines.atEnd()) {
        const auto cells = cellsOf(lines.next(), separator);
        for (std::size_t c = 0; c < columns.size(); ++c) {
            if (places[c] >= cells.size() || cells[places[c]].empty()) {
                continue;
            }
            const auto value = numberOf(cells[places[c]]);
            if (!value) {
                return TableFault{lines.number(), std::string(cells[places[c]])};
            }
            columns[c].values.push_back(*value);
        }
    }
    return columns;
}

void putMeasured(const std::vector<MeasuredColumn>& columns, Batch& batch) {
    const auto fields = tableOf<Factors>().fields;
    for (const MeasuredColumn& column : columns) {
        const Field& field = fields[static_cast<std::size_t>(column.kind)];
        auto& law = *static_cast<Factor*>(field.object(&batch.factors, true));
        law = {};
        law.measured = column.values;
    }
}

} // namespace sparkout
