// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/dressing_interval.h"

#include <QDialog>

class QComboBox;
class QLabel;

namespace sparkout {

/// The parts between two dressings of a set-up's wheel, for the nominal part or for the batches of
/// its surfaces.
class DressingDialog : public QDialog {
    Q_OBJECT

public:
    DressingDialog(Setup setup, QWidget* parent);

    void find(); ///< runs the parts, with progress and a way to stop
    /// Whether the dialog was closed to edit the wear.
    [[nodiscard]] bool wantsWear() const { return m_wantsWear; }
    [[nodiscard]] const DressingInterval& interval() const { return m_interval; }

private:
    void showResult();

    Setup m_setup;
    DressingInterval m_interval;
    QComboBox* m_cases;
    QLabel* m_result;
    bool m_wantsWear = false;
};

} // namespace sparkout
