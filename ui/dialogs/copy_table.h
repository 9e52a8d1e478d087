// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/table_file.h"

#include <QTableView>

#include <functional>

class QMenu;

namespace sparkout {

class ValueModel;

/// A table to read on a page that scrolls as one: no grid, no scroll bar down its side. Its
/// selected rows go to a spreadsheet with Ctrl+C, the whole with its heads with Ctrl+Shift+C or,
/// where no row is selected, with Ctrl+C, too; the context menu does both and saves the table as a
/// file.
class CopyTable : public QTableView {
    Q_OBJECT
public:
    /// @param text the table as tab-separated text: a line of heads and one for each row that can
    /// be selected, as the name of a group cannot
    explicit CopyTable(std::function<QString()> text, QWidget* parent = nullptr);
    /// @param text the whole as it is copied [the model]
    explicit CopyTable(ValueModel& model, QWidget* parent = nullptr,
                       std::function<QString()> text = {});

    /// What the context menu saves under the table's accessible name and the project's title; an
    /// empty table is not offered.
    void setSaving(std::function<CsvTable()> table, std::function<QString()> project,
                   Settings* settings);
    /// Every row is one line high, as the first one: none is measured, however many there are.
    /// Once the model is set.
    void setUniformRows();
    /// A click on a head sorts the rows of a list, a third one puts them back; the menu chooses the
    /// columns, which are remembered by the table's object name. Once the table has its name.
    void setArrangeable(Settings* settings);
    void copy() const;         ///< all of it, with its heads
    void copySelected() const; ///< the selected rows; where none is, all of it
    void retranslate();        ///< the tool tip; the owner names the table

signals:
    void resized();
    /// By a click, or Enter on the row; however the table is sorted, the row that it is in it.
    void rowChosen(int row);
    void rowEntered(int row); ///< the same by a double click, or Enter on the row

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void initViewItemOption(QStyleOptionViewItem* option) const override;

private:
    static void measure(QHeaderView& header);
    void fitUniformRows();
    void copySelectedRows() const;
    void addSaving(QMenu& menu);
    void addColumns(QMenu& menu);
    void hideColumns(); ///< those that were chosen to be
    void chooseColumn(const QString& key, bool shown);
    void openMenu(const QPoint& at);
    [[nodiscard]] int rowOf(const QModelIndex& index) const; ///< of the table as it is
    void save(TableFormat format);

    std::function<QString()> m_text;
    std::function<CsvTable()> m_table;
    std::function<QString()> m_project;
    Settings* m_settings = nullptr;
    ValueModel* m_values = nullptr;
    QStringList m_hidden; ///< keys of columns
    bool m_uniform = false, m_arrangeable = false;
};

} // namespace sparkout
