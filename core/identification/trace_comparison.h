// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/fit_data.h"
#include "core/project/project.h"

#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

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
