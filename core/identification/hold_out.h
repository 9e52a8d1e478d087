// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_data.h"
#include "core/project/project.h"
#include "core/statistics/intervals.h"

#include <stop_token>
#include <vector>

/// A calibration held against a cycle that it has not seen: what the project predicts of a trace
/// that none of its calibrated inputs rests on [MODEL-13].
namespace sparkout {

/// What is compared. None depends on the clock of the recorder, and the first two do not depend on
/// the zero of the gauge more than the alignment of the curves does.
enum class HoldOutQuantity {
    time,        ///< s between two sizes: from the middle of the first feed to the end of the last
    after_feeds, ///< µm of diameter removed after the last feed
    power        ///< kW, mean over the feeds; where the idle power is stated
};

struct HoldOutRow {
    int trace = 0; ///< its number in the project
    HoldOutQuantity quantity = HoldOutQuantity::time;
    double measured = 0;
    double predicted = 0;
    /// With the calibrated inputs at the ends of their intervals, in all combinations.
    Interval predicted95;
    /// Measured less predicted, with the noise of the trace.
    Interval difference95;

    /// Whether the difference may be none.
    [[nodiscard]] bool agrees() const { return difference95.low <= 0 && 0 <= difference95.high; }
};

/// Calibrated inputs that are varied together; where there are more, those with the widest
/// relative intervals are.
inline constexpr std::size_t mostVariedInputs = 5;

/// Traces whose file no calibration names, against the cycle of a valid project. Empty where no
/// input is calibrated with an interval, where all traces were used, or after a stop.
[[nodiscard]] std::vector<HoldOutRow> holdOut(const Project& project,
                                              const std::stop_token& stop = {});

} // namespace sparkout
