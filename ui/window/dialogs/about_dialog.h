// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace sparkout {

/// The program, its version, and the versions of its libraries.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(QWidget* parent = nullptr);

    /// A line each: program, engine, libraries, compiler, system.
    [[nodiscard]] static QString versions();
};

} // namespace sparkout
