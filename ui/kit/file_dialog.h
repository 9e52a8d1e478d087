// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QCoreApplication>
#include <QString>

class QFileDialog;
class QWidget;

namespace sparkout {

/// Asks for the path of a file: by the dialog of the desktop where it has one, else by Qt's own, in
/// the program's icons, type and language, with columns as wide as what stands in them.
class FileDialog {
    Q_DECLARE_TR_FUNCTIONS(FileDialog)
public:
    /// Of a file that is there; empty: none was chosen.
    [[nodiscard]] static QString openPath(QWidget* parent, const QString& title,
                                          const QString& folder, const QString& filter);
    /// Of a file to be written, which the user has allowed to be replaced; a name without an ending
    /// is given the suffix, if there is one.
    [[nodiscard]] static QString savePath(QWidget* parent, const QString& title,
                                          const QString& path, const QString& filter,
                                          const QString& suffix = {});

private:
    static QString chosen(QFileDialog& dialog);
    static void dress(QFileDialog& dialog);
};

} // namespace sparkout
