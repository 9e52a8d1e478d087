// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace sparkout {

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

} // namespace sparkout
