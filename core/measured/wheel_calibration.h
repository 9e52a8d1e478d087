// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/statistics/intervals.h"

#include <cstddef>
#include <optional>
#include <string>

/// Calibrates the dressed wheel on one measured part [MODEL-8, MODEL-13].
namespace sparkout {

/// Ratio of measured Ra to that of the project's cycle: the factor of Ra for this wheel and
/// dressing.
struct RoughnessCalibration {
    double factor = 1;                  ///< geometric mean over the measured values
    std::optional<Interval> interval95; ///< Student's, by the logarithms of two or more values
    std::size_t count = 0;
    std::string wheel, dressing; ///< the wheel and dressing to which it applies
};

/// From the parts and statistics in the project's section `measured`. Empty without a measured Ra
/// above 0, or if the cycle does not end or its last step does not cut.
[[nodiscard]] std::optional<RoughnessCalibration> roughnessFromParts(const Project& project);

/// The project with the factor, recorded as calibrated on these data.
[[nodiscard]] Project withRoughness(const Project& project, const RoughnessCalibration& found,
                                    const std::string& data, const std::string& date);

enum class LimitReading {
    normal_force, ///< [N]
    wheel_power   ///< [kW], without idle power
};

/// The wheel's strengths from one cut at which it just began to shed its grains.
struct StrengthsCalibration {
    double factor = 1;   ///< for all four: energies and moduli of grain and bond
    double depth_mm = 0; ///< a of that cut
};

/// A reading at the limit, over an effective width of cut. With all four strengths multiplied by c,
/// f_g, f_b and so f_cr are multiplied by c: c is the load of the cut under the current strengths.
/// Empty without these, or if the reading is not positive.
[[nodiscard]] std::optional<StrengthsCalibration>
strengthsFromLimit(const Project& project, LimitReading reading, double value, double width_mm);

[[nodiscard]] Project withStrengths(const Project& project, const StrengthsCalibration& found,
                                    const std::string& data, const std::string& date);

} // namespace sparkout
