// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/window/dialogs/export_dialog.h"

#include <QObject>

class QWidget;

namespace sparkout {

class Settings;

/// The command that exports a result with its trace to a file.
class ExportCommands : public QObject {
    Q_OBJECT

public:
    /// `outcome` returns the one of the current inputs, `studies` the results of the views.
    ExportCommands(std::function<OutcomePtr()> outcome,
                   std::function<std::vector<StudyOffer>()> studies, Settings& settings,
                   QWidget* window);

    void exportResults();

private:
    std::function<OutcomePtr()> m_outcome;
    std::function<std::vector<StudyOffer>()> m_studies;
    Settings& m_settings;
    QWidget* m_window;
    ExportFormat m_format = ExportFormat::xlsx; ///< the last one chosen
};

} // namespace sparkout
