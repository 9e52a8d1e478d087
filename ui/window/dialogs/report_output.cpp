// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/dialogs/report_output.h"

#include "ui/dialogs/file_questions.h"
#include "ui/dialogs/save_dialog.h"
#include "ui/kit/help_topic.h"
#include "ui/kit/keyboard.h"
#include "ui/kit/theme_icon.h"
#include "ui/report/format/pages.h"
#include "ui/session/background.h"

#include <QAction>
#include <QCoreApplication>
#include <QPrintDialog>
#include <QPrintPreviewDialog>
#include <QPrinter>

namespace sparkout {

namespace {

struct Words {
    Q_DECLARE_TR_FUNCTIONS(ReportActions)
};

} // namespace

ReportActions makeReportActions(const QByteArray& key, QWidget* owner) {
    auto* menu = new QMenu(owner);
    const auto make = [&](const char* command, const char16_t* icon) {
        QAction* action = menu->addAction(QString());
        action->setObjectName(QString::fromLatin1(QByteArray(command) + '-' + key));
        if (const QStringView drawing(icon); !drawing.isEmpty()) {
            action->setIcon(themeIcon(drawing));
        }
        return action;
    };
    QAction* const preview = make("preview", u"report");
    QAction* const print = make("print", u"print");
    menu->addSeparator();
    return {menu,
            preview,
            print,
            make("pdf", u"export"),
            make("html", u""),
            make("markdown", u""),
            make("odt", u"")};
}

void ReportActions::name(const QString& title) const {
    menu->setTitle(title);
    preview->setText(Words::tr("Print previe&w…"));
    print->setText(Words::tr("&Print…"));
    pdf->setText(Words::tr("Export P&DF…"));
    html->setText(Words::tr("Export &HTML…"));
    markdown->setText(Words::tr("Export &Markdown…"));
    odt->setText(Words::tr("Export &ODT…"));
    for (QAction* action : all()) {
        nameShortcut(*action);
    }
}

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
