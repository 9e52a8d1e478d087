// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace sparkout {

/// An export requested on the command line.
struct ExportRequest {
    QString part; ///< "all", a part of the result, "batch", "sweep" or "search"
    QString file;
    QString surface; ///< name or number of a surface; empty: the only one
    QString output;
};

/// Whether the part can be exported to a file with this extension.
[[nodiscard]] bool canExport(const ExportRequest& request);

/// `sparkout --export PART -o OUT FILE`: writes results of a project as tables and returns the exit
/// status.
[[nodiscard]] int writeExport(const ExportRequest& request);

} // namespace sparkout
