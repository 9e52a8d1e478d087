// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/report_kinds.h"
#include "ui/report/report_text.h"

#include <QObject>

#include <functional>
#include <optional>

class QPrinter;
class QWidget;

namespace sparkout {

class Settings;

/// The commands that print a report, show it before, or write it into a file.
class ReportCommands : public QObject {
    Q_OBJECT

public:
    /// What is to be reported: an outcome and the path of its project.
    struct Subject {
        OutcomePtr outcome;
        QString file;
    };

    ReportCommands(std::function<Subject()> subject, Settings& settings, QWidget* window);

    void preview(report::Kind kind);
    void print(report::Kind kind);
    void exportReport(report::Kind kind, report::Format format);

private:
    /// The report of now; nothing when there is no result, which is said.
    [[nodiscard]] std::optional<report::Report> reportOfNow(report::Kind kind);

    std::function<Subject()> m_subject;
    Settings& m_settings;
    QWidget* m_window;
};

} // namespace sparkout
