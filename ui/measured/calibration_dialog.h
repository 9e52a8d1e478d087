// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QDialog>

#include <cstddef>

namespace sparkout {

class Document;

/// Calibration by measurements: the process by measured cycles, the wheel by measured Ra and a
/// reading at the limit. Applying the result is one edit.
class CalibrationDialog : public QDialog {
    Q_OBJECT

public:
    explicit CalibrationDialog(const Project& project, QWidget* parent = nullptr);

    [[nodiscard]] const Project& project() const { return m_taken; } ///< when accepted
    /// Shows the dialog and edits the document; returns a description, empty if nothing was done.
    static QString calibrate(Document& document, QWidget* window);

private:
    [[nodiscard]] bool isEmpty() const; ///< there are no measurements
    [[nodiscard]] QWidget* emptyPage();
    void take(const Project& calibrated);

    Project m_project;
    Project m_taken;
};

} // namespace sparkout
