// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/study_command.h"

#include "app/io/batch_watch.h"
#include "app/io/stop_signals.h"
#include "app/search_watch.h"
#include "app/window_io.h"
#include "core/project/batch.h"
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

} // namespace

bool asksForStudy(const ExportRequest& request) {
    return kindOf(request).has_value();
}

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

} // namespace sparkout
