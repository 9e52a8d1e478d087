// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QWidget>

namespace sparkout {

class NumberField;
class StillComboBox;

/// Chooses what the last stage does: feed, spark out a number of times, or until size.
class SparkOutEditor : public QWidget {
    Q_OBJECT

public:
    SparkOutEditor(const Field& field, bool traverse, QWidget* parent);

    [[nodiscard]] SparkOut value() const;
    void setValue(const SparkOut& value);
    [[nodiscard]] bool refused() const;

signals:
    void edited();

private:
    void showCount();

    StillComboBox* m_mode;
    NumberField* m_count;
};

} // namespace sparkout
