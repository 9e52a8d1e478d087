// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"

#include <QDialog>

#include <cstddef>

namespace sparkout {

class Document;

/// Calibrate from measurements: the process from measured cycles, the wheel from measured Ra and a
/// reading at the limit. What is taken is one edit.
class CalibrationDialog : public QDialog {
    Q_OBJECT

public:
    explicit CalibrationDialog(const Project& project, QWidget* parent = nullptr);

    [[nodiscard]] const Project& project() const { return m_taken; } ///< once accepted
    /// Asks, and edits the document; what was done in words, empty: nothing.
    static QString calibrate(Document& document, QWidget* window);

private:
    [[nodiscard]] bool isEmpty() const; ///< nothing is measured
    [[nodiscard]] QWidget* emptyPage();
    void take(const Project& calibrated);

    Project m_project;
    Project m_taken;
};

} // namespace sparkout
