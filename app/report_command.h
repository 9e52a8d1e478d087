// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/documents/report_kinds.h"

namespace sparkout {

/// What the command line asks for.
struct ReportRequest {
    report::Kind kind = report::Kind::card;
    QString file;
    QString surface; ///< of it; empty: it has one
    QString output;
    report::HandoutOptions handout;
    bool stepAsked = false; ///< by --at
};

/// Reads --at, --views or --answers; what is wrong with its value, or empty.
[[nodiscard]] QString readHandoutOption(const QString& option, const QString& value,
                                        ReportRequest& request);

/// `sparkout --report KIND FILE -o OUT`: writes a report of a project and returns the exit status.
/// A batch tells its progress on stderr; Ctrl+C ends it and leaves a file that was there.
[[nodiscard]] int writeReport(const ReportRequest& request);

/// The keys of the kinds, "card, passport", and a line a kind that says what it is.
[[nodiscard]] QString reportKeys();
[[nodiscard]] QString reportUsage();

} // namespace sparkout
