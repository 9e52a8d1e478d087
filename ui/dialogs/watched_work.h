// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/sheet.h"

#include <QString>

#include <stop_token>

class QWidget;

namespace sparkout {

/// Runs `work` in a thread of its own and comes back when it is done. What takes longer than a
/// moment shows how far it is and can be stopped, `stop` with it. False: it was.
bool runWatched(QWidget* window, const QString& text,
                const std::function<void(const KeepGoing&)>& work, std::stop_source stop = {});

} // namespace sparkout
