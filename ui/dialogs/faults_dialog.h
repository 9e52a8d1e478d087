// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <QDialog>

namespace sparkout {

/// Why a file was refused: every fault with its place and its sentence.
class FaultsDialog : public QDialog {
    Q_OBJECT

public:
    FaultsDialog(const QString& file, const Issues& issues, QWidget* parent = nullptr);

    /// One line a fault, as the list and the clipboard have them.
    [[nodiscard]] static QStringList lines(const Issues& issues);
};

} // namespace sparkout
