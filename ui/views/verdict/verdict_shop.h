// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"

#include <QWidget>

class QLabel;

namespace sparkout {

class NarrowTable;
class ValueModel;

/// The verdict's section on the shop's figures: title, table, and values outside their band.
class ShopSection : public QWidget {
    Q_OBJECT
public:
    explicit ShopSection(QWidget* parent = nullptr);

    void setOutcome(const OutcomePtr& outcome);
    void setGreyed(bool grey, const QPalette& palette); ///< of the labels
    void retranslate();

    [[nodiscard]] ValueModel* model() const { return m_model; }
    [[nodiscard]] NarrowTable* table() const { return m_table; }

private:
    void showTable();

    QLabel* m_title;
    ValueModel* m_model;
    NarrowTable* m_table;
    QWidget* m_remarksLine;
    QLabel* m_icon;
    QLabel* m_remarks;
    OutcomePtr m_outcome;
};

} // namespace sparkout
