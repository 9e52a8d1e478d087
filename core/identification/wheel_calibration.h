// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/statistics/intervals.h"

#include <cstddef>
#include <optional>
#include <string>

/// What one measured part tells of the wheel as it is dressed [MODEL-8, MODEL-13].
namespace sparkout {

/// Measured Ra to that which the project's cycle leaves: the factor of Ra for this wheel and this
/// dressing.
struct RoughnessCalibration {
    double factor = 1;                  ///< geometric mean over the measured values
    std::optional<Interval> interval95; ///< Student's of the logarithms, of two values or more
    std::size_t count = 0;
    std::string wheel, dressing; ///< that it holds for
};

/// From the parts and statistics in the project's section `measured`. Nothing where no Ra above 0
/// is measured, or where the cycle does not end or cuts nothing at last.
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
    double factor = 1;   ///< of all four: energies and moduli of grain and bond
    double depth_mm = 0; ///< a of that cut
};

/// A reading at the limit, over an effective width of cut. With all four strengths c times as great
/// f_g, f_b and so f_cr are c times as great: c is the load of the cut under the strengths as they
/// are. Nothing where these are not given, or the reading is not above 0.
[[nodiscard]] std::optional<StrengthsCalibration>
strengthsFromLimit(const Project& project, LimitReading reading, double value, double width_mm);

[[nodiscard]] Project withStrengths(const Project& project, const StrengthsCalibration& found,
                                    const std::string& data, const std::string& date);

} // namespace sparkout
