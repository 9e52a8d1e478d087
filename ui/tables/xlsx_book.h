// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/sheet.h"

#include <QDateTime>

/// Workbooks as Excel, LibreOffice and others read them (Office Open XML).
namespace sparkout {

inline constexpr std::size_t xlsxRows = 1'048'576; ///< of a sheet, its head included
inline constexpr qsizetype xlsxNameLength = 31;    ///< of a sheet, in UTF-16 units
inline constexpr qsizetype xlsxTextLength = 32'767;

struct Book {
    QString title;
    QString author;
    QString program; ///< "Sparkout 0.1.0"
    QDateTime made;
    std::vector<Sheet> sheets; ///< at least one
};

/// Numbers are numbers and read back as the same double; texts are texts, whatever they begin with.
/// The names of the columns, and their units in a row of their own, stay in sight. Nothing when it
/// was given up, or when a sheet has too many rows: see sheetTooLong().
[[nodiscard]] QByteArray xlsxBytes(const Book& book, const KeepGoing& keepGoing = {});

/// The first sheet that has more rows than a workbook takes; null: there is none.
[[nodiscard]] const Sheet* sheetTooLong(const std::vector<Sheet>& sheets);

/// The names a workbook takes, each once: no [ ] : * ? / \, at most 31 characters, none empty.
[[nodiscard]] QStringList sheetNames(const QStringList& wanted);

} // namespace sparkout
