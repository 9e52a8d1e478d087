// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAction>
#include <QByteArray>
#include <QList>
#include <QMenu>

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

} // namespace sparkout
