// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/report_text.h"
#include "ui/session/outcome.h"

#include <QObject>

#include <functional>
#include <optional>

class QPrinter;
class QWidget;

namespace sparkout {

class Settings;

/// The commands that print the cycle card, show it before, or write it into a file.
class ReportCommands : public QObject {
    Q_OBJECT

public:
    /// What is to be reported: an outcome and the path of its project.
    struct Subject {
        OutcomePtr outcome;
        QString file;
    };

    ReportCommands(std::function<Subject()> subject, Settings& settings, QWidget* window);

    void preview();
    void print();
    void exportReport(report::Format format);

private:
    /// The card of now; nothing when there is no result, which is said.
    [[nodiscard]] std::optional<report::Report> card();

    std::function<Subject()> m_subject;
    Settings& m_settings;
    QWidget* m_window;
};

} // namespace sparkout
