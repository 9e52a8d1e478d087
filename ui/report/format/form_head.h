// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>

#include <utility>
#include <vector>

namespace sparkout::report {

/// A cell of a form: the value is below its caption.
struct FormCell {
    enum class Count { none, pages, page };
    QString caption;
    QString value = {};
    int columns = 1, rows = 1; ///< number of columns and rows that it spans
    Count count = Count::none; ///< count of the document, replaces a value
    QImage picture = {};       ///< before the value
};

/// Cells in rows; a place covered by a spanning cell is left out.
struct FormGrid {
    std::vector<double> widths_mm; ///< widths of the columns
    std::vector<std::vector<FormCell>> rows;
};

/// The head of a form in an editable text; it begins a sheet.
struct FormHead {
    QString number;              ///< number of the form, above it
    QString symbol, name;        ///< at the foot of its sheets
    std::vector<FormGrid> grids; ///< one below the other
    FormGrid following;          ///< replaces them on further sheets
    /// The entries, as captions with values, for formats without grids. Empty if they appear above
    /// already.
    std::vector<std::pair<QString, QString>> entries;
};

} // namespace sparkout::report
