// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/whole_project.h"
#include "ui/session/project_io.h"

#include <QString>

/// Shipped examples, by their names without the ending.
namespace sparkout {

inline QString examplePath(const char* name) {
    return QStringLiteral(SPARKOUT_SOURCE_DIR "/resources/examples/%1.sparkout")
        .arg(QString::fromUtf8(name));
}

inline Project exampleProject(const char* name) {
    return loadProject(examplePath(name)).setup.value().surfaces.front().project;
}

} // namespace sparkout
