// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout::cli {

/// From now on the first Ctrl+C and the first SIGTERM are noted; a second one ends the program. A
/// signal that the caller has switched off, as `nohup` does, stays off.
void catchStopSignals();

/// The signal that came; 0: none.
[[nodiscard]] int caughtSignal();

} // namespace sparkout::cli
