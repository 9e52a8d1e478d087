// SPDX-License-Identifier: GPL-3.0-or-later
// What tests want in another state than it begins with.
#pragma once

#include <QElapsedTimer>

#include <stop_token>

namespace sparkout {

struct RunningTimer : QElapsedTimer {
    RunningTimer() { start(); }
};

struct StoppedSource : std::stop_source {
    StoppedSource() { request_stop(); }
};

} // namespace sparkout
