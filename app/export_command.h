// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace sparkout {

/// What the command line asks for.
struct ExportRequest {
    QString part; ///< "all", a part of the result, "batch", "sweep" or "search"
    QString file;
    QString surface; ///< of it; empty: it has one
    QString output;
};

/// Whether the part goes into a file of that ending.
[[nodiscard]] bool canExport(const ExportRequest& request);

/// `sparkout --export PART -o OUT FILE`: writes results of a project as tables and returns the exit
/// status.
[[nodiscard]] int writeExport(const ExportRequest& request);

} // namespace sparkout
