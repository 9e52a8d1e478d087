// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

class QMimeData;

namespace sparkout {

/// Rows of cells on their way through the clipboard: as spreadsheets and text files write them.
struct PastedCells {
    std::vector<QStringList> rows;

    /// Tabs between the cells; without one semicolons, without both commas where they cannot be
    /// decimal ones. A cell may stand in quotes. Empty rows at the end are left out.
    [[nodiscard]] static PastedCells of(const QString& text);
    /// What the clipboard holds: its plain text or, where it has none, the first table of its HTML.
    [[nodiscard]] static PastedCells of(const QMimeData* data);
    /// With tabs, a cell in quotes where it must be.
    [[nodiscard]] QString text() const;

    [[nodiscard]] bool empty() const { return rows.empty(); }
    [[nodiscard]] bool single() const { return rows.size() == 1 && rows.front().size() == 1; }
    [[nodiscard]] std::vector<QString> inOrder() const; ///< row by row
};

/// The number of a cell: as it is typed, and with a no-break, narrow, thin or figure space between
/// groups of three digits. Groups parted by a point or a comma could be decimals: no number.
[[nodiscard]] std::optional<double> pastedNumber(const QString& cell);

} // namespace sparkout
