// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fitted_parameter.h"
#include "core/project/project.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace sparkout {

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
/// and the setting of the gauge, those of one place the setting alone. With a threshold of the
/// force, factors of K and F'_0 replace those of σ_i and η.
[[nodiscard]] std::vector<FittedKind> proposedParameters(const FitData& data,
                                                         bool hasThreshold = false);

} // namespace sparkout
