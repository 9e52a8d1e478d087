// SPDX-License-Identifier: GPL-3.0-or-later
// Projects and edits that are told apart by the diameter of the part.
#pragma once

#include "core/file/project_file.h"
#include "core/study/new_project.h"
#include "tests/whole_project.h"
#include "ui/session/document.h"

#include <QByteArray>

namespace sparkout {

inline constexpr EditText editText{"Input", "Diameter"};

inline void setDiameter(Document& document, double diameter_mm) {
    Project project = document.project();
    project.part->diameter_mm = diameter_mm;
    document.edit(project, editText);
}

inline QByteArray textWith(double diameter_mm) {
    Project project = newProject(Operation::traverse);
    project.part->diameter_mm = diameter_mm;
    return QByteArray::fromStdString(writeProject(project));
}

} // namespace sparkout
