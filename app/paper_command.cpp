// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_command.h"

#include "app/window_io.h"
#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/make_variants.h"
#include "core/lesson/work.h"
#include "core/study/outcome.h"
#include "ui/report/course_papers.h"
#include "ui/report/format/report_text.h"
#include "ui/report/worksheet.h"
#include "ui/session/project_io.h"
#include "ui/text/file_error_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QStringList>

#include <optional>
#include <string>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

const QString workEnding = QStringLiteral(".sparkout-work");
const QString lessonEnding = QStringLiteral(".sparkout-lesson");

std::optional<std::string> contentOrSay(const QString& path) {
    auto content = readFile(systemPath(path), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&content)) {
        say(stderr, QStringLiteral("sparkout: %1").arg(readErrorText(*error)));
        return std::nullopt;
    }
    return std::get<std::string>(std::move(content));
}

std::optional<Work> workOrSay(const QString& path) {
    const auto content = contentOrSay(path);
    if (!content) {
        return std::nullopt;
    }
    ReadWork read = readWork(*content);
    if (!read.work) {
        (void)refuse(read.issues);
        return std::nullopt;
    }
    if (brokenSeal(*read.work)) {
        say(stderr, QStringLiteral("sparkout: a seal of %1 is broken: it was edited outside "
                                   "the program")
                        .arg(printableText(path)));
    }
    return std::move(read.work);
}

report::PaperWish wishOf(const ReportRequest& request) {
    report::PaperWish wish;
    wish.institution = request.institution;
    wish.file = request.file;
    wish.date = documentDay();
    if (request.viewsAsked) {
        wish.figures = request.handout.views;
    }
    return wish;
}

std::optional<report::Report> paperOfWork(const ReportRequest& request) {
    const auto work = workOrSay(request.file);
    if (!work) {
        return std::nullopt;
    }
    return report::makePaper(*request.paper, *work, wishOf(request));
}

std::optional<report::Report> paperOfLesson(const ReportRequest& request) {
    const auto content = contentOrSay(request.file);
    if (!content) {
        return std::nullopt;
    }
    ReadLesson read = readLesson(*content);
    if (!read.lesson) {
        (void)refuse(read.issues);
        return std::nullopt;
    }
    return report::makePaper(*request.paper, withBestTimes(std::move(*read.lesson)),
                             wishOf(request));
}

std::optional<report::Report> paperOfProject(const ReportRequest& request) {
    const auto project = projectOrSay(request.file, request.surface);
    if (!project) {
        return std::nullopt;
    }
    const OutcomePtr outcome = evaluate(*project, {});
    if (!outcome->ran()) {
        (void)refuse(outcome->issues);
        return std::nullopt;
    }
    if (request.stepAsked && !report::findStep(outcome->trajectory, request.handout.step)) {
        say(stderr, QStringLiteral("sparkout: --at selects no step of this cycle"));
        return std::nullopt;
    }
    const report::PaperWish wish = wishOf(request);
    return *request.paper == report::Paper::worksheetKey
               ? report::worksheetKey(outcome, request.handout.step, wish)
               : report::worksheet(outcome, request.handout.step, wish);
}

/// Makes the paper; reports a failure and returns an empty value.
std::optional<report::Report> paperOrSay(const ReportRequest& request) {
    const report::PaperRow& row = report::rowOf(*request.paper);
    const bool isWork = request.file.endsWith(workEnding);
    const bool isLesson = request.file.endsWith(lessonEnding);
    if (isWork ? row.takesWork : isLesson ? row.takesLesson : row.takesProject) {
        return isWork     ? paperOfWork(request)
               : isLesson ? paperOfLesson(request)
                          : paperOfProject(request);
    }
    QStringList needed;
    for (const auto& [takes, what] :
         {std::pair(row.takesWork, "a student's work (.sparkout-work)"),
          std::pair(row.takesLesson, "the teacher's lesson (.sparkout-lesson)"),
          std::pair(row.takesProject, "a project (.sparkout)")}) {
        if (takes) {
            needed << QString::fromLatin1(what);
        }
    }
    say(stderr, QStringLiteral("sparkout: --report %1 needs %2")
                    .arg(QString::fromLatin1(row.key), needed.join(QStringLiteral(" or "))));
    return std::nullopt;
}

} // namespace

int writePaper(const ReportRequest& request) {
    const auto paper = paperOrSay(request);
    if (!paper) {
        return exitRefused;
    }
    const QByteArray bytes = report::bytesOf(*paper, *report::formatOf(request.output));
    if (bytes.isEmpty()) {
        say(stderr, QStringLiteral("sparkout: the report could not be made"));
        return exitRefused;
    }
    return writeBytes(bytes, request.output) ? 0 : exitRefused;
}

} // namespace sparkout
