// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

namespace sparkout {

/// Runs a piece of work that the user waits for, such as writing a large picture, in a thread of
/// its own and returns when it is done. Meanwhile the window is drawn and timers run; mouse and
/// keys wait. The work must not touch widgets or anything the window may change.
void runInBackground(const std::function<void()>& work);

} // namespace sparkout
