// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/table/csv_table.h"

#include <QAbstractTableModel>
#include <QIcon>
#include <QString>

#include <optional>
#include <vector>

namespace sparkout {

/// A flat table for a view. A subclass gives the number of rows and columns and the contents of
/// cells and heads.
class TableModel : public QAbstractTableModel {
    Q_OBJECT
public:
    using QAbstractTableModel::QAbstractTableModel;

    virtual void retranslate(); ///< the texts of cells and heads have changed
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] QVariant data(const QModelIndex& index,
                                int role = Qt::DisplayRole) const override;
    [[nodiscard]] QVariant headerData(int section, Qt::Orientation orientation,
                                      int role = Qt::DisplayRole) const override;

protected:
    [[nodiscard]] virtual int rowsShown() const = 0;
    [[nodiscard]] virtual int columnsShown() const = 0;
    [[nodiscard]] virtual QVariant cell(int row, int column, int role) const = 0;
    [[nodiscard]] virtual QVariant head(int column, int role) const = 0;
    [[nodiscard]] virtual QVariant side(int /*row*/, int /*role*/) const { return {}; }

    void cellsChanged(); ///< the contents have changed, but not their number
    /// For Qt::TextAlignmentRole, vertically centred.
    [[nodiscard]] static QVariant aligned(bool right);
};

/// The head of a row or a column.
struct ValueHead {
    QString text = {};     ///< shown instead
    QString name = {};     ///< standalone name for speech and copies; empty: the text
    QString tip = {};      ///< plain text with indices like V_k
    const char* key = "";  ///< of the output that it is of, or a column's own
    bool isText = false;   ///< for a column: its cells are words, aligned left
    bool isStrong = false; ///< for a row: bold
    bool isPlain = false;  ///< for a column: not bold in a bold row
    bool isGroup = false;  ///< for a row: a heading of those below, neither selected nor copied

    [[nodiscard]] const QString& fullName() const { return name.isEmpty() ? text : name; }
};

struct ValueCell {
    QString text = {};
    QString remark = {}; ///< reason of the icon in a cell; empty: no icon
    QString tip = {};    ///< plain text with indices like V_k
    QString said = {};   ///< spoken instead of the text; empty: the text
    CsvCell value = {};  ///< for spreadsheets and sorting; empty: the text
    QString fault = {};  ///< why the cell is invalid; empty: valid
    QIcon icon = {};

    /// A number with all its digits behind the displayed text; a missing number is a dash, and an
    /// empty cell in a spreadsheet.
    template <class Text>
    [[nodiscard]] static ValueCell of(const std::optional<double>& value, Text text) {
        return value ? ValueCell{.text = text(*value), .value = *value}
                     : ValueCell{.text = QStringLiteral("–"), .value = QString()};
    }
};

/// A displayed number for a spreadsheet, which does not accept a leading "+".
[[nodiscard]] QString withoutPlus(const QString& shown);

/// A table as a value: the translated texts and the numbers of its heads and cells.
struct ValueTable {
    QString corner = {};  ///< heading of the row heads
    QString remarks = {}; ///< heading of the remarks in a copy; empty: no remarks
    std::vector<ValueHead> columns = {}, rows = {};
    std::vector<std::vector<ValueCell>> cells = {}; ///< row by row
    /// Copied instead of the cells, without the group headings. Empty: the cells.
    CsvTable sheet = {};
    /// Each row is an item, named by the first columns; row heads are not copied.
    bool isList = false;
    bool atTop = false; ///< aligns multi-line texts at the top

    void addRow(ValueHead head, std::vector<ValueCell> of);
    /// The table for a spreadsheet with the rows in this order, without the group headings.
    [[nodiscard]] CsvTable inOrder(const std::vector<std::size_t>& order) const;
    [[nodiscard]] CsvTable asTable() const; ///< in the given order

private:
    [[nodiscard]] CsvTable sheetInOrder(const std::vector<std::size_t>& order) const;
};

} // namespace sparkout
