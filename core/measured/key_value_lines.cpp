// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/key_value_lines.h"

#include "core/measured/trace_builder.h"
#include "core/tables/table_cell.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <optional>
#include <string>
#include <utility>

namespace sparkout {

namespace {

constexpr char keyDelimiter = '|';

/// An ISO 8601 date and time in seconds; without a zone it is not converted.
std::optional<double> secondsOfDate(std::string_view text) {
    const auto number = [text](std::size_t from, std::size_t size) {
        int value = -1;
        if (from + size <= text.size()) {
            const char* const begin = text.data() + from;
            const auto [end, error] = std::from_chars(begin, begin + size, value);
            value = error == std::errc() && end == begin + size ? value : -1;
        }
        return value;
    };
    constexpr std::size_t wholeSeconds = 19; // 2026-03-04T10:20:30
    if (text.size() < wholeSeconds || text[4] != '-' || text[13] != ':') {
        return std::nullopt;
    }
    const int year = number(0, 4), month = number(5, 2), day = number(8, 2);
    const int hour = number(11, 2), minute = number(14, 2);
    std::string_view rest = text.substr(17);
    rest = rest.substr(0, rest.find_first_of("Z+"));
    const auto seconds = cellNumber(rest, '.');
    const std::chrono::year_month_day date{std::chrono::year(year),
                                           std::chrono::month(static_cast<unsigned>(month)),
                                           std::chrono::day(static_cast<unsigned>(day))};
    if (!date.ok() || hour < 0 || minute < 0 || !seconds) {
        return std::nullopt;
    }
    constexpr double perDay = 86400, perHour = 3600, perMinute = 60;
    return static_cast<double>(std::chrono::sys_days(date).time_since_epoch().count()) * perDay
           + hour * perHour + minute * perMinute + *seconds;
}

class KeyValueReader {
public:
    KeyValueReader(const MeasuredTable& table, const MeasuredContext& context)
        : m_table(table), m_context(context) {
        for (const ColumnMatch& match : table.columns) {
            m_traces.emplace_back(match);
        }
    }

    ReadMeasured read(std::string_view text, const std::stop_token& stop) {
        TableReader rows(text, keyDelimiter);
        constexpr std::size_t rowsBetween = 4096;
        std::size_t looked = 0;
        while (m_read.faults.size() < limits::issues && rows.next()) {
            if (++looked % rowsBetween == 0 && stop.stop_requested()) {
                return {};
            }
            if (!rows.isBlank()) {
                m_cells = rows.cells();
                readLine(rows.line());
            }
        }
        for (TraceBuilder& trace : m_traces) {
            if (!trace.empty()) {
                m_read.data.traces.push_back(trace.take(m_context));
            }
        }
        return std::move(m_read);
    }

private:
    void fault(std::size_t line, std::size_t column, IssueCode code, Detail value, Detail limit) {
        m_read.faults.push_back(
            {line, column, {code, Severity::error, {}, std::move(value), std::move(limit)}});
    }

    void readLine(std::size_t line) {
        if (m_cells.size() < 3 || m_cells.size() % 2 == 0) {
            fault(line, 0, IssueCode::wrongCount, countOf(m_cells.size()), countOf(3));
            return;
        }
        const auto time = timeOf(m_cells.front());
        if (!time) {
            fault(line, 1, IssueCode::wrongType, quotedCell(m_cells.front()), Phrase::number);
            return;
        }
        if (*time < m_lastTime) {
            fault(line, 1, IssueCode::outOfRange, Amount{*time, "s"},
                  Bounds{.range = {.low = m_lastTime}, .unit = "s"});
            return;
        }
        m_lastTime = *time;
        ++m_read.rows;
        for (std::size_t c = 1; c + 1 < m_cells.size(); c += 2) {
            readPair(line, c, *time);
        }
    }

    void readPair(std::size_t line, std::size_t key, double time) {
        const auto match = std::ranges::find(m_table.columns, m_cells[key], &ColumnMatch::heading);
        const std::string_view cell = m_cells[key + 1];
        if (match == m_table.columns.end() || !isTrace(match->quantity) || cell.empty()
            || cell == "UNAVAILABLE") {
            return;
        }
        const auto value = cellNumber(cell, m_table.dialect.decimal);
        const auto factor = factorOf(match->quantity, match->unit);
        const Bounds bounds = boundsOf(match->quantity);
        if (!value) {
            fault(line, key + 2, IssueCode::wrongType, quotedCell(cell), Phrase::number);
        } else if (!factor) {
            fault(line, key + 1, IssueCode::notOneOf, quotedCell(match->heading),
                  unitsFor(match->quantity));
        } else if (!bounds.range.contains(*value * *factor)) {
            fault(line, key + 2, IssueCode::outOfRange, Amount{*value * *factor}, bounds);
        } else {
            m_traces[static_cast<std::size_t>(match - m_table.columns.begin())].add(
                time, *value * *factor);
        }
    }

    /// Dates are relative to the first one.
    std::optional<double> timeOf(std::string_view cell) {
        if (const auto seconds = cellNumber(cell, m_table.dialect.decimal)) {
            return seconds;
        }
        const auto date = secondsOfDate(cell);
        if (date && !m_firstDate) {
            m_firstDate = date;
        }
        return date ? std::optional(*date - *m_firstDate) : std::nullopt;
    }

    const MeasuredTable& m_table;
    const MeasuredContext& m_context;
    std::vector<TraceBuilder> m_traces;
    std::vector<std::string_view> m_cells;
    std::optional<double> m_firstDate;
    double m_lastTime = -1e300;
    ReadMeasured m_read;
};

} // namespace

std::vector<ColumnMatch> matchKeys(std::string_view text) {
    constexpr int rowsLookedAt = 1000;
    std::vector<ColumnMatch> matches;
    TableReader rows(text, keyDelimiter);
    for (int i = 0; i < rowsLookedAt && rows.next(); ++i) {
        const std::vector<std::string_view>& cells = rows.cells();
        for (std::size_t c = 1; c + 1 < cells.size(); c += 2) {
            if (std::ranges::find(matches, cells[c], &ColumnMatch::heading) == matches.end()) {
                matches.push_back(matchHeading(cells[c]));
            }
        }
    }
    for (ColumnMatch& match : matches) {
        if (match.quantity == ColumnQuantity::diameter) {
            match.quantity = ColumnQuantity::gauge_size;
        }
    }
    return matches;
}

ReadMeasured readKeyValueLines(std::string_view text, const MeasuredTable& table,
                               const MeasuredContext& context, const std::stop_token& stop) {
    return KeyValueReader(table, context).read(text, stop);
}

} // namespace sparkout
