// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export_command.h"

namespace sparkout {

/// Whether it asks for a batch, a sweep or a search.
[[nodiscard]] bool asksForStudy(const ExportRequest& request);

/// Runs it as the project says and writes its tables; returns the exit status. A stop leaves no
/// file.
[[nodiscard]] int writeStudy(const ExportRequest& request);

} // namespace sparkout
