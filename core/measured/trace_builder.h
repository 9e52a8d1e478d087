// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/measured_table.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace sparkout {

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
