// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export_command.h"

#include "app/study_command.h"
#include "app/window_io.h"
#include "core/study/outcome.h"
#include "ui/export/export_file.h"

#include <QFileInfo>
#include <QLocale>

namespace sparkout {

namespace {

/// The choice for a request; empty if the part cannot be exported to such a file.
std::optional<ExportChoice> choiceOf(const ExportRequest& request) {
    const QString suffix = QFileInfo(request.output).suffix().toLower();
    const bool russian = QLocale().language() == QLocale::Russian; // also the language of the texts
    const bool all = request.part == u"all";
    ExportChoice choice{suffix == u"xlsx"   ? ExportFormat::xlsx
                        : suffix == u"json" ? ExportFormat::json
                        : russian           ? ExportFormat::csvRussian
                                            : ExportFormat::csvEnglish,
                        {}};
    for (const ResultPart part : allResultParts) {
        if (all || request.part == QLatin1StringView(partKey(part))) {
            choice.parts.push_back(part);
        }
    }
    const bool fits = suffix == u"xlsx" || (suffix == u"csv" && !all) || (suffix == u"json" && all);
    return fits && !choice.parts.empty() ? std::optional(choice) : std::nullopt;
}

} // namespace

bool canExport(const ExportRequest& request) {
    if (asksForStudy(request)) {
        const QString suffix = QFileInfo(request.output).suffix().toLower();
        return suffix == u"xlsx" || suffix == u"csv";
    }
    return choiceOf(request).has_value();
}

int writeExport(const ExportRequest& request) {
    if (asksForStudy(request)) {
        return writeStudy(request);
    }
    const std::optional<Project> project = projectOrSay(request.file, request.surface);
    if (!project) {
        return exitRefused;
    }
    const OutcomePtr outcome = evaluate(*project, {});
    if (!outcome->ran()) {
        return refuse(outcome->issues);
    }
    const ExportChoice choice = *choiceOf(request);
    if (const QString obstacle = exportObstacle(outcome, choice); !obstacle.isEmpty()) {
        say(stderr, QStringLiteral("sparkout: %1").arg(obstacle));
        return exitRefused;
    }
    const QByteArray bytes = exportWork(outcome, choice)({});
    if (bytes.isEmpty()) {
        say(stderr, QStringLiteral("sparkout: the output could not be made"));
        return exitRefused;
    }
    if (!writeBytes(bytes, request.output)) {
        return exitRefused;
    }
    return outcome->result.status == RunStatus::completed ? 0 : exitCannotReachSize;
}

} // namespace sparkout
