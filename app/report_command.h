// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"
#include "ui/report/course_papers.h"
#include "ui/report/paper_writer.h"
#include "ui/report/report_kinds.h"
#include "ui/session/settings.h"

#include <QString>
#include <QStringList>

#include <optional>

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

/// A report requested on the command line.
struct ReportRequest {
    report::Kind kind = report::Kind::card;
    std::optional<report::Paper> paper; ///< a paper of the course, in place of a kind
    report::Institution institution;    ///< institution on its title page
    QString file;
    QString output;
    Company company; ///< company in the heads of documents
    QString surface; ///< surface of a set-up, by name or number; empty: all, or the only one
    report::HandoutOptions handout;
    bool stepAsked = false;  ///< given by --at
    bool viewsAsked = false; ///< given by --views
};

/// Reads --at, --views and --answers; returns the fault of their values, or an empty text.
[[nodiscard]] QString readHandoutOptions(const manual::Given& given, ReportRequest& request);

/// `sparkout --report KIND FILE -o OUT`: writes a report of a project and returns the exit status.
/// A batch reports its progress on stderr; Ctrl+C ends it and keeps an existing file.
[[nodiscard]] int writeReport(const ReportRequest& request);

/// `sparkout --report KIND FILE… -d DIR`: writes a report for each file under its name, one after
/// the other, with the progress on stderr. Existing reports are refused before anything is run,
/// unless `force` is set. A refused file does not stop the others; the exit status is the first
/// that is not 0.
struct ManyReports {
    QStringList files;
    QString folder;
    QString suffix = QStringLiteral("pdf"); ///< of the format
    bool force = false;
};
[[nodiscard]] int writeReports(const ReportRequest& request, const ManyReports& many);

/// `sparkout --report lab-report FILE -o OUT`, likewise for the worksheet, its key and the guide:
/// writes a paper of the course from a student's work, the teacher's lesson or a project, depending
/// on the paper, and returns the exit status.
[[nodiscard]] int writePaper(const ReportRequest& request);

/// The keys of the kinds and of the papers of the course, "card, passport".
[[nodiscard]] QString reportKeys();

} // namespace sparkout
