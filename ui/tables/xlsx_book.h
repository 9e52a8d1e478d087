// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/sheet.h"

/// The tables of the window as workbooks, written by core/workbook.
namespace sparkout {

inline constexpr std::size_t xlsxRows = xlsx::mostRows;
inline constexpr auto xlsxNameLength = static_cast<qsizetype>(xlsx::mostNameLength);
inline constexpr auto xlsxTextLength = static_cast<qsizetype>(xlsx::mostTextLength);

struct Book {
    QString title;
    QString author;
    QString program;           ///< "Sparkout 0.1.0"
    std::vector<Sheet> sheets; ///< at least one
};

/// See xlsx::bytesOf(); the sheets get valid names. Empty after a cancellation, or if a sheet has
/// too many rows: see sheetTooLong().
[[nodiscard]] QByteArray xlsxBytes(const Book& book, const KeepGoing& keepGoing = {});

/// The first sheet with more rows than a workbook can have; null if there is none.
[[nodiscard]] const Sheet* sheetTooLong(const std::vector<Sheet>& sheets);

/// Valid and unique names of sheets: no [ ] : * ? / \, at most 31 characters, none empty.
[[nodiscard]] QStringList sheetNames(const QStringList& wanted);

} // namespace sparkout
