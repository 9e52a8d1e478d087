// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/reports/export_commands.h"

#include "ui/dialogs/save_dialog.h"
#include "ui/text/example_texts.h"
#include "ui/window/dialogs/export_dialog.h"

#include <QMessageBox>

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
                           "messages say what is wrong with them."),
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

} // namespace sparkout
