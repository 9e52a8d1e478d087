// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout::cli {

/// Exit status of the program. `interrupted` plus the number of the signal is 130 or 143, as shells
/// report Ctrl+C and SIGTERM, for a command that was ended without an answer, or with a part of it.
/// `nothingFeasible` is an answer, for which every cycle was decided.
enum Exit {
    done = 0,
    refused = 1,
    usage = 2,
    cannotReachSize = 3,
    requirementFails = 4,
    nothingFeasible = 5,
    undecided = 6, ///< no cycle was found, but there may be one: the time was up, or the method
                   ///< proves nothing
    interrupted = 128
};

} // namespace sparkout::cli
