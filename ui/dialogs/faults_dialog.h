// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <QDialog>

namespace sparkout {

/// The faults of a refused or opened file: every fault with its place in words, its path in the
/// file and its sentence.
class FaultsDialog : public QDialog {
    Q_OBJECT

public:
    enum class File { refused, opened };

    FaultsDialog(const QString& file, const Issues& issues, QWidget* parent = nullptr,
                 File state = File::refused);

    /// One line for each fault, for the list and the clipboard.
    [[nodiscard]] static QStringList lines(const Issues& issues);
};

} // namespace sparkout
