// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/identification/wheel_calibration.h"
#include "core/project/project.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;
class QPushButton;

namespace sparkout {

class NumberField;

/// Calibrates the wheel by measured parts: its factor of Ra, and its strengths by one reading at
/// which it just began to shed its grains.
class WheelPage : public QWidget {
    Q_OBJECT

public:
    explicit WheelPage(const Project& project, QWidget* parent = nullptr);

signals:
    void taken(const sparkout::Project& project); ///< the project with the found values

private:
    QWidget* buildRoughness();
    QWidget* buildStrengths();
    void showStrengths();

    const Project& m_project;
    std::optional<RoughnessCalibration> m_roughness;
    std::optional<StrengthsCalibration> m_strengths;
    QComboBox* m_reading;
    NumberField* m_value;
    QLabel* m_unit;
    NumberField* m_width;
    QLabel* m_found;
    QPushButton* m_take;
};

} // namespace sparkout
