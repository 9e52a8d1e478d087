// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/export_command.h"

namespace sparkout {

/// Whether the request is for a batch, a sweep or a search.
[[nodiscard]] bool asksForStudy(const ExportRequest& request);

/// Runs the study of the project and writes its tables; returns the exit status. After a stop no
/// file is written.
[[nodiscard]] int writeStudy(const ExportRequest& request);

} // namespace sparkout
