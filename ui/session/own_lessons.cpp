// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/own_lessons.h"

#include <QDir>

namespace sparkout {

QString ownLessonsFolder(const QString& settingsFolder) {
    return settingsFolder.isEmpty() ? QString() : settingsFolder + QStringLiteral("/lessons");
}

QStringList ownLessons(const QString& settingsFolder) {
    QStringList paths;
    if (const QString folder = ownLessonsFolder(settingsFolder); !folder.isEmpty()) {
        const QDir dir(folder, QStringLiteral("*.sparkout-lesson"), QDir::Name, QDir::Files);
        for (const QString& name : dir.entryList()) {
            paths += dir.filePath(name);
        }
    }
    return paths;
}

} // namespace sparkout
