// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/table/sheet.h"

#include <QString>

#include <stop_token>

class QWidget;

namespace sparkout {

/// Runs `work` on another thread and returns when it is done. Longer work shows progress and can be
/// stopped, which requests `stop`. False if it was.
bool runWatched(QWidget* window, const QString& text,
                const std::function<void(const KeepGoing&)>& work, std::stop_source stop = {});

} // namespace sparkout
