// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// Border conversions: files, command line and window use mm, µm, mm/min, rev/min, kW; inside the
/// core everything is mm, N, s (hence MPa and N·mm/s).
namespace sparkout::units {

inline constexpr double umPerMm = 1000.0;
inline constexpr double secondsPerMinute = 60.0;
inline constexpr double mmPerM = 1000.0;
inline constexpr double mpaPerGpa = 1000.0;
inline constexpr double wPerKw = 1000.0;
inline constexpr double jPerKj = 1000.0;

} // namespace sparkout::units

namespace sparkout {

/// Shorter cycle times are stated in seconds, as grinders count a plunge.
inline constexpr double shortTime_s = 2 * units::secondsPerMinute;

/// The common unit of times shown together, in seconds, by the longest of them.
[[nodiscard]] constexpr double timeUnit_s(double longest_s) {
    return longest_s < shortTime_s ? 1 : units::secondsPerMinute;
}

} // namespace sparkout
