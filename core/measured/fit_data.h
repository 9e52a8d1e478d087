// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/result.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Parameters that can be fitted to measurements [MODEL-13]. In the balance of a pass, D = a + α·a
/// + β·√a, α = γ·b·k_s and β = γ·b·k_r; the wheel's power is idle + b·k_t·V_k·a + b·μ·k_r·V_k·√a,
/// the normal force b·k_s·a + b·k_r·√a. With a threshold [MODEL-2] α is the factor of K and β that
/// of F'_0, also in the normal force, and flow stress and dullness are not fitted.
enum class FittedKind {
    alpha,          ///< factor of α only
    beta,           ///< factor of β only
    compliance,     ///< factor of γ: of α and β; of one zone or section, or of all
    flow_stress,    ///< factor of σ_i: of k_s, k_r and k_t
    dullness,       ///< factor of η: of k_r
    chip_power,     ///< factor of b·k_t·V_k
    friction_power, ///< factor of b·μ·k_r·V_k
    idle_power,     ///< [kW]
    size_offset,    ///< offset of the gauge's zero [mm of diameter]
    time_shift,     ///< beginning of the cycle in the traces [s]
    power_delay,    ///< delay of the power behind the other traces [s]
    force_delay,    ///< delay of the normal force behind the other traces [s]
    blank_runout,   ///< ΔR of the blank [mm]
    gauge_lag,      ///< time constant of the gauge, a first-order lag [s]
    power_lag,      ///< time constant of the power's filter, a first-order lag [s]
    force_lag,      ///< time constant of the force's filter, a first-order lag [s]
    gauge_drift,    ///< drift of the gauge over the time of the cycle [mm/min]
    gauge_setting,  ///< diameter at which the gauge ends the cycle [mm]; for finished parts
    count_
};

/// Prior knowledge: a mean and its standard deviation, in the unit of the parameter.
struct Prior {
    double mean = 1, deviation = 1;
    friend bool operator==(const Prior&, const Prior&) = default;
};

struct FittedParameter {
    FittedKind kind = FittedKind::alpha;
    std::optional<int> place; ///< zone or section of a compliance; not given: all
    std::optional<Prior> prior;
    friend bool operator==(const FittedParameter&, const FittedParameter&) = default;
};

/// Whether it multiplies an input: then its logarithm is fitted, it stays positive and begins at 1.
[[nodiscard]] bool isFactor(FittedKind kind);
/// Whether it is a factor on which the depths of cut depend.
[[nodiscard]] bool actsOnDepths(FittedKind kind);
/// Whether it is a property of the recorder: offset, times, lag and drift.
[[nodiscard]] bool isOfRecorder(FittedKind kind);
/// Whether it is a time constant of the gauge or of a filter.
[[nodiscard]] bool isLag(FittedKind kind);
/// Whether it is an input of the project; the others belong to the traces.
[[nodiscard]] bool isInput(FittedKind kind);
/// The distance of a parameter from its value beyond which it counts as unknown: a ratio for a
/// factor and the runout, otherwise a difference in its unit.
[[nodiscard]] double plausibleRange(FittedKind kind);
/// The key on the command line and in JSON, "time_shift".
[[nodiscard]] const char* keyOf(FittedKind kind);
/// The unit of its value; empty for a factor.
[[nodiscard]] const char* unitOf(FittedKind kind);

/// A fit of traces starts at factors within this ratio; results beyond it are not used, and the
/// inputs should be improved first.
inline constexpr double mostSearchedFactor = 4;

/// The values that a parameter of this project usually has, in its unit: a fit that leaves them is
/// not used. Of a fit with traces, which are searched less far than finished parts, the factors of
/// the depths of cut lie within `mostSearchedFactor`, too. Empty for the clock and the zero of the
/// traces, which are set anywhere.
[[nodiscard]] std::optional<Interval> usualRange(const Project& project, FittedKind kind,
                                                 bool hasTraces);

/// Whether all these parameters apply to the project, and none is given twice: compliances only of
/// places with their own, no runout of a measured blank, no α and β of a wheel contact.
[[nodiscard]] bool areApplicable(const Project& project, const std::vector<FittedParameter>& list);

/// Ratio of a normal distribution's standard deviation to the median of its absolute values.
inline constexpr double deviationPerMedian = 1.482602218505602;

/// The upper median of at least one value.
[[nodiscard]] double medianOf(std::vector<double> values);

enum class FitSource { size, power, force, parts };

/// Measured values with common noise.
struct FitGroup {
    FitSource source = FitSource::size;
    int trace = -1;             ///< index in the project; −1: parts
    std::optional<int> place;   ///< place of a size; not given: at the gauge
    std::vector<double> time_s; ///< for traces
    std::vector<int> places;    ///< for parts, one for each value
    std::vector<double> values; ///< mm of diameter, kW, N; of parts µm from the nominal diameter
    std::int64_t measured = 0;  ///< number of parts, or values of a trace
    std::optional<double> idle_kw; ///< as given with the trace
    double noise = 1;              ///< standard deviation, estimated from the values
    double step = 0;               ///< resolution of a trace's values: their least difference
};

/// Standard deviation of the noise of a trace from its second differences, whose variance is 6σ²
/// where the curve is nearly straight: σ² = Σ(Δ²y)²/6n. With uneven times a value is compared with
/// the straight line between its neighbours. At least that of rounding to the step of the values,
/// step/√12. Empty for fewer than five values.
[[nodiscard]] std::optional<double> noiseOfTrace(const std::vector<double>& time_s,
                                                 const std::vector<double>& values);

struct FitData {
    std::vector<FitGroup> groups;
    std::vector<int> withoutFactor; ///< currents without a conversion to power, by index
    [[nodiscard]] bool has(FitSource source) const;
    [[nodiscard]] std::size_t count() const; ///< number of all values
};

/// The measured values of a project: the traces with these numbers (empty: all), and optionally the
/// diameters of its parts; without traces and listed parts, the means of summaries.
[[nodiscard]] FitData fitDataOf(const Project& project, const std::vector<int>& traces,
                                bool withParts);

/// The parameters that data of these kinds can determine [MODEL-13]: size alone gives α and β,
/// never γ and k_s separately; with the force it gives γ, σ_i and η. Power gives its two products,
/// and the idle power if that is not given. Offsets of the traces are added. Finished parts give β
/// and the setting of the gauge, those of one place only the setting. With a threshold of the
/// force, factors of K and F'_0 replace those of σ_i and η.
[[nodiscard]] std::vector<FittedKind> proposedParameters(const FitData& data,
                                                         bool hasThreshold = false);

/// A measured trace with the prediction of the project's cycle, sample by sample.
struct TraceComparison {
    int trace = 0; ///< index in the project
    FitSource source = FitSource::size;
    std::optional<int> place;      ///< place of a size; not given: at the gauge
    std::vector<double> time_s;    ///< from the beginning of the cycle
    std::vector<double> measured;  ///< mm from the target, kW, N; a size without the offset
    std::vector<double> predicted; ///< at the same times
    double rms = 0;                ///< RMS of measured less predicted
    double shift_s = 0;            ///< beginning of the cycle in the trace
    double offset_mm = 0;          ///< offset of the gauge's zero, subtracted from the sizes
};

/// Compares the traces of a project with its cycle with these numbers of steps in its stages.
/// Traces of one file share a clock: the shift to the beginning of the cycle is fitted by least
/// squares together with the gauge's zero and an unknown idle power. Empty without traces or if the
/// cycle cannot be run.
[[nodiscard]] std::vector<TraceComparison> compareTraces(const Project& project,
                                                         const std::vector<int>& stepsByStage,
                                                         const std::stop_token& stop = {});

} // namespace sparkout
