// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export_command.h"

#include "app/io/batch_watch.h"
#include "app/io/stop_signals.h"
#include "app/search_watch.h"
#include "app/window_io.h"
#include "core/project/batch.h"
#include "core/study/outcome.h"
#include "ui/export/export_file.h"
#include "ui/session/document.h"
#include "ui/views/optimise/optimise_text.h"

#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <memory>

namespace sparkout {

namespace {

std::optional<StudyKind> kindOf(const ExportRequest& request) {
    const auto found = std::ranges::find_if(allStudyKinds, [&request](StudyKind kind) {
        return request.part == QLatin1StringView(studyKey(kind));
    });
    return found == allStudyKinds.end() ? std::nullopt : std::optional(*found);
}

int refuseFor(const QString& text) {
    say(stderr, QStringLiteral("sparkout: %1").arg(text));
    return exitRefused;
}

int ranBatch(const Project& project, Study& study) {
    if (!project.batch) {
        return refuseFor(QStringLiteral("the project has no batch (/batch)"));
    }
    cli::BatchWatch watch(partsOf(project), true);
    BatchOptions options;
    options.stop = watch.stop();
    options.done = watch.done();
    study.batch = runWholeBatch(project, options);
    return study.batch->ran() ? 0 : refuse(study.batch->issues);
}

int ranSweep(const Project& project, Study& study) {
    if (!project.sweep) {
        return refuseFor(QStringLiteral("the project has no sweep (/sweep)"));
    }
    cli::BatchWatch watch(pointsOf(project), true, "points");
    study.sweep = std::make_shared<SweepResult>(runSweep(project, {0, watch.stop(), watch.done()}));
    return study.sweep->ran() ? 0 : refuse(study.sweep->issues);
}

/// The wear of the wheel in the file's set-up, if it is given.
std::optional<SurfaceWear> wearIn(const ExportRequest& request) {
    Document document;
    return openOrSay(document, request.file, request.surface)
               ? searchWear(document.setup(), document.surface())
               : std::nullopt;
}

/// Runs a search with one line of progress per second; Ctrl+C and SIGTERM stop it.
int ranSearch(const Project& project, const ExportRequest& request, Study& study) {
    if (!project.optimisation) {
        return refuseFor(QStringLiteral("the project has no search (/optimisation)"));
    }
    const SearchWish wish{.front = true, .wear = wearIn(request)};
    cli::SearchWatch watch(
        {}, [](const SearchState& state) { return OptimiseText::state(state).toStdString(); });
    study.search = search(project, wish, watch.token(),
                          {.note = [&watch](const SearchState& state) { watch.note(state); }});
    study.before_s = study.search->given.time_s;
    if (!study.search->ran()) {
        return refuseFor(OptimiseText::fault(*study.search));
    }
    if (cli::caughtSignal() == 0 && !study.search->best()) {
        say(stderr, QStringLiteral("sparkout: %1").arg(OptimiseText::notes(*study.search)));
        return study.search->unresolved() ? exitUndecided : exitNothingFeasible;
    }
    return 0;
}

/// Whether the request is for a batch, a sweep or a search.
bool asksForStudy(const ExportRequest& request) {
    return kindOf(request).has_value();
}

/// Runs the study of the project and writes its tables; returns the exit status. After a stop no
/// file is written.
int writeStudy(const ExportRequest& request) {
    const std::optional<Project> project = projectOrSay(request.file, request.surface);
    if (!project) {
        return exitRefused;
    }
    const StudyKind kind = *kindOf(request);
    Study study;
    const int failed = kind == StudyKind::batch   ? ranBatch(*project, study)
                       : kind == StudyKind::sweep ? ranSweep(*project, study)
                                                  : ranSearch(*project, request, study);
    if (cli::caughtSignal() != 0) {
        say(stderr, QStringLiteral("sparkout: ended, nothing was written"));
        return exitInterrupted + cli::caughtSignal();
    }
    if (failed != 0) {
        return failed;
    }
    const bool xlsx = QFileInfo(request.output).suffix().toLower() == u"xlsx";
    const bool russian = QLocale().language() == QLocale::Russian;
    const ExportFormat format = xlsx      ? ExportFormat::xlsx
                                : russian ? ExportFormat::csvRussian
                                          : ExportFormat::csvEnglish;
    const QByteArray bytes = studyWork(study, format)({});
    if (bytes.isEmpty()) {
        return refuseFor(QStringLiteral("the output could not be made"));
    }
    return writeBytes(bytes, request.output) ? 0 : exitRefused;
}

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
