// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/report_kinds.h"

namespace sparkout {

/// `sparkout --report KIND FILE -o OUT`: writes a report of a project and returns the exit status.
/// A batch tells its progress on stderr; Ctrl+C ends it and leaves a file that was there.
[[nodiscard]] int writeReport(report::Kind kind, const QString& file, const QString& output);

/// The keys of the kinds, "card, passport", and a line a kind that says what it is.
[[nodiscard]] QString reportKeys();
[[nodiscard]] QString reportUsage();

} // namespace sparkout
