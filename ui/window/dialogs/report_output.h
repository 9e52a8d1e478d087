// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"
#include "ui/report/format/report_text.h"

#include <QAction>
#include <QByteArray>
#include <QList>
#include <QMenu>
#include <QObject>

#include <functional>
#include <optional>

class QWidget;

namespace sparkout {

/// The commands of one report, in a submenu.
struct ReportActions {
    QMenu* menu;
    QAction *preview, *print, *pdf, *html, *markdown, *odt;

    [[nodiscard]] QList<QAction*> all() const { return {preview, print, pdf, html, markdown, odt}; }
    void name(const QString& title) const; ///< translated
};

/// Each object name is the command and the key of the report: preview-card. `owner` owns the menu.
[[nodiscard]] ReportActions makeReportActions(const QByteArray& key, QWidget* owner);

class Settings;

/// Prints, previews and saves reports.
class ReportOutput : public QObject {
    Q_OBJECT

public:
    /// Empty if there is no report, of which the user is informed.
    using Make = std::function<std::optional<report::Report>()>;

    ReportOutput(Settings& settings, QWidget* window);

    /// Each command makes the report and outputs it.
    void connectTo(const ReportActions& actions, const Make& make);

private:
    void preview(const report::Report& report);
    void print(const report::Report& report);
    void exportReport(const report::Report& report, report::Format format);

    Settings& m_settings;
    QWidget* m_window;
};

} // namespace sparkout
