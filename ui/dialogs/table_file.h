// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/table/csv_table.h"

#include <QString>

#include <array>

class QWidget;

namespace sparkout {

class Settings;

/// The file formats of a table.
enum class TableFormat { xlsx, csvRussian, csvEnglish };
inline constexpr std::array allTableFormats{TableFormat::xlsx, TableFormat::csvRussian,
                                            TableFormat::csvEnglish};

[[nodiscard]] QString tableFormatText(TableFormat format); ///< for a menu, with its mnemonic
[[nodiscard]] QString tableFormatHint(TableFormat format);
[[nodiscard]] QString tableFormatFilter(TableFormat format); ///< for the file dialog
[[nodiscard]] QString tableFormatSuffix(TableFormat format);
[[nodiscard]] CsvDialect dialectOf(TableFormat format); ///< for a CSV format

/// A table to be saved; its heading is its title, then the project.
struct NamedTable {
    QStringList heading;
    CsvTable table;
};

/// "Sparkout 0.1.0", for the properties of a document.
[[nodiscard]] QString programText();

/// Asks for a path and writes the table there; shows any failure. True once it is saved.
bool saveTable(QWidget* window, Settings* settings, NamedTable named, TableFormat format);

/// A text on a sheet with more rows than a workbook can have, and a workaround.
[[nodiscard]] QString tooLongText(const QString& sheet, std::size_t rows);

} // namespace sparkout
