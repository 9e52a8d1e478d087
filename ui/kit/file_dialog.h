// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

class QFileDialog;
class QWidget;

namespace sparkout {

/// Asks for the path of a file by the dialog of the desktop or, if it has none, by Qt's, with the
/// program's icons, font and language and with fitted columns.
class FileDialog {
    Q_DECLARE_TR_FUNCTIONS(FileDialog)
public:
    /// The path of an existing file; empty if none was chosen.
    [[nodiscard]] static QString openPath(QWidget* parent, const QString& title,
                                          const QString& folder, const QString& filter);
    /// The path of a file to be written, which the user has allowed to be replaced; adds the
    /// suffix, if any, to a name without one.
    [[nodiscard]] static QString savePath(QWidget* parent, const QString& title,
                                          const QString& path, const QString& filter,
                                          const QString& suffix = {});

private:
    static QString chosen(QFileDialog& dialog);
    static void dress(QFileDialog& dialog);
};

} // namespace sparkout
