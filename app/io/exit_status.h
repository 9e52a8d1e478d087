// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout::cli {

/// Exit status of the program. `interrupted` is 130 or 143, as a shell tells Ctrl+C and SIGTERM.
enum Exit {
    done = 0,
    refused = 1,
    usage = 2,
    cannotReachSize = 3,
    requirementFails = 4,
    nothingFeasible = 5,
    interrupted = 128
};

} // namespace sparkout::cli
