// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/table_file.h"

#include "core/project/project.h"

namespace sparkout {

/// Asks for a file and runs the batch again with a row for every part in a CSV file: factors,
/// quantities, requirements. Shows progress; a stop leaves no file. True once it is saved.
bool savePartRows(QWidget* window, Settings* settings, const Project& project, TableFormat format);

} // namespace sparkout
