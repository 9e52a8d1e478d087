// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <QDialog>

namespace sparkout {

/// Why a file was refused, or what is wrong in one that was opened: every fault with its place in
/// words, its path in the file and its sentence.
class FaultsDialog : public QDialog {
    Q_OBJECT

public:
    enum class File { refused, opened };

    FaultsDialog(const QString& file, const Issues& issues, QWidget* parent = nullptr,
                 File state = File::refused);

    /// One line a fault, as the list and the clipboard have them.
    [[nodiscard]] static QStringList lines(const Issues& issues);
};

} // namespace sparkout
