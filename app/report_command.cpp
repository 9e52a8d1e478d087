// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_command.h"

#include "app/batch_watch.h"
#include "app/stop_signals.h"
#include "app/window_io.h"
#include "core/project/batch.h"
#include "core/study/evaluate.h"
#include "ui/report/format/report_text.h"

namespace sparkout {

namespace {

BatchOutcomePtr runWatched(const Project& project) {
    cli::BatchWatch watch(partsOf(project), true);
    BatchOptions options;
    options.stop = watch.stop();
    options.done = watch.done();
    return runWholeBatch(project, options);
}

} // namespace

QString readHandoutOption(const QString& option, const QString& value, ReportRequest& request) {
    if (option == u"--at") {
        const auto step = report::readStepWish(value);
        request.handout.step = step.value_or(report::StepWish());
        request.stepAsked = true;
        return step ? QString()
                    : QStringLiteral("--at is a step as 12,nz,z1,e1,r1,k9, not “%1”").arg(value);
    }
    if (option == u"--views") {
        const auto views = report::readHandoutViews(value);
        request.handout.views = views.value_or(std::set<report::HandoutView>());
        return views ? QString()
                     : QStringLiteral("--views are feeds, cycle, profiles, limits, with commas "
                                      "between, not “%1”")
                           .arg(value);
    }
    request.handout.answers = value == u"on";
    return value == u"on" || value == u"off" ? QString() : QStringLiteral("--answers is on or off");
}

int writeReport(const ReportRequest& request) {
    const std::optional<Project> project = projectOrSay(request.file, request.surface);
    if (!project) {
        return exitRefused;
    }
    const report::KindRow& row = report::rowOf(request.kind);
    report::Subject subject{evaluate(*project, {}), nullptr,        nullptr, request.file,
                            QDate::currentDate(),   request.handout};
    if (!subject.outcome->ran()) {
        return refuse(subject.outcome->issues);
    }
    if (request.stepAsked && !report::findStep(subject.outcome->trajectory, request.handout.step)) {
        say(stderr, QStringLiteral("sparkout: no step of this cycle is as --at says"));
        return exitUsage;
    }
    if (row.takesBatch && project->batch) {
        subject.batch = runWatched(*project);
        if (!subject.batch->ran()) {
            return refuse(subject.batch->issues);
        }
    }
    QByteArray bytes;
    if (cli::caughtSignal() == 0) {
        if (subject.batch) {
            subject.worst = report::runWorstPart(*subject.batch);
        }
        bytes = report::bytesOf(row.make(subject), *report::formatOf(request.output));
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
    return subject.outcome->result.status == RunStatus::completed ? 0 : exitCannotReachSize;
}

QString reportKeys() {
    QStringList keys;
    for (const report::KindRow& row : report::kinds()) {
        keys += QString::fromLatin1(row.key);
    }
    return keys.join(QStringLiteral(", "));
}

QString reportUsage() {
    QString kinds;
    for (const report::KindRow& row : report::kinds()) {
        kinds += QStringLiteral("                     %1: %2\n")
                     .arg(QString::fromLatin1(row.key), QString::fromUtf8(row.description));
    }
    return kinds;
}

} // namespace sparkout
