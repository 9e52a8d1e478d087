// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"
#include "ui/report/course/course_papers.h"
#include "ui/report/course/institution.h"
#include "ui/report/documents/report_kinds.h"
#include "ui/session/company.h"

#include <QString>
#include <QStringList>

#include <optional>

namespace sparkout {

/// What the command line asks for.
struct ReportRequest {
    report::Kind kind = report::Kind::card;
    std::optional<report::Paper> paper; ///< of the course, in place of a kind
    report::Institution institution;    ///< of its title page
    QString file;
    QString output;
    Company company; ///< of the heads
    QString surface; ///< of a set-up, by its name or number; empty: all, or the one there is
    report::HandoutOptions handout;
    bool stepAsked = false;  ///< by --at
    bool viewsAsked = false; ///< by --views
};

/// Reads --at, --views and --answers; what is wrong with their values, or empty.
[[nodiscard]] QString readHandoutOptions(const manual::Given& given, ReportRequest& request);

/// `sparkout --report KIND FILE -o OUT`: writes a report of a project and returns the exit status.
/// A batch tells its progress on stderr; Ctrl+C ends it and leaves a file that was there.
[[nodiscard]] int writeReport(const ReportRequest& request);

/// `sparkout --report KIND FILE… -d DIR`: a report of each file under its name, one after the other
/// with its progress on stderr. Reports that are there are refused before anything is run, unless
/// `force`. What is refused does not stop the others; the exit status is the first that is not 0.
struct ManyReports {
    QStringList files;
    QString folder;
    QString suffix = QStringLiteral("pdf"); ///< of the format
    bool force = false;
};
[[nodiscard]] int writeReports(const ReportRequest& request, const ManyReports& many);

/// The keys of the kinds and of the papers of the course, "card, passport".
[[nodiscard]] QString reportKeys();

} // namespace sparkout
