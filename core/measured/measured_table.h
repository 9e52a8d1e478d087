// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/text_encoding.h"
#include "core/file/text_table.h"
#include "core/measured/column_match.h"
#include "core/measured/number_table.h"
#include "core/project/measured.h"

#include <cstddef>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Measured parts and traces as a table: a file, or text pasted from a spreadsheet.

namespace sparkout {

namespace limits {
inline constexpr std::size_t measuredBytes = 256U << 20; ///< largest file that is read
} // namespace limits

/// The interpretation of a table, proposed from its text and changeable by the user.
struct MeasuredTable {
    TableDialect dialect;
    bool isKeyValue = false;          ///< lines time|key|value instead of a line of headings
    std::vector<ColumnMatch> columns; ///< for key-value lines one for each key
    int firstPlace = 0;               ///< number of the first zone or section in the table: 0 or 1
    friend bool operator==(const MeasuredTable&, const MeasuredTable&) = default;
};

[[nodiscard]] MeasuredTable proposeTable(const TableText& source);

/// Additional data that the table does not contain.
struct MeasuredContext {
    std::string source;            ///< name of the file; empty: pasted
    double nominalDiameter_mm = 0; ///< reference of deviations
    double currentFactor_kw_a = 0; ///< of a spindle current; 0: not known
};

struct ReadMeasured {
    Measured data;
    CellFaults faults;    ///< at most limits::issues; if there are any, the data are incomplete
    std::size_t rows = 0; ///< lines of values
};

/// Reads a table with its interpretation. Empty cells are skipped. Traces are thinned to the limit
/// of a project. Empty after a stop.
[[nodiscard]] ReadMeasured readMeasured(const TableText& source, const MeasuredTable& table,
                                        const MeasuredContext& context,
                                        const std::stop_token& stop = {});

// Lines time|key|value, possibly with further keys and values, as written by machine adapters. The
// time is a number of seconds, or an ISO 8601 date and time.

/// The keys of the first lines, in their order.
[[nodiscard]] std::vector<ColumnMatch> matchKeys(std::string_view text);

/// Reads the lines into one trace for each key. A value UNAVAILABLE is skipped.
[[nodiscard]] ReadMeasured readKeyValueLines(std::string_view text, const MeasuredTable& table,
                                             const MeasuredContext& context,
                                             const std::stop_token& stop);

/// Thins a trace to at most `most` samples: the means of time and value over that many sections of
/// equal length. A record of many thousand values per second has noise whose extremes are far from
/// its mean, which a fit needs. Shorter traces are unchanged.
[[nodiscard]] std::pair<std::vector<double>, std::vector<double>>
thinOut(std::vector<double> times, std::vector<double> values, std::size_t most);

/// Collects the samples of one column during reading.
class TraceBuilder {
public:
    explicit TraceBuilder(const ColumnMatch& match) : m_match(&match) {}

    void add(double time_s, double value) {
        m_times.push_back(time_s);
        m_values.push_back(value);
    }
    [[nodiscard]] bool empty() const { return m_times.empty(); }
    /// Thinned to the limit of a project; leaves nothing behind.
    [[nodiscard]] MeasuredTrace take(const MeasuredContext& context);

private:
    const ColumnMatch* m_match;
    std::vector<double> m_times, m_values;
};

} // namespace sparkout
