// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"

#include <QWidget>

class QLabel;

namespace sparkout {

class NarrowTable;
class ValueModel;

/// The verdict's section on the form of each zone; hidden where a zone is one section.
class FormSection : public QWidget {
    Q_OBJECT
public:
    explicit FormSection(QWidget* parent = nullptr);

    void setOutcome(const OutcomePtr& outcome);
    void setGreyed(bool grey, const QPalette& palette); ///< of the labels
    void retranslate();

    [[nodiscard]] ValueModel* model() const { return m_model; }
    [[nodiscard]] NarrowTable* table() const { return m_table; }

private:
    void showTitle();
    void showTable();

    OutcomePtr m_outcome;
    QLabel* m_title;
    ValueModel* m_model;
    NarrowTable* m_table;
};

} // namespace sparkout
