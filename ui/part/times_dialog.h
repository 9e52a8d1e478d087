// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup.h"
#include "core/setup/wheel_wear.h"

#include <QDialog>

#include <optional>

class QLabel;
class QPushButton;

namespace sparkout {

/// The standard times of the set-up and how the wheel wears from surface to surface, with what
/// they come to.
class TimesDialog : public QDialog {
    Q_OBJECT

public:
    /// `cycles_min` is the time of all cycles together; empty: not all of them end at size.
    TimesDialog(const SetupTimes& times, const WheelWear& wear, std::size_t surfaces,
                std::optional<double> cycles_min, QWidget* parent = nullptr);

    [[nodiscard]] const SetupTimes& times() const { return m_times; }
    [[nodiscard]] const WheelWear& wear() const { return m_wear; }

private:
    void follow();

    SetupTimes m_times;
    WheelWear m_wear;
    std::size_t m_surfaces;
    std::optional<double> m_cycles_min;
    QLabel* m_result;
    QPushButton* m_apply = nullptr;
};

} // namespace sparkout
