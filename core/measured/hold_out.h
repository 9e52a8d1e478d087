// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/measured/fit_data.h"
#include "core/project/project.h"
#include "core/statistics/intervals.h"

#include <stop_token>
#include <vector>

/// Validation of a calibration by an unused cycle: the prediction for a trace on which none of its
/// calibrated inputs is based [MODEL-13].
namespace sparkout {

/// The compared quantities. None depends on the clock of the recorder, and the first two do not
/// depend on the zero of the gauge more than the alignment of the curves does.
enum class HoldOutQuantity {
    time,        ///< s between two sizes: middle of the first feed and end of the last
    after_feeds, ///< µm of diameter removed after the last feed
    power        ///< kW, mean over the feeds; if the idle power is given
};

struct HoldOutRow {
    int trace = 0; ///< index in the project
    HoldOutQuantity quantity = HoldOutQuantity::time;
    double measured = 0;
    double predicted = 0;
    /// With all combinations of the calibrated inputs at the ends of their intervals.
    Interval predicted95;
    /// Measured less predicted, including the noise of the trace.
    Interval difference95;

    /// Whether the difference may be none.
    [[nodiscard]] bool agrees() const { return difference95.low <= 0 && 0 <= difference95.high; }
};

/// Calibrated inputs varied together; if there are more, those with the widest relative intervals.
inline constexpr std::size_t mostVariedInputs = 5;

/// Compares traces whose file no calibration names with the cycle of a valid project. Empty if no
/// input is calibrated with an interval, if all traces were used, or after a stop.
[[nodiscard]] std::vector<HoldOutRow> holdOut(const Project& project,
                                              const std::stop_token& stop = {});

} // namespace sparkout
