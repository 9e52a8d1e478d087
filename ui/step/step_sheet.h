// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/cycle_cursor.h"

#include <QWidget>

#include <optional>

class QComboBox;
class QLabel;

namespace sparkout {

class FormulaView;

/// The formulas of the current step of the cycle, with their numbers: the balance of the last
/// ground radius, in each zone or section under the wheel at that moment.
class StepSheet : public QWidget {
    Q_OBJECT
public:
    explicit StepSheet(CycleCursor& cycle, QWidget* parent = nullptr);
    void retranslate();
    [[nodiscard]] QSize sizeHint() const override { return {327, 380}; }

protected:
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void follow(); ///< only while it is visible
    void fillZones();
    void showSheet();

    CycleCursor& m_cycle;
    QComboBox* m_zone;
    QLabel* m_place;
    FormulaView* m_sheet;
    std::optional<std::size_t> m_wanted; ///< zone or section the user chose
};

} // namespace sparkout
