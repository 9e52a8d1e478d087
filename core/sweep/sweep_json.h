// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "core/sweep/sweep_run.h"

#include <span>
#include <string>

namespace sparkout {

/// A quantity at a point.
struct SweepFigure {
    const SweepQuantity& quantity;
    const SweepValue& value;
};

[[nodiscard]] std::span<const Output<SweepResult>> sweepOutputs();
[[nodiscard]] std::span<const Output<SweptInput>> sweptInputOutputs();
[[nodiscard]] std::span<const Output<SweepPoint>> sweepPointOutputs();
[[nodiscard]] std::span<const Output<SweepFigure>> sweepFigureOutputs();

/// The key in files and on the command line: "cannot_reach_size".
[[nodiscard]] const char* sweepStatusKey(SweepStatus status);

/// The object of `sweep --json`, which words faults by `sentence`.
[[nodiscard]] std::string sweepJson(const SweepResult& sweep,
                                    std::string (*sentence)(const Issue& issue));

} // namespace sparkout
