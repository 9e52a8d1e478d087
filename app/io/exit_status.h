// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout::cli {

/// Exit status of the program. `interrupted` is 130 or 143 with the number of the signal added, as
/// a shell has it for Ctrl+C and SIGTERM: of a command that was ended before it had an answer, or
/// with a part of it. `nothingFeasible` is an answer, for which every cycle was decided on.
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
