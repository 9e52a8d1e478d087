// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/dialogs/table_file.h"
#include "ui/table/value_table.h"

#include <QTableView>

#include <functional>

class QMenu;

namespace sparkout {

/// Shows such a table; its owner updates it for another result or language. A list can be sorted by
/// any column.
class ValueModel : public TableModel {
    Q_OBJECT
public:
    using TableModel::TableModel;

    void setTable(ValueTable table);
    void update(ValueTable table); ///< the same rows: keeps the selection
    void setGreyed(bool grey);     ///< for numbers of outdated inputs
    [[nodiscard]] const ValueTable& table() const { return m_table; }
    [[nodiscard]] CsvTable shown() const { return m_table.inOrder(m_order); } ///< as sorted
    [[nodiscard]] QString asTsv() const;                                      ///< for the clipboard
    /// The row of the table on a line, and the line of a row.
    [[nodiscard]] int rowAt(int line) const;
    [[nodiscard]] int lineOf(int row) const;

    void sort(int column, Qt::SortOrder order) override; ///< negative: unsorted
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

private:
    [[nodiscard]] int rowsShown() const override { return static_cast<int>(m_table.rows.size()); }
    [[nodiscard]] int columnsShown() const override {
        return static_cast<int>(m_table.columns.size());
    }
    [[nodiscard]] QVariant cell(int line, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;
    [[nodiscard]] QVariant side(int line, int role) const override;
    [[nodiscard]] QVariant headData(const ValueHead& head, int role, bool right) const;
    [[nodiscard]] const ValueHead& headOf(int line) const;
    [[nodiscard]] QString spoken(int line, int column) const;
    [[nodiscard]] QVariant inkOf(const ValueCell& cell) const;
    void arrange();

    ValueTable m_table;
    std::vector<std::size_t> m_order; ///< the rows, line by line
    int m_sorted = -1;
    Qt::SortOrder m_direction = Qt::AscendingOrder;
    bool m_grey = false;
};

/// A read-only table on a scrolling page, without grid or vertical scroll bar. Its selected rows
/// are copied with Ctrl+C, the whole with its heads with Ctrl+Shift+C or, where no row is selected,
/// with Ctrl+C, too; the context menu does both and saves the table as a file.
class CopyTable : public QTableView {
    Q_OBJECT
public:
    /// @param text the table as tab-separated text: a line of headings and one for each selectable
    ///   row; group headings are not selectable
    explicit CopyTable(std::function<QString()> text, QWidget* parent = nullptr);
    /// @param text the text of a complete copy [the model]
    explicit CopyTable(ValueModel& model, QWidget* parent = nullptr,
                       std::function<QString()> text = {});

    /// Sets what the context menu saves, under the table's accessible name and the project's title;
    /// not offered for an empty table.
    void setSaving(std::function<CsvTable()> table, std::function<QString()> project,
                   Settings* settings);
    /// Makes every row one line high without measuring them. Requires the model.
    void setUniformRows();
    /// A click on a heading sorts the rows of a list, a third one restores the order; the menu
    /// selects the columns, which are kept under the table's object name. Requires that name.
    void setArrangeable(Settings* settings);
    void copy() const;         ///< all of it, with headings
    void copySelected() const; ///< the selected rows; without a selection the whole table
    void retranslate();        ///< the tool tip; the owner names the table

signals:
    void resized();
    /// By a click, or Enter on the row; `row` is that of the unsorted table.
    void rowChosen(int row);
    void rowEntered(int row); ///< by a double click, or Enter on the row

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
    void hideColumns(); ///< hides the columns that the user has hidden
    void chooseColumn(const QString& key, bool shown);
    void openMenu(const QPoint& at);
    [[nodiscard]] int rowOf(const QModelIndex& index) const; ///< in the unsorted table
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
