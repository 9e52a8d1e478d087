// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

namespace sparkout {

/// What the program is, its version and the versions of what it is built on.
class AboutDialog : public QDialog {
    Q_OBJECT

public:
    explicit AboutDialog(QWidget* parent = nullptr);

    /// A line each: program, engine, libraries, compiler, system.
    [[nodiscard]] static QString versions();
};

} // namespace sparkout
