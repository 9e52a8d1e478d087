// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout::cli {

/// Catches the first Ctrl+C and the first SIGTERM from now on; a second one ends the program. A
/// signal that the caller ignores, like `nohup`, stays ignored.
void catchStopSignals();

/// The caught signal; 0 if none.
[[nodiscard]] int caughtSignal();

} // namespace sparkout::cli
