// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

class QMimeData;

namespace sparkout {

/// Rows of cells in the clipboard, as spreadsheets and text files write them.
struct PastedCells {
    std::vector<QStringList> rows;

    /// Cells separated by tabs; without any by semicolons, without both by commas that cannot be
    /// decimal ones. A cell may be quoted. Empty rows at the end are left out.
    [[nodiscard]] static PastedCells of(const QString& text);
    /// The contents of the clipboard: its plain text or, if it has none, the first table of its
    /// HTML.
    [[nodiscard]] static PastedCells of(const QMimeData* data);
    /// With tabs, and with quotes where necessary.
    [[nodiscard]] QString text() const;

    [[nodiscard]] bool empty() const { return rows.empty(); }
    [[nodiscard]] bool single() const { return rows.size() == 1 && rows.front().size() == 1; }
    [[nodiscard]] std::vector<QString> inOrder() const; ///< row by row
};

/// The number of a cell, as typed, also with a no-break, narrow, thin or figure space between
/// groups of three digits. Groups separated by a point or a comma could be decimals and are
/// refused.
[[nodiscard]] std::optional<double> pastedNumber(const QString& cell);

} // namespace sparkout
