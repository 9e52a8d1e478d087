// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/trace_builder.h"

#include "core/measured/thin_out.h"

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
