// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/reports/report_commands.h"

#include "core/adequacy/prediction.h"
#include "core/project/batch.h"
#include "core/setup/setup_run.h"
#include "core/study/batch_edits.h"
#include "ui/report/course/worksheet.h"
#include "ui/report/documents/batch_wait.h"
#include "ui/report/documents/passport.h"
#include "ui/session/background.h"
#include "ui/session/settings.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/window/dialogs/handout_dialog.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QMessageBox>

#include <memory>
#include <utility>

namespace sparkout {

namespace {

void say(QMessageBox::Icon icon, const QString& title, const QString& text, QWidget* window) {
    QMessageBox box(icon, title, text, QMessageBox::Ok, window);
    box.setTextFormat(Qt::PlainText);
    box.exec();
}

} // namespace

ReportCommands::ReportCommands(std::function<Subject()> subject, Settings& settings,
                               QWidget* window)
    : QObject(window), m_subject(std::move(subject)), m_settings(settings), m_window(window) {}

std::optional<report::Report> ReportCommands::reportOfNow(report::Kind kind) {
    const Subject now = m_subject();
    if (!now.outcome || !now.outcome->ran()) {
        say(QMessageBox::Information, tr("No report"),
            tr("There is no result of these inputs, so there is nothing to report. The "
               "messages say what is wrong with them."),
            m_window);
        return {};
    }
    const report::KindRow& row = report::rowOf(kind);
    report::Subject subject;
    subject.outcome = now.outcome;
    subject.file = now.file;
    subject.date = documentDay();
    subject.company = m_settings.company();
    if (now.setup) {
        report::nameSurface(subject, *now.setup, now.surface);
    }
    subject.breathe = [] { QCoreApplication::processEvents(QEventLoop::ExcludeUserInputEvents); };
    std::optional<report::Paper> paper;
    if (kind == report::Kind::handout && now.cycle && !chooseHandout(subject, *now.cycle, paper)) {
        return {};
    }
    if (paper) {
        report::PaperWish wish;
        wish.file = now.file;
        wish.date = subject.date;
        wish.breathe = subject.breathe;
        return *paper == report::Paper::worksheet
                   ? report::worksheet(now.outcome, subject.handout.step, wish)
                   : report::worksheetKey(now.outcome, subject.handout.step, wish);
    }
    if (row.takesSetup && now.setup && !addSetup(subject, *now.setup)) {
        return {};
    }
    const bool wantsBatch = row.judgesBatch && now.outcome->result.project.batch;
    if (wantsBatch && !addBatch(subject, now.batch, row.takesBatch)) {
        return {};
    }
    if (row.judgesBatch && !addPrediction(subject, now.predicting)) {
        return {};
    }
    if (row.takesBatch && now.setup) {
        runAside([&] { subject.dressing = report::dressingOf(*now.setup); });
    }
    return row.make(subject);
}

bool ReportCommands::addBatch(report::Subject& subject, const BatchOutcomePtr& shown,
                              bool isNeeded) {
    const Project& project = subject.outcome->result.project;
    const bool fits = shown && shown->ran() && shown->result.status == BatchStatus::completed
                      && sameBatch(shown->result.project, project);
    subject.batch = fits ? shown : BatchWait(project, tr("Batch of the report"), m_window).wait();
    if (!subject.batch) {
        return false;
    }
    if (!subject.batch->ran() && !isNeeded) {
        subject.batch = nullptr;
        return true;
    }
    if (!subject.batch->ran()) {
        say(QMessageBox::Information, tr("No report"),
            tr("The batch cannot be run:") + QLatin1Char('\n')
                + Names::refusal(subject.batch->issues),
            m_window);
        return false;
    }
    if (!isNeeded) {
        return true;
    }
    runAside([&subject] { subject.worst = report::runWorstPart(*subject.batch); });
    return true;
}

/// Uses the project's own batch if it predicts all that was measured.
bool ReportCommands::addPrediction(report::Subject& subject, const BatchOutcomePtr& shown) {
    const Project& project = subject.outcome->result.project;
    if (!report::PassportMeasured::applies(project)) {
        return true;
    }
    const Project predicting = predictingProject(project);
    for (const BatchOutcomePtr& batch : {shown, subject.batch}) {
        if (batch && sameBatch(batch->result.project, predicting)) {
            subject.predicting = batch;
            return true;
        }
    }
    subject.predicting = BatchWait(predicting, tr("Batch of the report"), m_window).wait();
    return subject.predicting != nullptr;
}

bool ReportCommands::addSetup(report::Subject& subject, const Setup& setup) {
    auto made = std::make_shared<report::SetupSubject>();
    made->setup = setup;
    runAside([&made] { made->run = runSetup(made->setup); });
    if (hasErrors(made->run.issues)) {
        say(QMessageBox::Information, tr("No report"), Names::refusal(made->run.issues), m_window);
        return false;
    }
    subject.setup = std::move(made);
    return true;
}

bool ReportCommands::chooseHandout(report::Subject& subject, const CycleCursor& cycle,
                                   std::optional<report::Paper>& paper) {
    HandoutDialog dialog(subject.outcome, cycle, m_settings, m_window);
    if (dialog.exec() != QDialog::Accepted) {
        return false;
    }
    subject.handout = dialog.options();
    paper = dialog.paper();
    return true;
}

} // namespace sparkout
