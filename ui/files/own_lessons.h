// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

namespace sparkout {

/// Where the user's own lessons stand, below the folder of the settings; empty without one.
[[nodiscard]] QString ownLessonsFolder(const QString& settingsFolder);

/// The paths of the lessons there, by their names.
[[nodiscard]] QStringList ownLessons(const QString& settingsFolder);

} // namespace sparkout
