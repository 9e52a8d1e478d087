// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_command.h"

#include "app/batch_watch.h"
#include "app/search_watch.h"
#include "app/stop_signals.h"
#include "app/window_io.h"
#include "core/measured/adequacy.h"
#include "core/project/batch.h"
#include "core/setup/setup_run.h"
#include "core/study/batch_edits.h"
#include "core/study/outcome.h"
#include "ui/report/export_file.h"
#include "ui/report/format/report_text.h"
#include "ui/report/passport.h"
#include "ui/session/document.h"
#include "ui/text/file_error_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"
#include "ui/views/study/optimise_text.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>

#include <algorithm>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>

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

namespace {

BatchOutcomePtr runWatched(const Project& project) {
    cli::BatchWatch watch(partsOf(project), true);
    BatchOptions options;
    options.stop = watch.stop();
    options.done = watch.done();
    return runWholeBatch(project, options);
}

} // namespace

QString readHandoutOptions(const manual::Given& given, ReportRequest& request) {
    request.stepAsked = given.has("--at");
    if (request.stepAsked) {
        const auto step = report::readStepWish(fromSystemText(given.text("--at")));
        if (!step) {
            return QString::fromStdString(given.refusal("--at"));
        }
        request.handout.step = *step;
    }
    request.viewsAsked = given.has("--views");
    if (request.viewsAsked) {
        const auto views = report::readHandoutViews(fromSystemText(given.text("--views")));
        if (!views) {
            return QString::fromStdString(given.refusal("--views"));
        }
        request.handout.views = *views;
    }
    request.handout.answers = given.text("--answers") != "off";
    return {};
}

namespace {

/// The set-up of a file; if a surface is named, only this one, with the wheel as the earlier
/// surfaces leave it. Reports faults.
std::optional<Setup> setupOrSay(const ReportRequest& request) {
    auto setup = openSetupOrSay(request.file);
    if (!setup || request.surface.isEmpty()) {
        return setup;
    }
    auto project = projectOrSay(request.file, request.surface);
    if (!project) {
        return {};
    }
    const std::string name = setup->surfaces[*setup->find(request.surface.toStdString())].name;
    setup->surfaces = {GroundSurface{name, std::move(*project)}};
    setup->wear = {}; // the project contains the worn wheel
    return setup;
}

/// The subject of a report; otherwise the exit status after reporting why there is none.
std::variant<report::Subject, int> subjectOf(const ReportRequest& request) {
    report::Subject subject;
    subject.file = request.file;
    subject.date = documentDay();
    subject.handout = request.handout;
    subject.company = request.company;
    if (report::rowOf(request.kind).takesSetup) {
        auto setup = setupOrSay(request);
        if (!setup) {
            return exitRefused;
        }
        auto run = runSetup(*setup);
        if (hasErrors(run.issues)) {
            return refuse(run.issues);
        }
        subject.setup = std::make_shared<report::SetupSubject>(
            report::SetupSubject{std::move(*setup), std::move(run)});
        return subject;
    }
    const std::optional<Project> project = projectOrSay(request.file, request.surface);
    if (!project) {
        return exitRefused;
    }
    subject.outcome = evaluate(*project, {});
    if (!subject.outcome->ran()) {
        return refuse(subject.outcome->issues);
    }
    if (request.stepAsked && !report::findStep(subject.outcome->trajectory, request.handout.step)) {
        say(stderr, QStringLiteral("sparkout: --at selects no step of this cycle"));
        return exitUsage;
    }
    if (report::rowOf(request.kind).judgesBatch && project->batch) {
        subject.batch = runWatched(*project);
        if (!subject.batch->ran() && report::rowOf(request.kind).takesBatch) {
            return refuse(subject.batch->issues);
        }
        if (!subject.batch->ran()) {
            subject.batch = nullptr; // the report is not about the batch
        }
    }
    if (report::rowOf(request.kind).judgesBatch && report::PassportMeasured::applies(*project)) {
        const Project predicting = predictingProject(*project);
        const bool fits = subject.batch && sameBatch(subject.batch->result.project, predicting);
        subject.predicting = fits ? subject.batch : runWatched(predicting);
    }
    if (const auto setup = openSetupOrSay(request.file)) {
        const std::string name = request.surface.toStdString();
        report::nameSurface(subject, *setup, setup->find(name).value_or(0));
        subject.dressing =
            report::rowOf(request.kind).takesBatch ? report::dressingOf(*setup) : nullptr;
    }
    return subject;
}

bool isCompleted(const report::Subject& subject) {
    return subject.setup ? subject.setup->run.isCompleted(subject.setup->setup)
                         : subject.outcome->result.status == RunStatus::completed;
}

} // namespace

int writeReport(const ReportRequest& request) {
    if (request.paper) {
        return writePaper(request);
    }
    auto read = subjectOf(request);
    if (const int* status = std::get_if<int>(&read)) {
        return *status;
    }
    auto& subject = std::get<report::Subject>(read);
    QByteArray bytes;
    if (cli::caughtSignal() == 0) {
        if (subject.batch) {
            subject.worst = report::runWorstPart(*subject.batch);
        }
        bytes = report::bytesOf(report::rowOf(request.kind).make(subject),
                                *report::formatOf(request.output));
    }
    if (cli::caughtSignal() != 0) {
        say(stderr, QStringLiteral("sparkout: ended, nothing was written"));
        return exitInterrupted + cli::caughtSignal();
    }
    if (bytes.isEmpty()) {
        say(stderr, QStringLiteral("sparkout: the report could not be made"));
        return exitRefused;
    }
    if (!writeBytes(bytes, request.output)) {
        return exitRefused;
    }
    return isCompleted(subject) ? 0 : exitCannotReachSize;
}

namespace {

/// The paths of the reports, in the order of the files; if one cannot be written, reports it and
/// returns an empty list.
QStringList outputsOf(const ManyReports& many) {
    QStringList outputs, faults;
    const QDir folder(many.folder);
    if (!folder.exists()) {
        faults << QStringLiteral("there is no folder %1").arg(printableText(many.folder));
    }
    for (const QString& file : many.files) {
        const QString name = QFileInfo(file).completeBaseName() + QLatin1Char('.') + many.suffix;
        const QString output = folder.filePath(name);
        const QString target = QFileInfo(output).canonicalFilePath();
        const bool isProject =
            !target.isEmpty() && std::ranges::any_of(many.files, [&target](const QString& other) {
                return QFileInfo(other).canonicalFilePath() == target;
            });
        if (isProject) {
            faults << QStringLiteral("%1 would replace a project").arg(printableText(output));
        } else if (outputs.contains(output)) {
            faults << QStringLiteral("two of the files would be written to %1")
                          .arg(printableText(output));
        } else if (QFileInfo::exists(output) && !many.force) {
            faults << QStringLiteral("%1 exists; --force replaces it").arg(printableText(output));
        }
        outputs << output;
    }
    for (const QString& fault : faults) {
        say(stderr, QStringLiteral("sparkout: %1").arg(fault));
    }
    return faults.isEmpty() ? outputs : QStringList();
}

} // namespace

int writeReports(const ReportRequest& request, const ManyReports& many) {
    const QStringList outputs = outputsOf(many);
    if (outputs.isEmpty()) {
        say(stderr, QStringLiteral("sparkout: nothing was written"));
        return exitRefused;
    }
    cli::catchStopSignals();
    int status = 0;
    for (qsizetype i = 0; i < outputs.size() && cli::caughtSignal() == 0; ++i) {
        say(stderr, QStringLiteral("%1 of %2: %3")
                        .arg(i + 1)
                        .arg(outputs.size())
                        .arg(printableText(many.files[i])));
        ReportRequest one = request;
        one.file = many.files[i];
        one.output = outputs[i];
        const int ended = writeReport(one);
        status = status == 0 ? ended : status;
    }
    return cli::caughtSignal() != 0 ? exitInterrupted + cli::caughtSignal() : status;
}

QString reportKeys() {
    QStringList keys;
    for (const report::KindRow& row : report::kinds()) {
        keys += QString::fromLatin1(row.key);
    }
    for (const report::PaperRow& row : report::papers()) {
        keys += QString::fromLatin1(row.key);
    }
    return keys.join(QStringLiteral(", "));
}

} // namespace sparkout
