// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"

#include <QWidget>

class QLabel;

namespace sparkout {

class CopyTable;
class ShopModel;

/// The verdict's section of the shop's numbers: title, table, and what lies outside its band. The
/// table is as high as its rows and scrolls sideways when the stages need more than the width.
class ShopSection : public QWidget {
    Q_OBJECT
public:
    explicit ShopSection(QWidget* parent = nullptr);

    void setOutcome(const OutcomePtr& outcome);
    void setGreyed(bool grey, const QPalette& palette); ///< of the labels
    void retranslate();

    [[nodiscard]] ShopModel* model() const { return m_model; }
    [[nodiscard]] CopyTable* table() const { return m_table; }

private:
    void buildTable();
    void showRemarks();
    void fit();

    QLabel* m_title;
    ShopModel* m_model;
    CopyTable* m_table;
    QWidget* m_remarksLine;
    QLabel* m_icon;
    QLabel* m_remarks;
    OutcomePtr m_outcome;
    bool m_fitting = false;
};

} // namespace sparkout
