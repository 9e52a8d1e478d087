// SPDX-License-Identifier: GPL-3.0-or-later
// What the commands of the menus do.
#include "ui/window/main_window.h"

#include "ui/inputs/inputs_panel.h"
#include "ui/kit/font_size.h"
#include "ui/session/background.h"
#include "ui/views/batch/batch_view.h"
#include "ui/window/actions.h"
#include "ui/window/export_commands.h"
#include "ui/window/file_commands.h"
#include "ui/window/recent_files_menu.h"
#include "ui/window/report_commands.h"
#include "ui/window/run_keeper.h"
#include "ui/window/studies_shown.h"

#include <QStatusBar>

namespace sparkout {

void MainWindow::connectActions() {
    m_actions->addRecentFiles(&m_files->recentFiles());
    const auto on = [this](QAction* action, auto slot) {
        connect(action, &QAction::triggered, this, slot);
    };
    for (QAction* action :
         {m_actions->newTraverse, m_actions->newPlunge, m_actions->open, m_actions->examples,
          m_actions->save, m_actions->saveAs, m_actions->earlierVersions, m_actions->recoverWork,
          m_actions->undo, m_actions->redo, m_actions->keepRun}) {
        on(action, [this] { m_inputs->endTyping(); }); // first
    }
    on(m_actions->newTraverse, [this] { m_files->startNew(Operation::traverse); });
    on(m_actions->newPlunge, [this] { m_files->startNew(Operation::plunge); });
    on(m_actions->open, [this] { m_files->open(); });
    on(m_actions->examples, [this] { m_files->openExample(); });
    on(m_actions->save, [this] { m_files->save(); });
    on(m_actions->saveAs, [this] { m_files->saveAs(); });
    on(m_actions->earlierVersions, [this] { m_files->openEarlierVersion(); });
    on(m_actions->recoverWork, [this] { m_files->recoverWork(); });
    on(m_actions->quit, [this] { close(); });
    on(m_actions->undo, [this] {
        if (!m_inputs->dropNewestRefusal()) {
            m_document.undo();
        }
    });
    on(m_actions->redo, [this] { m_document.redo(); });
    on(m_actions->keepRun, [this] { m_keeper->keep(); });
    on(m_actions->english, [this] { setLanguage(QStringLiteral("en")); });
    on(m_actions->russian, [this] { setLanguage(QStringLiteral("ru")); });
    for (std::size_t i = 0; i < allThemes.size(); ++i) {
        on(m_actions->themes[i], [this, i] { setTheme(allThemes[i]); });
    }
    for (std::size_t i = 0; i < fontSizes.size(); ++i) {
        on(m_actions->sizes[i], [this, i] { setFontSize(fontSizes[i]); });
    }
    on(m_actions->detach, [this] { toggleDetached(); });
    on(m_actions->nextPanel, [this] { movePanel(1); });
    on(m_actions->previousPanel, [this] { movePanel(-1); });
    on(m_actions->resetLayout, [this] { resetLayout(); });
    connectReports();
}

void MainWindow::connectReports() {
    const auto outcomeOfNow = [this] {
        OutcomePtr outcome = m_outcome;
        if (m_runs.running()) { // that one is of the inputs before
            runAside([&, project = m_document.project()] { outcome = evaluate(project, {}); });
        }
        return outcome;
    };
    auto* commands = new ReportCommands(
        [this, outcomeOfNow]() -> ReportCommands::Subject {
            return {outcomeOfNow(), m_document.filePath(), m_batch->batch(), &m_cursor};
        },
        m_settings, this);
    const auto studies = [this] { return studiesShown(views(), m_document.project()); };
    auto* exports = new ExportCommands(outcomeOfNow, studies, m_settings, this);
    const auto on = [this](QAction* action, const std::function<void()>& command) {
        connect(action, &QAction::triggered, this, [this, command] {
            m_inputs->endTyping(); // first
            command();
        });
    };
    on(m_actions->exportResults, [exports] { exports->exportResults(); });
    for (const ReportActions& report : m_actions->reports) {
        const report::Kind kind = report.kind;
        const auto writes = [commands, kind](report::Format format) {
            return [commands, kind, format] { commands->exportReport(kind, format); };
        };
        on(report.preview, [commands, kind] { commands->preview(kind); });
        on(report.print, [commands, kind] { commands->print(kind); });
        on(report.pdf, writes(report::Format::pdf));
        on(report.html, writes(report::Format::html));
        on(report.markdown, writes(report::Format::markdown));
    }
}

void MainWindow::setLanguage(const QString& code) {
    m_settings.setLanguage(code);
    m_language.apply(code);
    setLocale(QLocale());
    retranslate();
}

void MainWindow::setTheme(Theme theme) {
    m_settings.setTheme(themeCode(theme));
    applyTheme(theme);
    m_actions->showTheme(theme);
}

/// The panels keep their room, the views take what is left.
void MainWindow::setFontSize(int percent) {
    m_settings.setFontSize(percent);
    applyFontSize(percent);
    m_actions->showFontSize(percent);
    fitPanels();
}

} // namespace sparkout
