// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/packs/pack_plan.h"

#include <QDialog>

class QLabel;
class QPushButton;
class QTreeWidget;
class QTreeWidgetItem;

namespace sparkout {

/// The contents of a pack, the user's corresponding data, and the choice of what to apply.
class PackImportDialog : public QDialog {
    Q_OBJECT

public:
    PackImportDialog(Pack pack, Settings& settings, QWidget* parent);

    void accept() override; ///< applies it; stays open if something could not be saved

private:
    QWidget* buildHead();
    QWidget* buildLines();
    void addLine(std::size_t line);
    void showDifferences();
    void showChosen();
    [[nodiscard]] static QString stateText(PackPlan::State state);
    [[nodiscard]] static QString choiceText(PackPlan::Choice choice, PackPlan::State state);

    Settings& m_settings;
    PackPlan m_plan;
    QTreeWidget* m_lines;
    QTreeWidget* m_differences;
    QLabel* m_state;
    QPushButton* m_take = nullptr;
};

} // namespace sparkout
