// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report_command.h"

#include "app/batch_watch.h"
#include "app/stop_signals.h"
#include "app/window_io.h"
#include "ui/dialogs/faults_dialog.h"
#include "ui/report/report_text.h"
#include "ui/session/document.h"
#include "ui/session/run_controller.h"

namespace sparkout {

namespace {

int refuse(const Issues& issues) {
    for (const QString& line : FaultsDialog::lines(issues)) {
        say(stderr, QStringLiteral("sparkout: %1").arg(line));
    }
    return exitRefused;
}

BatchOutcomePtr runWatched(const Project& project) {
    cli::BatchWatch watch(partsOf(project), true);
    BatchOptions options;
    options.stop = watch.stop();
    options.done = watch.done();
    return runWholeBatch(project, options);
}

} // namespace

int writeReport(report::Kind kind, const QString& file, const QString& output) {
    Document document;
    if (!openOrSay(document, file)) {
        return exitRefused;
    }
    const report::KindRow& row = report::rowOf(kind);
    report::Subject subject{runProject(document.project(), {}), nullptr, nullptr, file,
                            QDate::currentDate()};
    if (!subject.outcome->ran()) {
        return refuse(subject.outcome->issues);
    }
    if (row.takesBatch && document.project().batch) {
        subject.batch = runWatched(document.project());
        if (!subject.batch->ran()) {
            return refuse(subject.batch->issues);
        }
    }
    QByteArray bytes;
    if (cli::caughtSignal() == 0) {
        if (subject.batch) {
            subject.worst = report::runWorstPart(*subject.batch);
        }
        bytes = report::bytesOf(row.make(subject), *report::formatOf(output));
    }
    if (cli::caughtSignal() != 0) {
        say(stderr, QStringLiteral("sparkout: ended, nothing was written"));
        return exitInterrupted + cli::caughtSignal();
    }
    if (bytes.isEmpty()) {
        say(stderr, QStringLiteral("sparkout: the report could not be made"));
        return exitRefused;
    }
    if (!writeBytes(bytes, output)) {
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
                     .arg(QString::fromLatin1(row.key), QString::fromUtf8(row.told));
    }
    return kinds;
}

} // namespace sparkout
