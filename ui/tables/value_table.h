// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace sparkout {

/// The head of a row or a column.
struct ValueHead {
    QString text;         ///< in its place
    QString name;         ///< standing alone, as it is spoken and copied; empty: the text
    QString tip;          ///< plain text with indices as V_k
    const char* key = ""; ///< of the output that it is of

    [[nodiscard]] const QString& fullName() const { return name.isEmpty() ? text : name; }
};

struct ValueCell {
    QString text;
    QString remark; ///< why a cell is marked with an icon; empty: it is not
    QString tip;    ///< plain text with indices as V_k
};

/// A table as a value: the words and numbers of its heads and cells in the present language.
struct ValueTable {
    QString corner;  ///< names the heads of the rows
    QString remarks; ///< head of the column of remarks in a copy; empty: it has none
    std::vector<ValueHead> columns, rows;
    std::vector<std::vector<ValueCell>> cells; ///< row by row

    /// With a line of heads, cells separated by tabs.
    [[nodiscard]] QString asTsv() const;
};

} // namespace sparkout
