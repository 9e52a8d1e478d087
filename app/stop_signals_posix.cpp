// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/stop_signals.h"

#include <atomic>
#include <csignal>

namespace sparkout::cli {

namespace {

std::atomic<int> caught = 0;
static_assert(std::atomic<int>::is_always_lock_free, "a handler may touch nothing else");

void noteSignal(int signal) {
    caught = signal;
}

} // namespace

void catchStopSignals() {
    for (const int signal : {SIGINT, SIGTERM}) {
        struct sigaction action = {};
        if (sigaction(signal, nullptr, &action) == 0 && action.sa_handler == SIG_IGN) {
            continue;
        }
        action = {};
        action.sa_handler = noteSignal;
        action.sa_flags = static_cast<int>(SA_RESTART | SA_RESETHAND);
        sigaction(signal, &action, nullptr);
    }
}

int caughtSignal() {
    return caught;
}

} // namespace sparkout::cli
