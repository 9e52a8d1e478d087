// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/table_file.h"

#include "core/project/project.h"

namespace sparkout {

/// Asks for a place and runs the batch of a project again, this time with a row for every part in a
/// CSV file: factors, quantities, requirements. It tells how far it is and can be stopped, which
/// leaves no file. True once it is saved.
bool savePartRows(QWidget* window, Settings* settings, const Project& project, TableFormat format);

} // namespace sparkout
