// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/hold_out.h"

#include "core/measured/calibrated_inputs.h"
#include "core/measured/cycle_response.h"
#include "core/measured/fit_data.h"
#include "core/measured/noise_model.h"
#include "core/project/cycle.h"
#include "core/project/measured.h"
#include "core/project/number_input.h"
#include "core/project/validate.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

namespace sparkout {

namespace {

constexpr double errorsOf95 = 1.959964;

bool isUsed(const Project& project, const MeasuredTrace& trace) {
    return std::ranges::any_of(project.measured->calibrations, [&](const Calibration& record) {
        return trace.source.empty() || record.data.find(trace.source) != std::string::npos;
    });
}

/// The records whose inputs are unchanged since the fit, and which have an interval.
std::vector<Calibration> variedInputs(const Project& project) {
    std::vector<Calibration> records;
    for (const Calibration& record : project.measured->calibrations) {
        if (record.low && record.high && hasCalibratedValue(project, record)) {
            records.push_back(record);
        }
    }
    std::ranges::stable_sort(records, std::greater(), [](const Calibration& record) {
        return (*record.high - *record.low) / std::abs(record.value);
    });
    records.resize(std::min(records.size(), mostVariedInputs));
    return records;
}

/// The expected signals of gauge and drive in a cycle, with the ends of its stages.
struct Predicted {
    std::vector<int> steps; ///< steps of each stage
    CycleResponse shown;
    double firstFeed_s = 0; ///< middle of the first feed
    double lastFeed_s = 0;  ///< end of the last feed
    double end_s = 0;

    [[nodiscard]] double sizeAt(double time_s) const {
        return valueAt(shown.end_s, shown.size_mm, time_s);
    }
    /// The time at which the size falls to a value; the end if it does not.
    [[nodiscard]] double timeOf(double size_mm) const {
        const auto after = std::ranges::find_if(
            shown.size_mm, [size_mm](double value) { return value <= size_mm; });
        const auto i = static_cast<std::size_t>(after - shown.size_mm.begin());
        if (i == 0 || i == shown.size_mm.size()) {
            return i == 0 ? shown.end_s.front() : shown.end_s.back();
        }
        const double fall = shown.size_mm[i - 1] - shown.size_mm[i];
        return shown.end_s[i - 1]
               + (shown.end_s[i] - shown.end_s[i - 1]) * (shown.size_mm[i - 1] - size_mm) / fall;
    }
    [[nodiscard]] double meanPower_kw() const {
        double energy = 0;
        for (std::size_t i = 0; i + 1 < shown.end_s.size() && shown.end_s[i] < lastFeed_s; ++i) {
            energy += (shown.chip_kw[i + 1] + shown.friction_kw[i + 1]) // the first is idle
                      * (std::min(shown.end_s[i + 1], lastFeed_s) - shown.end_s[i]);
        }
        return energy / lastFeed_s;
    }
};

std::optional<Predicted> predictedOf(const Project& project, const std::stop_token& stop) {
    const CycleFactors factors = factorsOf(project);
    Predicted made;
    made.steps = stepsByGauge(project, factors, stop);
    const std::vector<int>& steps = made.steps;
    if (steps.empty()) {
        return std::nullopt;
    }
    made.shown = respond(project, factors, steps, false, stop);
    if (!made.shown.ran) {
        return std::nullopt;
    }
    std::size_t step = 0;
    bool isFirst = true;
    for (std::size_t stage = 0; stage < steps.size(); ++stage) {
        const double begin_s = made.shown.end_s[step];
        step = std::min(step + static_cast<std::size_t>(steps[stage]), made.shown.end_s.size() - 1);
        if (steps[stage] > 0 && project.cycle->stages[stage].feeds()) {
            made.lastFeed_s = made.shown.end_s[step];
            made.firstFeed_s = isFirst ? std::midpoint(begin_s, made.lastFeed_s) : made.firstFeed_s;
            isFirst = false;
        }
    }
    made.end_s = made.shown.end_s.back();
    return isFirst ? std::nullopt : std::optional(std::move(made));
}

/// The project with its calibrated inputs at their ends, one bit of `ends` each; empty if the
/// inputs are refused.
std::optional<Project> atEnds(Project project, const std::vector<Calibration>& inputs,
                              unsigned ends) {
    for (std::size_t i = 0; i < inputs.size(); ++i) {
        const double value = ((ends >> i) & 1U) ? *inputs[i].high : *inputs[i].low;
        setNumberInput(project, inputs[i].input, value);
    }
    return hasErrors(validate(project)) ? std::nullopt : std::optional(std::move(project));
}

void widen(Interval& interval, double value) {
    interval.low = std::min(interval.low, value);
    interval.high = std::max(interval.high, value);
}

/// The excess of a trace over the prediction around a time, and its standard error.
struct Excess {
    double mean = 0, error = 0;
    double slope = 0; ///< slope of the predicted values, per second
};

class HeldOutTrace {
public:
    HeldOutTrace(const TraceComparison& trace, const Predicted& nominal)
        : m_trace(trace), m_nominal(nominal) {
        for (std::size_t i = 0; i < trace.measured.size(); ++i) {
            m_excess.push_back(trace.measured[i] - trace.predicted[i]);
        }
        if (m_excess.size() >= leastValues) {
            m_noise = traceNoiseOf(m_excess);
        }
    }

    /// Whether enough is recorded between two times.
    [[nodiscard]] bool covers(double from_s, double to_s) const {
        return m_excess.size() >= leastValues && m_trace.time_s.front() <= from_s
               && to_s <= m_trace.time_s.back() && countIn(from_s, to_s) >= leastValues;
    }
    /// Over the values between two times, at least the last `leastValues` before the end.
    [[nodiscard]] Excess excess(double from_s, double to_s) const {
        const auto first = std::ranges::lower_bound(m_trace.time_s, from_s);
        const auto last = std::ranges::upper_bound(m_trace.time_s, to_s);
        auto to = static_cast<std::size_t>(last - m_trace.time_s.begin());
        auto from = static_cast<std::size_t>(first - m_trace.time_s.begin());
        from = std::min(from, to > leastValues ? to - leastValues : 0);
        Excess found;
        for (std::size_t i = from; i < to; ++i) {
            found.mean += m_excess[i] / static_cast<double>(to - from);
        }
        found.error = std::sqrt(m_noise.varianceOfMean(to - from));
        found.slope = (m_trace.predicted[to - 1] - m_trace.predicted[from])
                      / (m_trace.time_s[to - 1] - m_trace.time_s[from]);
        return found;
    }
    [[nodiscard]] int number() const { return m_trace.trace; }
    [[nodiscard]] const Predicted& nominal() const { return m_nominal; }

    static constexpr std::size_t leastValues = 5;

private:
    [[nodiscard]] std::size_t countIn(double from_s, double to_s) const {
        return static_cast<std::size_t>(std::ranges::upper_bound(m_trace.time_s, to_s)
                                        - std::ranges::lower_bound(m_trace.time_s, from_s));
    }

    const TraceComparison& m_trace;
    const Predicted& m_nominal;
    std::vector<double> m_excess;
    TraceNoise m_noise;
};

HoldOutRow rowOf(int trace, HoldOutQuantity quantity, double predicted, double excess, double error,
                 const Interval& predicted95) {
    const double measured = predicted + excess;
    return {trace,
            quantity,
            measured,
            predicted,
            predicted95,
            {measured - predicted95.high - errorsOf95 * error,
             measured - predicted95.low + errorsOf95 * error}};
}

/// The values of the predicted curve and of those at the ends of the inputs' intervals.
template <class Value>
Interval rangeOf(const Predicted& nominal, const std::vector<Predicted>& ends, Value value) {
    Interval range{value(nominal), value(nominal)};
    for (const Predicted& end : ends) {
        widen(range, value(end));
    }
    return range;
}

void compareSizes(const HeldOutTrace& trace, const std::vector<Predicted>& ends,
                  std::vector<HoldOutRow>& rows) {
    const Predicted& nominal = trace.nominal();
    constexpr double window = 0.15; // share of the time between the two sizes
    const double width_s = window * (nominal.lastFeed_s - nominal.firstFeed_s);
    const double from_mm = nominal.sizeAt(nominal.firstFeed_s);
    const double to_mm = nominal.sizeAt(nominal.lastFeed_s);
    if (!trace.covers(nominal.firstFeed_s - width_s, nominal.lastFeed_s) || !(from_mm > to_mm)) {
        return;
    }
    const Excess first = trace.excess(nominal.firstFeed_s - width_s, nominal.firstFeed_s);
    const Excess last = trace.excess(nominal.lastFeed_s - width_s, nominal.lastFeed_s);
    if (first.slope < 0 && last.slope < 0) {
        rows.push_back(rowOf(trace.number(), HoldOutQuantity::time,
                             nominal.lastFeed_s - nominal.firstFeed_s,
                             first.mean / first.slope - last.mean / last.slope,
                             std::hypot(first.error / first.slope, last.error / last.slope),
                             rangeOf(nominal, ends, [from_mm, to_mm](const Predicted& p) {
                                 return p.timeOf(to_mm) - p.timeOf(from_mm);
                             })));
    }
    const double rest_s = nominal.end_s - nominal.lastFeed_s;
    constexpr double tail = 0.25; // share of the spark-out, with little removal
    if (rest_s > 0
        && trace.covers(nominal.lastFeed_s + rest_s / 2, nominal.end_s - tail / 2 * rest_s)) {
        const Excess end = trace.excess(nominal.end_s - tail * rest_s, nominal.end_s);
        constexpr double um = 1e3;
        rows.push_back(rowOf(trace.number(), HoldOutQuantity::after_feeds,
                             um * (to_mm - nominal.sizeAt(nominal.end_s)),
                             um * (last.mean - end.mean), um * std::hypot(last.error, end.error),
                             rangeOf(nominal, ends, [](const Predicted& p) {
                                 return um * (p.sizeAt(p.lastFeed_s) - p.sizeAt(p.end_s));
                             })));
    }
}

void comparePower(const HeldOutTrace& trace, const std::vector<Predicted>& ends,
                  std::vector<HoldOutRow>& rows) {
    const Predicted& nominal = trace.nominal();
    if (!trace.covers(0, nominal.lastFeed_s)) {
        return;
    }
    const Excess all = trace.excess(0, nominal.lastFeed_s);
    rows.push_back(
        rowOf(trace.number(), HoldOutQuantity::power, nominal.meanPower_kw(), all.mean, all.error,
              rangeOf(nominal, ends, [](const Predicted& p) { return p.meanPower_kw(); })));
}

} // namespace

std::vector<HoldOutRow> holdOut(const Project& project, const std::stop_token& stop) {
    std::vector<HoldOutRow> rows;
    if (!project.measured) {
        return rows;
    }
    const std::vector<MeasuredTrace>& traces = project.measured->traces;
    const std::vector<Calibration> inputs = variedInputs(project);
    const auto isLeft = [&project](const MeasuredTrace& trace) { return !isUsed(project, trace); };
    if (inputs.empty() || std::ranges::none_of(traces, isLeft)) {
        return rows;
    }
    const auto nominal = predictedOf(project, stop);
    if (!nominal) {
        return rows;
    }
    std::vector<Predicted> ends;
    for (unsigned corner = 0; corner < 1U << inputs.size() && !stop.stop_requested(); ++corner) {
        const auto there = atEnds(project, inputs, corner);
        if (auto predicted = there ? predictedOf(*there, stop) : std::nullopt) {
            ends.push_back(std::move(*predicted));
        }
    }
    for (const TraceComparison& one : compareTraces(project, nominal->steps, stop)) {
        const MeasuredTrace& trace = traces[static_cast<std::size_t>(one.trace)];
        if (!isLeft(trace)) {
            continue;
        }
        const HeldOutTrace held(one, *nominal);
        if (one.source == FitSource::size && !one.place) {
            compareSizes(held, ends, rows);
        } else if (one.source == FitSource::power && trace.idle) {
            comparePower(held, ends, rows);
        }
    }
    return stop.stop_requested() ? std::vector<HoldOutRow>() : rows;
}

} // namespace sparkout
