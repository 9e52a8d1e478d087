// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QString>

#include <utility>
#include <vector>

namespace sparkout::report {

/// A cell of a form: what is entered stands below its caption.
struct FormCell {
    enum class Count { none, pages, page };
    QString caption;
    QString value = {};
    int columns = 1, rows = 1; ///< that it takes
    Count count = Count::none; ///< of the document, in place of a value
    QImage picture = {};       ///< before the value
};

/// Cells in rows; a place that a cell above or beside takes is left out.
struct FormGrid {
    std::vector<double> widths_mm; ///< of the columns
    std::vector<std::vector<FormCell>> rows;
};

/// The head of a form for a text that is edited; it begins a sheet.
struct FormHead {
    QString number;              ///< of the form, above it
    QString symbol, name;        ///< at the foot of its sheets
    std::vector<FormGrid> grids; ///< one below the other
    FormGrid following;          ///< in their place on further sheets
    /// What is entered, for formats without grids: captions with values. Empty where it stands
    /// above already.
    std::vector<std::pair<QString, QString>> entries;
};

} // namespace sparkout::report
