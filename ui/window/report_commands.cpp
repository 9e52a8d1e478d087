// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/report_commands.h"

#include "core/adequacy/prediction.h"
#include "core/project/batch.h"
#include "core/setup/setup_run.h"
#include "core/study/batch_edits.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/kit/help_topic.h"
#include "ui/report/course/worksheet.h"
#include "ui/report/documents/batch_wait.h"
#include "ui/report/documents/passport_measured.h"
#include "ui/report/format/pages.h"
#include "ui/session/background.h"
#include "ui/session/settings.h"
#include "ui/text/names.h"
#include "ui/window/dialogs/handout_dialog.h"

#include <QAction>
#include <QCoreApplication>
#include <QEventLoop>
#include <QMessageBox>
#include <QPrintDialog>
#include <QPrintPreviewDialog>
#include <QPrinter>

#include <memory>
#include <utility>

namespace sparkout {

namespace {

void setUp(QPrinter& printer, const report::Report& report) {
    report::setUpPaper(printer, report);
    printer.setDocName(fileNameOf({report.title, report.subject}));
    printer.setCreator(report.program);
}

constexpr const char* qtPageSetup = "Page setup"; ///< translated by Qt itself

void hidePageSetup(QPrintPreviewDialog& dialog) {
    for (QAction* action : dialog.findChildren<QAction*>()) {
        if (action->text() == QCoreApplication::translate("QPrintPreviewDialog", qtPageSetup)) {
            action->setVisible(false);
        }
    }
}

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
    subject.date = QDate::currentDate();
    subject.company = m_settings.company();
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
    const bool wantsBatch = row.takesBatch && now.outcome->result.project.batch;
    if (wantsBatch && !addBatch(subject, now.batch)) {
        return {};
    }
    if (row.takesBatch && !addPrediction(subject, now.predicting)) {
        return {};
    }
    if (row.takesBatch && now.setup) {
        runAside([&] { subject.dressing = report::dressingOf(*now.setup); });
    }
    return row.make(subject);
}

bool ReportCommands::addBatch(report::Subject& subject, const BatchOutcomePtr& shown) {
    const Project& project = subject.outcome->result.project;
    const bool fits = shown && shown->ran() && shown->result.status == BatchStatus::completed
                      && sameBatch(shown->result.project, project);
    subject.batch = fits ? shown : BatchWait(project, tr("Batch of the report"), m_window).wait();
    if (!subject.batch) {
        return false;
    }
    if (!subject.batch->ran()) {
        say(QMessageBox::Information, tr("No report"),
            tr("The batch cannot be run:") + QLatin1Char('\n')
                + Names::refusal(subject.batch->issues),
            m_window);
        return false;
    }
    runAside([&subject] { subject.worst = report::runWorstPart(*subject.batch); });
    return true;
}

/// Of the project's own batch, where that predicts all that was measured.
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

void ReportCommands::preview(report::Kind kind) {
    const auto report = reportOfNow(kind);
    if (!report) {
        return;
    }
    QPrinter printer(QPrinter::HighResolution);
    setUp(printer, *report);
    QPrintPreviewDialog dialog(&printer, m_window);
    if (printer.outputFormat() != QPrinter::NativeFormat) {
        hidePageSetup(dialog); // it is the printer's, and there is none; now, by its present name
    }
    dialog.setWindowTitle(tr("Print preview: %1").arg(report->title));
    setHelpTopic(dialog, QStringLiteral("reports#print"));
    std::optional<report::Pages> pages;
    QSizeF area = report::areaOf(printer);
    runAside([&] { pages.emplace(*report, area); });
    connect(&dialog, &QPrintPreviewDialog::paintRequested, this, [&](QPrinter* target) {
        if (report::areaOf(*target) != area) {
            area = report::areaOf(*target);
            pages.emplace(*report, area);
        }
        (void)report::printPages(*pages, *target);
    });
    dialog.resize(m_window->size() * 0.9);
    dialog.exec();
}

void ReportCommands::print(report::Kind kind) {
    const auto report = reportOfNow(kind);
    if (!report) {
        return;
    }
    QPrinter printer(QPrinter::HighResolution);
    setUp(printer, *report);
    QPrintDialog dialog(&printer, m_window);
    dialog.setWindowTitle(tr("Print: %1").arg(report->title));
    setHelpTopic(dialog, QStringLiteral("reports#print"));
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    bool printed = false;
    runAside([&] {
        const report::Pages pages(*report, report::areaOf(printer));
        printed = report::printPages(pages, printer);
    });
    if (!printed) {
        say(QMessageBox::Critical, tr("Not printed"),
            tr("The printer or the file did not take the pages."), m_window);
    }
}

void ReportCommands::exportReport(report::Kind kind, report::Format format) {
    const auto report = reportOfNow(kind);
    if (!report) {
        return;
    }
    SaveRequest request{
        tr("Export: %1").arg(report->title),
        fileNameOf({report->title, report->subject}),
        {},
        {},
        {},
        [&](const KeepGoing& keepGoing) { return bytesOf(*report, format, keepGoing); }};
    switch (format) {
    case report::Format::pdf:
        request.suffix = QStringLiteral("pdf");
        request.filter = tr("PDF documents (*.pdf)");
        break;
    case report::Format::html:
        request.suffix = QStringLiteral("html");
        request.filter = tr("Web pages (*.html)");
        break;
    case report::Format::markdown:
        request.suffix = QStringLiteral("md");
        request.filter = tr("Markdown texts (*.md)");
        break;
    case report::Format::odt:
        request.suffix = QStringLiteral("odt");
        request.filter = tr("OpenDocument texts (*.odt)");
        break;
    }
    (void)saveWithDialog(m_window, &m_settings, request);
}

} // namespace sparkout
