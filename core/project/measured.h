// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/indirect.h"
#include "core/issue.h"

#include <optional>
#include <string>
#include <vector>

namespace sparkout {

namespace limits {
inline constexpr int measuredParts = 5000;
inline constexpr int traces = 20;
inline constexpr std::size_t traceSamples = 20'000;
} // namespace limits

/// A measured quantity of a part that the batch predicts.
enum class MeasuredQuantity {
    diameter_deviation, ///< deviation from the nominal diameter
    radial_runout,
    roundness,
    cylindricity,
    roughness_ra
};

enum class TraceQuantity { gauge_size, wheel_power, spindle_current, normal_force };

/// Measurements of one zone or section of one part.
struct MeasuredPart {
    std::string part;                 ///< the part's number or name
    int place = 0;                    ///< zone or section, from 0
    std::vector<double> diameters_mm; ///< one, or several around the part
    std::optional<double> roundness_um;
    std::optional<double> radial_runout_um;
    std::optional<double> cylindricity_um;
    std::optional<double> roughness_ra_um;
    std::string time;
    std::string note;
};

/// A quantity over the time of one cycle.
struct MeasuredTrace {
    TraceQuantity quantity = TraceQuantity::gauge_size;
    std::optional<int> place;              ///< zone or section; not given: the gauge's
    std::optional<double> factor_kw_per_a; ///< power per ampere of a spindle current
    std::optional<double> idle; ///< idle value without cutting, in the unit of the values
    Samples time_s;
    Samples values; ///< mm of diameter, kW, A or N
    std::string source;
    std::string source_sha256;
    int source_samples = 0; ///< number of samples before thinning
    std::string note;
};

/// Statistics of parts that are not listed individually, as in a printed table.
struct MeasuredSummary {
    MeasuredQuantity quantity = MeasuredQuantity::diameter_deviation;
    int place = 0;
    int count = 2;
    double mean_um = 0;
    std::optional<double> half_width_um; ///< half width of the confidence interval of the mean
    double confidence = 0.95;
    std::optional<double> deviation_um; ///< standard deviation
    std::optional<double> least_um, greatest_um;
    std::string note;
};

/// The origin of a calibrated input value.
struct Calibration {
    std::string input; ///< path of the input
    double value = 0;
    std::optional<double> low, high; ///< 95 % interval
    std::string data;
    int count = 1; ///< number of measured values
    std::string date;
    friend bool operator==(const Calibration&, const Calibration&) = default;
};

struct Measured {
    std::vector<MeasuredPart> parts;
    std::vector<MeasuredTrace> traces;
    std::vector<MeasuredSummary> summaries;
    std::vector<Calibration> calibrations;
};

/// Faults between measured values: lengths and order of traces, places the project does not have.
[[nodiscard]] Issues measuredFaults(const Project& project);

template <>
std::span<const Choice> choicesOf<MeasuredQuantity>();
template <>
std::span<const Choice> choicesOf<TraceQuantity>();
template <>
const StructInfo& tableOf<MeasuredPart>();
template <>
const StructInfo& tableOf<MeasuredTrace>();
template <>
const StructInfo& tableOf<MeasuredSummary>();
template <>
const StructInfo& tableOf<Calibration>();
template <>
const StructInfo& tableOf<Measured>();

} // namespace sparkout
