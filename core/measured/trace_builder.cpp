// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/trace_builder.h"

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

} // namespace sparkout
