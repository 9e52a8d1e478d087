// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_data.h"
#include "core/project/project.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// A measured trace beside what the cycle of the project would show, sample by sample.
struct TraceComparison {
    int trace = 0; ///< its number in the project
    FitSource source = FitSource::size;
    std::optional<int> place;      ///< of a size; not given: where the gauge measures
    std::vector<double> time_s;    ///< of the cycle, from its beginning
    std::vector<double> measured;  ///< mm from the target, kW, N; a size without the offset
    std::vector<double> predicted; ///< at the same times
    double rms = 0;                ///< of measured less predicted
    double shift_s = 0;            ///< of the trace, at which the cycle begins
    double offset_mm = 0;          ///< of the gauge's zero, taken off the sizes
};

/// The traces of a project against its cycle with so many steps in its stages. Those of one file
/// have one clock: where the cycle begins in it is the shift with the least squares, found together
/// with the gauge's zero and an idle power that is not stated. Empty where nothing was traced or
/// the cycle cannot be run.
[[nodiscard]] std::vector<TraceComparison> compareTraces(const Project& project,
                                                         const std::vector<int>& stepsByStage,
                                                         const std::stop_token& stop = {});

} // namespace sparkout
