// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/reports/report_output.h"

#include "ui/dialogs/file_questions.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/kit/help_topic.h"
#include "ui/report/format/pages.h"
#include "ui/session/background.h"
#include "ui/window/reports/report_actions.h"

#include <QAction>
#include <QCoreApplication>
#include <QPrintDialog>
#include <QPrintPreviewDialog>
#include <QPrinter>

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

} // namespace

ReportOutput::ReportOutput(Settings& settings, QWidget* window)
    : QObject(window), m_settings(settings), m_window(window) {}

void ReportOutput::connectTo(const ReportActions& actions, const Make& make) {
    const auto on = [this, make](const QAction* action, const auto& put) {
        connect(action, &QAction::triggered, this, [make, put] {
            if (const auto report = make()) {
                put(*report);
            }
        });
    };
    using report::Report;
    on(actions.preview, [this](const Report& report) { preview(report); });
    on(actions.print, [this](const Report& report) { print(report); });
    for (const auto& [action, format] : {std::pair(actions.pdf, report::Format::pdf),
                                         std::pair(actions.html, report::Format::html),
                                         std::pair(actions.markdown, report::Format::markdown),
                                         std::pair(actions.odt, report::Format::odt)}) {
        on(action, [this, format = format](const Report& report) { exportReport(report, format); });
    }
}

void ReportOutput::preview(const report::Report& report) {
    QPrinter printer(QPrinter::HighResolution);
    setUp(printer, report);
    QPrintPreviewDialog dialog(&printer, m_window);
    if (printer.outputFormat() != QPrinter::NativeFormat) {
        hidePageSetup(dialog); // there is no printer to set up
    }
    dialog.setWindowTitle(tr("Print preview: %1").arg(report.title));
    setHelpTopic(dialog, QStringLiteral("reports#print"));
    std::optional<report::Pages> pages;
    QSizeF area = report::areaOf(printer);
    runAside([&] { pages.emplace(report, area); });
    connect(&dialog, &QPrintPreviewDialog::paintRequested, this, [&](QPrinter* target) {
        if (report::areaOf(*target) != area) {
            area = report::areaOf(*target);
            pages.emplace(report, area);
        }
        (void)report::printPages(*pages, *target);
    });
    dialog.resize(m_window->size() * 0.9);
    dialog.exec();
}

void ReportOutput::print(const report::Report& report) {
    QPrinter printer(QPrinter::HighResolution);
    setUp(printer, report);
    QPrintDialog dialog(&printer, m_window);
    dialog.setWindowTitle(tr("Print: %1").arg(report.title));
    setHelpTopic(dialog, QStringLiteral("reports#print"));
    if (dialog.exec() != QDialog::Accepted) {
        return;
    }
    bool printed = false;
    runAside([&] {
        const report::Pages pages(report, report::areaOf(printer));
        printed = report::printPages(pages, printer);
    });
    if (!printed) {
        showFailure(m_window, tr("Not printed"), tr("Output failed. Check printer and disk."));
    }
}

void ReportOutput::exportReport(const report::Report& report, report::Format format) {
    SaveRequest request{
        tr("Export: %1").arg(report.title),
        fileNameOf({report.title, report.subject}),
        {},
        {},
        {},
        [&](const KeepGoing& keepGoing) { return bytesOf(report, format, keepGoing); }};
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
