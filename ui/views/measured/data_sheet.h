// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/measured/data_model.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace sparkout {

class CopyTable;
class Settings;

/// One list of the measured data: a table with buttons to add and remove rows.
class DataSheet : public QWidget {
    Q_OBJECT
public:
    DataSheet(DataModel::List list, Document& document, Settings* settings, QWidget* parent);

    [[nodiscard]] CopyTable* table() const { return m_table; }
    void retranslate();

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void fitRows(); ///< adapts to the font size
    void addRow();
    void removeRows();
    void showButtons();

    DataModel::List m_list;
    DataModel* m_model;
    CopyTable* m_table;
    QLabel* m_note;
    QPushButton *m_add, *m_remove;
};

} // namespace sparkout
