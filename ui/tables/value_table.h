// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/csv_table.h"

#include <QIcon>
#include <QString>

#include <optional>
#include <vector>

namespace sparkout {

/// The head of a row or a column.
struct ValueHead {
    QString text = {};     ///< in its place
    QString name = {};     ///< standing alone, as it is spoken and copied; empty: the text
    QString tip = {};      ///< plain text with indices as V_k
    const char* key = "";  ///< of the output that it is of, or a column's own
    bool isText = false;   ///< of a column: its cells are words, which stand at the left
    bool isStrong = false; ///< of a row: in bold type
    bool isGroup = false;  ///< of a row: it names those below, and is neither chosen nor copied

    [[nodiscard]] const QString& fullName() const { return name.isEmpty() ? text : name; }
};

struct ValueCell {
    QString text = {};
    QString remark = {}; ///< why a cell is marked with an icon; empty: it is not
    QString tip = {};    ///< plain text with indices as V_k
    QString said = {};   ///< aloud in place of its text; empty: the text
    CsvCell value = {};  ///< for a spreadsheet and to sort by; nothing: the text
    QString fault = {};  ///< why it cannot be read; empty: it can
    QIcon icon = {};

    /// A number with all its digits behind the text that shows it; where there is none, a dash
    /// that is an empty cell in a spreadsheet.
    template <class Text>
    [[nodiscard]] static ValueCell of(const std::optional<double>& value, Text text) {
        return value ? ValueCell{.text = text(*value), .value = *value}
                     : ValueCell{.text = QStringLiteral("–"), .value = QString()};
    }
};

/// A number as it is shown, for a spreadsheet, which takes no text for one that begins with "+".
[[nodiscard]] QString withoutPlus(const QString& shown);

/// A table as a value: the words and numbers of its heads and cells in the present language.
struct ValueTable {
    QString corner = {};  ///< names the heads of the rows
    QString remarks = {}; ///< head of the column of remarks in a copy; empty: it has none
    std::vector<ValueHead> columns = {}, rows = {};
    std::vector<std::vector<ValueCell>> cells = {}; ///< row by row
    /// What is copied in place of the cells, without the names of groups. Empty: the cells.
    CsvTable sheet = {};
    /// A row is an item: the first columns name it, and the heads of the rows are not copied.
    bool isList = false;
    bool atTop = false; ///< texts of several lines stand beside the first one

    void addRow(ValueHead head, std::vector<ValueCell> of);
    /// For a spreadsheet, the rows in this order; the names of groups are left out.
    [[nodiscard]] CsvTable inOrder(const std::vector<std::size_t>& order) const;
    [[nodiscard]] CsvTable asTable() const; ///< in the order they are in

private:
    [[nodiscard]] CsvTable sheetInOrder(const std::vector<std::size_t>& order) const;
};

} // namespace sparkout
