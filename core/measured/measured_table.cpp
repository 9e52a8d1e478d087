// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/measured_table.h"

#include "core/file/text_table.h"
#include "core/units.h"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>

namespace sparkout {

namespace {

TraceQuantity quantityOf(ColumnQuantity quantity) {
    switch (quantity) {
    case ColumnQuantity::wheel_power: return TraceQuantity::wheel_power;
    case ColumnQuantity::spindle_current: return TraceQuantity::spindle_current;
    case ColumnQuantity::normal_force: return TraceQuantity::normal_force;
    default: return TraceQuantity::gauge_size;
    }
}

} // namespace

std::pair<std::vector<double>, std::vector<double>>
thinOut(std::vector<double> times, std::vector<double> values, std::size_t most) {
    const std::size_t count = values.size();
    if (count <= most || most == 0) {
        return {std::move(times), std::move(values)};
    }
    std::pair<std::vector<double>, std::vector<double>> thinned;
    for (std::size_t i = 0; i < most; ++i) {
        const std::size_t begin = count * i / most, end = count * (i + 1) / most;
        // Relative to the first, since sums of long times would lose digits.
        double time = 0, value = 0;
        for (std::size_t k = begin; k < end; ++k) {
            time += times[k] - times[begin];
            value += values[k] - values[begin];
        }
        const auto stretch = static_cast<double>(end - begin);
        thinned.first.push_back(times[begin] + time / stretch);
        thinned.second.push_back(values[begin] + value / stretch);
    }
    return thinned;
}

MeasuredTrace TraceBuilder::take(const MeasuredContext& context) {
    MeasuredTrace trace;
    trace.quantity = quantityOf(m_match->quantity);
    trace.place = m_match->place;
    trace.source = context.source;
    trace.source_samples = static_cast<int>(m_times.size());
    if (trace.quantity == TraceQuantity::spindle_current && context.currentFactor_kw_a > 0) {
        trace.factor_kw_per_a = context.currentFactor_kw_a;
    }
    auto [times, values] = thinOut(std::move(m_times), std::move(m_values), limits::traceSamples);
    trace.time_s = Samples(std::move(times));
    trace.values = Samples(std::move(values));
    m_times.clear();
    m_values.clear();
    return trace;
}

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

/// Reads a table line by line, until there are too many faults.
class MeasuredLineReader {
protected:
    MeasuredLineReader(const MeasuredTable& table, const MeasuredContext& context)
        : m_table(table), m_context(context) {
        for (const ColumnMatch& match : table.columns) {
            m_traces.emplace_back(match);
        }
    }
    ~MeasuredLineReader() = default;

    virtual void readLine(std::size_t line) = 0; ///< from m_cells

    /// Reads the remaining lines; returns nothing after a stop.
    ReadMeasured readLines(TableReader& rows, const std::stop_token& stop) {
        constexpr std::size_t rowsBetween = 4096;
        std::size_t looked = 0;
        while (!isFull() && rows.next()) {
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

    [[nodiscard]] bool isFull() const { return m_read.faults.size() >= limits::issues; }

    void fault(std::size_t line, std::size_t column, IssueCode code, Detail value, Detail limit) {
        if (!isFull()) {
            m_read.faults.push_back(
                {line, column, {code, Severity::error, {}, std::move(value), std::move(limit)}});
        }
    }

    /// Keeps the time of a line; returns false if it is before that of the previous line.
    bool takeTime(std::size_t line, std::size_t column, double time_s) {
        if (time_s < m_lastTime) {
            fault(line, column, IssueCode::outOfRange, Amount{time_s, "s"},
                  Bounds{.range = {.low = m_lastTime}, .unit = "s"});
            return false;
        }
        m_lastTime = time_s;
        return true;
    }

    const MeasuredTable& m_table;
    const MeasuredContext& m_context;
    std::vector<TraceBuilder> m_traces;
    std::vector<std::string_view> m_cells;
    double m_lastTime = -1e300; ///< [s]
    ReadMeasured m_read;
};

class KeyValueReader final : MeasuredLineReader {
public:
    KeyValueReader(const MeasuredTable& table, const MeasuredContext& context)
        : MeasuredLineReader(table, context) {}

    ReadMeasured read(std::string_view text, const std::stop_token& stop) {
        TableReader rows(text, keyDelimiter);
        return readLines(rows, stop);
    }

private:
    void readLine(std::size_t line) override {
        if (m_cells.size() < 3 || m_cells.size() % 2 == 0) {
            fault(line, 0, IssueCode::wrongCount, countOf(m_cells.size()), countOf(3));
            return;
        }
        const auto time = timeOf(m_cells.front());
        if (!time) {
            fault(line, 1, IssueCode::wrongType, quotedCell(m_cells.front()), Phrase::number);
            return;
        }
        if (!takeTime(line, 1, *time)) {
            return;
        }
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

    std::optional<double> m_firstDate;
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

namespace {

class RowReader final : MeasuredLineReader {
public:
    RowReader(const MeasuredTable& table, const MeasuredContext& context)
        : MeasuredLineReader(table, context) {
        for (const ColumnMatch& match : table.columns) {
            m_factors.push_back(factorOf(match.quantity, match.unit).value_or(1));
        }
    }

    ReadMeasured read(std::string_view text, const std::stop_token& stop) {
        TableReader rows(text, m_table.dialect.delimiter);
        (void)rows.next(); // the headings
        if (!columnsAreFit()) {
            return std::move(m_read);
        }
        return readLines(rows, stop);
    }

private:
    /// Whether something is to be read, each with a unit it may have, traces with their times.
    bool columnsAreFit() {
        bool any = false, anyTrace = false;
        for (std::size_t c = 0; c < m_table.columns.size(); ++c) {
            const ColumnMatch& match = m_table.columns[c];
            if (isNumeric(match.quantity) && !factorOf(match.quantity, match.unit)) {
                fault(1, c + 1, IssueCode::notOneOf, quotedCell(match.heading),
                      unitsFor(match.quantity));
            }
            anyTrace = anyTrace || isTrace(match.quantity);
            any = any
                  || (isNumeric(match.quantity) && match.quantity != ColumnQuantity::time
                      && match.quantity != ColumnQuantity::place);
            if (match.quantity == ColumnQuantity::time) {
                m_time = c;
            }
        }
        if (!any) {
            fault(1, 0, IssueCode::missingKey, {},
                  Keys{{"diameter, mm", "roundness, µm", "runout, µm", "Ra, µm", "size, mm",
                        "power, kW", "force, N"},
                       Keys::Kind::alternatives});
        } else if (anyTrace && !m_time) {
            fault(1, 0, IssueCode::missingKey, {}, Keys{{"time, s"}, Keys::Kind::alternatives});
        }
        return m_read.faults.empty();
    }

    void readLine(std::size_t line) override {
        const std::size_t expected = m_table.columns.size();
        if (m_cells.size() > expected) {
            fault(line, expected + 1, IssueCode::wrongCount, countOf(m_cells.size()),
                  countOf(expected));
            return;
        }
        ++m_read.rows;
        m_parts.clear();
        if (!takeTimeOfRow(line)) {
            return;
        }
        const int place = placeOf(line);
        for (std::size_t c = 0; c < m_cells.size(); ++c) {
            const ColumnMatch& match = m_table.columns[c];
            if (match.quantity == ColumnQuantity::ignored || m_cells[c].empty() || c == m_time
                || match.quantity == ColumnQuantity::place) {
                continue;
            }
            if (isTrace(match.quantity)) {
                const auto value = number(line, c);
                if (value && m_isTimed) {
                    m_traces[c].add(m_lastTime, *value);
                }
            } else if (isNumeric(match.quantity)) {
                if (const auto value = number(line, c)) {
                    put(m_parts[match.place.value_or(place)], match.quantity, *value);
                }
            }
        }
        keepParts(line);
    }

    /// False if the line has a time that is before that of the previous line.
    bool takeTimeOfRow(std::size_t line) {
        const auto time = m_time ? number(line, *m_time) : std::nullopt;
        m_isTimed = time && takeTime(line, *m_time + 1, *time);
        return m_isTimed || !time;
    }

    /// The value of a cell in the unit of the section; empty if the cell is empty or refused.
    std::optional<double> number(std::size_t line, std::size_t column) {
        if (column >= m_cells.size() || m_cells[column].empty()) {
            return std::nullopt;
        }
        const auto value = cellNumber(m_cells[column], m_table.dialect.decimal);
        if (!value) {
            fault(line, column + 1, IssueCode::wrongType, quotedCell(m_cells[column]),
                  Phrase::number);
            return std::nullopt;
        }
        const double converted = *value * m_factors[column];
        const ColumnQuantity quantity = m_table.columns[column].quantity;
        Bounds& bounds = m_bounds.try_emplace(quantity, boundsHere(quantity)).first->second;
        if (!bounds.range.contains(converted)) {
            fault(line, column + 1, IssueCode::outOfRange, Amount{converted, bounds.unit}, bounds);
            return std::nullopt;
        }
        return converted;
    }

    /// Deviations refer to an allowed diameter of a part.
    [[nodiscard]] Bounds boundsHere(ColumnQuantity quantity) const {
        if (quantity != ColumnQuantity::diameter_deviation) {
            return boundsOf(quantity);
        }
        const Range diameters = boundsOf(ColumnQuantity::diameter).range;
        const double nominal_mm = m_context.nominalDiameter_mm;
        return {.range = {.low = (diameters.low - nominal_mm) * units::umPerMm,
                          .high = (diameters.high - nominal_mm) * units::umPerMm},
                .unit = "µm"};
    }

    int placeOf(std::size_t line) {
        for (std::size_t c = 0; c < m_cells.size(); ++c) {
            if (m_table.columns[c].quantity != ColumnQuantity::place || m_cells[c].empty()) {
                continue;
            }
            if (const auto zone = zoneNamed(m_cells[c])) {
                return *zone;
            }
            const auto value = cellNumber(m_cells[c], m_table.dialect.decimal);
            const Bounds bounds = boundsOf(ColumnQuantity::place);
            if (!value || *value != std::floor(*value)) {
                fault(line, c + 1, IssueCode::wrongType, quotedCell(m_cells[c]),
                      Phrase::wholeNumber);
            } else if (!bounds.range.contains(*value - m_table.firstPlace)) {
                fault(line, c + 1, IssueCode::outOfRange, Amount{*value},
                      Bounds{{bounds.range.low + m_table.firstPlace,
                              bounds.range.high + m_table.firstPlace}});
            } else {
                return static_cast<int>(*value) - m_table.firstPlace;
            }
        }
        return 0;
    }

    void put(MeasuredPart& part, ColumnQuantity quantity, double value) const {
        switch (quantity) {
        case ColumnQuantity::diameter: part.diameters_mm.push_back(value); break;
        case ColumnQuantity::diameter_deviation:
            part.diameters_mm.push_back(m_context.nominalDiameter_mm + value / units::umPerMm);
            break;
        case ColumnQuantity::roundness: part.roundness_um = value; break;
        case ColumnQuantity::radial_runout: part.radial_runout_um = value; break;
        case ColumnQuantity::cylindricity: part.cylindricity_um = value; break;
        case ColumnQuantity::roughness_ra: part.roughness_ra_um = value; break;
        default: break;
        }
    }

    [[nodiscard]] std::string textOf(ColumnQuantity quantity) const {
        for (std::size_t c = 0; c < m_cells.size(); ++c) {
            if (m_table.columns[c].quantity == quantity) {
                return std::string(m_cells[c]);
            }
        }
        return {};
    }

    void keepParts(std::size_t line) {
        for (auto& [place, part] : m_parts) {
            if (m_read.data.parts.size() >= limits::measuredParts) {
                fault(line, 0, IssueCode::wrongCount, countOf(m_read.data.parts.size() + 1),
                      Bounds{{.high = limits::measuredParts}});
                return;
            }
            part.place = place;
            part.part = textOf(ColumnQuantity::part);
            part.part = part.part.empty() ? std::to_string(m_read.rows) : part.part;
            part.time = textOf(ColumnQuantity::when);
            part.note = textOf(ColumnQuantity::note);
            m_read.data.parts.push_back(std::move(part));
        }
    }

    std::vector<double> m_factors;
    std::map<ColumnQuantity, Bounds> m_bounds;
    std::map<int, MeasuredPart> m_parts; ///< of the line, by place
    std::optional<std::size_t> m_time;
    bool m_isTimed = false; ///< the line has a time
};

/// Counts from 0 if one of the first parts has the place 0.
int firstPlaceIn(std::string_view text, const MeasuredTable& table) {
    const auto column =
        std::ranges::find(table.columns, ColumnQuantity::place, &ColumnMatch::quantity);
    if (column == table.columns.end()) {
        return 1;
    }
    constexpr int rowsLookedAt = 1000;
    const auto index = static_cast<std::size_t>(column - table.columns.begin());
    TableReader rows(text, table.dialect.delimiter);
    (void)rows.next(); // the headings
    for (int i = 0; i < rowsLookedAt && rows.next(); ++i) {
        if (index < rows.cells().size()
            && cellNumber(rows.cells()[index], table.dialect.decimal) == 0.0) {
            return 0;
        }
    }
    return 1;
}

} // namespace

MeasuredTable proposeTable(const TableText& source) {
    const std::string_view text = source.utf8();
    MeasuredTable table;
    table.dialect = dialectOf(text);
    if (table.dialect.delimiter == '|') {
        table.isKeyValue = true;
        table.columns = matchKeys(text);
        return table;
    }
    table.columns = matchHeadings(text, table.dialect.delimiter);
    table.firstPlace = firstPlaceIn(text, table);
    return table;
}

ReadMeasured readMeasured(const TableText& source, const MeasuredTable& table,
                          const MeasuredContext& context, const std::stop_token& stop) {
    ReadMeasured read;
    const auto refuse = [&read](IssueCode code, Detail value, Detail limit) {
        read.faults.push_back(
            {0, 0, {code, Severity::error, {}, std::move(value), std::move(limit)}});
    };
    if (source.isBlank()) {
        refuse(IssueCode::empty, {}, {});
        return read;
    }
    if (source.bytes() > limits::measuredBytes) {
        refuse(IssueCode::tooLarge, countOf(source.bytes(), "bytes"),
               countOf(limits::measuredBytes, "bytes"));
        return read;
    }
    const std::string_view text = source.utf8();
    read = table.isKeyValue ? readKeyValueLines(text, table, context, stop)
                            : RowReader(table, context).read(text, stop);
    if (stop.stop_requested()) {
        return {};
    }
    const std::string digest = read.data.traces.empty() ? std::string() : source.sha256();
    for (MeasuredTrace& trace : read.data.traces) {
        trace.source_sha256 = digest;
    }
    const Measured& data = read.data;
    if (read.faults.empty() && data.parts.empty() && data.traces.empty()) {
        refuse(IssueCode::empty, {}, {});
    }
    return read;
}

} // namespace sparkout
