// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stop_signals.h"

#include <atomic>
#include <csignal>

#include <windows.h>

namespace sparkout::cli {

namespace {

std::atomic<int> caught = 0;

/// Runs on its own thread. After the console is closed the program has five seconds to end.
BOOL WINAPI noteEvent(DWORD event) {
    const bool asked = event == CTRL_C_EVENT || event == CTRL_BREAK_EVENT;
    int none = 0;
    return caught.compare_exchange_strong(none, asked ? SIGINT : SIGTERM) ? TRUE : FALSE;
}

} // namespace

void catchStopSignals() {
    // Removed first, so that it is added once. If the caller has switched Ctrl+C off, it stays off.
    ::SetConsoleCtrlHandler(noteEvent, FALSE);
    ::SetConsoleCtrlHandler(noteEvent, TRUE);
}

int caughtSignal() {
    return caught;
}

} // namespace sparkout::cli
