// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "ui/report/format/report.h"

namespace sparkout::report {

/// A report of a project, still without blocks: author, subject, file and date.
[[nodiscard]] Report begunReport(const QString& title, const Project& project, const QString& file,
                                 const QDate& date);

} // namespace sparkout::report
