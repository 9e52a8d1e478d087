// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/project.h"
#include "core/study/wave_causes.h"

#include <QDialog>

class QLabel;
class QLineEdit;

namespace sparkout {

class CopyTable;
class NumberField;
class Settings;
class ValueModel;

/// What can have left the waves that were counted around a part: the causes that agree with the
/// count, and what each would leave at another work and another wheel speed.
class WavesDialog : public QDialog {
    Q_OBJECT

public:
    WavesDialog(const Project& project, Settings& settings, QWidget* parent);

    [[nodiscard]] const std::vector<WaveCause>& causes() const { return m_causes; }

private:
    void find();

    Project m_project;
    std::vector<WaveCause> m_causes;
    NumberField* m_count;
    QLineEdit* m_frequencies;
    ValueModel* m_model;
    CopyTable* m_table;
    QLabel* m_test;
};

} // namespace sparkout
