// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

class QTableView;

namespace sparkout {

/// What is selected in a table, as it is shown: lines of cells separated by tabs, without hidden
/// rows and columns; with nothing or everything selected the whole table under its headers.
[[nodiscard]] QString selectionAsTsv(const QTableView& table);

/// Gives a table Ctrl+C and a context menu that copy it for a spreadsheet.
void makeCopyable(QTableView& table);

} // namespace sparkout
