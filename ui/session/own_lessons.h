// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace sparkout {

/// The folder of the user's own lessons, below that of the settings; empty without one.
[[nodiscard]] QString ownLessonsFolder(const QString& settingsFolder);

/// The paths of the lessons there, by their names.
[[nodiscard]] QStringList ownLessons(const QString& settingsFolder);

} // namespace sparkout
