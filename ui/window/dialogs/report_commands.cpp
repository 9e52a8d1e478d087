// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/report_commands.h"

#include "core/measured/adequacy.h"
#include "core/project/batch.h"
#include "core/setup/setup_run.h"
#include "core/study/batch_edits.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/kit/help_topic.h"
#include "ui/report/passport.h"
#include "ui/report/worksheet.h"
#include "ui/session/background.h"
#include "ui/session/settings.h"
#include "ui/text/example_texts.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/views/study/batch_text.h"
#include "ui/window/dialogs/export_dialog.h"
#include "ui/window/dialogs/handout_dialog.h"

#include <QCoreApplication>
#include <QEventLoop>
#include <QHBoxLayout>
#include <QLabel>
#include <QMessageBox>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include <algorithm>
#include <memory>
#include <utility>

namespace sparkout {

ExportCommands::ExportCommands(std::function<OutcomePtr()> outcome,
                               std::function<std::vector<StudyOffer>()> studies, Settings& settings,
                               QWidget* window)
    : QObject(window)
    , m_outcome(std::move(outcome))
    , m_studies(std::move(studies))
    , m_settings(settings)
    , m_window(window) {}

void ExportCommands::exportResults() {
    const OutcomePtr outcome = m_outcome();
    if (!outcome || !outcome->ran()) {
        QMessageBox box(QMessageBox::Information, tr("No results"),
                        tr("There is no result of these inputs, so there is nothing to export. The "
                           "messages list the faults."),
                        QMessageBox::Ok, m_window);
        box.setTextFormat(Qt::PlainText);
        box.exec();
        return;
    }
    ExportDialog dialog(outcome, m_format, m_window, m_studies());
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    const ExportChoice choice = dialog.choice();
    m_format = choice.format;
    const Project& project = outcome->result.project;
    const Study* study = dialog.study();
    const QString content = study ? studyName(study->kind())
                            : choice.parts.size() == 1
                                ? partName(choice.parts.front(), project.operation)
                                : tr("Results");
    const SaveRequest request{tr("Export results"),
                              fileNameOf({exampleTitle(project.title), content}),
                              exportSuffix(choice.format),
                              exportFilter(choice.format),
                              {},
                              study ? studyWork(*study, choice.format)
                                    : exportWork(outcome, choice)};
    (void)saveWithDialog(m_window, &m_settings, request);
}

namespace {
constexpr int waitSteps = 1000;
constexpr int waitWidth = 420;
constexpr int unseen_ms = 300; ///< a batch that ends earlier shows no dialog
} // namespace

BatchWait::BatchWait(const Project& project, const QString& what, QWidget* parent)
    : QDialog(parent)
    , m_project(project)
    , m_text(new QLabel(tr("The batch of this report is being run."), this))
    , m_progress(new QProgressBar(this))
    , m_stop(new QPushButton(tr("&Stop"), this)) {
    setWindowTitle(what);
    setHelpTopic(*this, QStringLiteral("reports#passport"));
    m_text->setTextFormat(Qt::PlainText);
    m_progress->setRange(0, waitSteps);
    m_progress->setAccessibleName(tr("Progress of the batch"));
    m_progress->setMinimumWidth(waitWidth);
    m_stop->setObjectName(QStringLiteral("stopWaiting"));
    m_stop->setToolTip(tr("Stop the batch; no report is written"));
    auto* column = new QVBoxLayout(this);
    column->addWidget(m_text);
    column->addWidget(m_progress);
    auto* row = new QHBoxLayout;
    row->addStretch();
    row->addWidget(m_stop);
    column->addLayout(row);
    showProgress(0, partsOf(project), -1);
    connect(m_stop, &QPushButton::clicked, this, &QDialog::reject);
    connect(&m_job, &Job::progressed, this, &BatchWait::showProgress);
}

void BatchWait::showProgress(qint64 done, qint64 parts, double left_s) {
    m_progress->setValue(static_cast<int>(done * waitSteps / std::max(parts, qint64(1))));
    m_progress->setFormat(BatchText::progress(done, parts, left_s));
}

BatchOutcomePtr BatchWait::wait() {
    m_job.start(
        partsOf(m_project),
        [project = m_project](const Job::Means& means) { return batchOf(project, means); },
        [this](const BatchOutcomePtr& outcome) {
            m_outcome = outcome;
            accept();
        });
    QEventLoop briefly;
    QTimer::singleShot(unseen_ms, &briefly, &QEventLoop::quit);
    connect(&m_job, &Job::answered, &briefly, &QEventLoop::quit);
    briefly.exec(QEventLoop::ExcludeUserInputEvents);
    if (!m_outcome) {
        exec();
        m_job.drop(); // after a stop
    }
    return m_outcome;
}

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
            tr("There is no result of these inputs, so there is nothing to report. The messages "
               "list the faults."),
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
