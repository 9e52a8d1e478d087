// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_command.h"

#include "app/batch_watch.h"
#include "app/stop_signals.h"
#include "app/window_io.h"
#include "core/project/batch.h"
#include "core/setup/setup_run.h"
#include "core/study/evaluate.h"
#include "ui/report/format/report_text.h"
#include "ui/session/document.h"

#include <memory>
#include <utility>
#include <variant>

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

namespace {

/// What is to be reported of a file; else the exit status that says why there is nothing.
std::variant<report::Subject, int> subjectOf(const ReportRequest& request) {
    report::Subject subject;
    subject.file = request.file;
    subject.date = QDate::currentDate();
    subject.handout = request.handout;
    subject.company = request.company;
    if (report::rowOf(request.kind).takesSetup) {
        auto setup = openSetupOrSay(request.file);
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
    Document document;
    if (!openOrSay(document, request.file)) {
        return exitRefused;
    }
    subject.outcome = evaluate(document.project(), {});
    if (!subject.outcome->ran()) {
        return refuse(subject.outcome->issues);
    }
    if (request.stepAsked && !report::findStep(subject.outcome->trajectory, request.handout.step)) {
        say(stderr, QStringLiteral("sparkout: no step of this cycle is as --at says"));
        return exitUsage;
    }
    if (report::rowOf(request.kind).takesBatch && document.project().batch) {
        subject.batch = runWatched(document.project());
        if (!subject.batch->ran()) {
            return refuse(subject.batch->issues);
        }
    }
    return subject;
}

bool isCompleted(const report::Subject& subject) {
    return subject.setup ? subject.setup->run.isCompleted(subject.setup->setup)
                         : subject.outcome->result.status == RunStatus::completed;
}

} // namespace

int writeReport(const ReportRequest& request) {
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
