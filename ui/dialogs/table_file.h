// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/csv_table.h"

#include <QString>

#include <array>

class QWidget;

namespace sparkout {

class Settings;

/// As what a table is saved.
enum class TableFormat { xlsx, csvRussian, csvEnglish };
inline constexpr std::array allTableFormats{TableFormat::xlsx, TableFormat::csvRussian,
                                            TableFormat::csvEnglish};

[[nodiscard]] QString tableFormatText(TableFormat format); ///< for a menu, with its mnemonic
[[nodiscard]] QString tableFormatHint(TableFormat format);
[[nodiscard]] QString tableFormatFilter(TableFormat format); ///< of the file dialog
[[nodiscard]] QString tableFormatSuffix(TableFormat format);
[[nodiscard]] CsvDialect dialectOf(TableFormat format); ///< of a CSV one

/// A table to be saved; its heading is what it shows, then the project.
struct NamedTable {
    QStringList heading;
    CsvTable table;
};

/// "Sparkout 0.1.0", for the properties of a document.
[[nodiscard]] QString programText();

/// Asks for a place and writes the table there; what stands in the way is said. True once it is
/// saved.
bool saveTable(QWidget* window, Settings* settings, NamedTable named, TableFormat format);

/// That a sheet has more rows than a workbook takes, and what to do.
[[nodiscard]] QString tooLongText(const QString& sheet, std::size_t rows);

} // namespace sparkout
