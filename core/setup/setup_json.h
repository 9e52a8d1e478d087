// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"
#include "core/setup/setup_run.h"

#include <functional>
#include <span>
#include <string>

namespace sparkout {

/// A set-up and its run.
struct SetupRunOf {
    const Setup& setup;
    const SetupRun& run;
};

/// The outputs for the part as a whole.
[[nodiscard]] std::span<const Output<SetupRunOf>> setupOutputs();

/// One JSON object: "surfaces", each with its name and the keys of resultJson(), and "part" with
/// completed, holds and the times, which are null unless every surface is completed.
[[nodiscard]] std::string
setupJson(const Setup& setup, const SetupRun& run,
          const std::function<std::string(const SurfaceRun&)>& surfaceJson = {});

} // namespace sparkout
