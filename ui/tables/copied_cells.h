// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/pasted_cells.h"

#include <QMimeData>

namespace sparkout {

/// Cells for the clipboard: plain text with tabs, and an HTML table whose numbers are marked with
/// their values, so that a spreadsheet of any language reads them as numbers.
class CopiedCells : public QMimeData {
    Q_OBJECT
public:
    /// @param text rows of cells separated by tabs; a minus sign before a digit becomes a hyphen,
    ///   for spreadsheets
    explicit CopiedCells(QString text);

    static void toClipboard(const QString& text);

    [[nodiscard]] QStringList formats() const override;
    [[nodiscard]] bool hasFormat(const QString& type) const override;

protected:
    /// The HTML is made on request, since a long table is seldom pasted as such.
    [[nodiscard]] QVariant retrieveData(const QString& type, QMetaType as) const override;

private:
    QString m_text;
};

/// The cells as an HTML table.
[[nodiscard]] QString htmlTable(const PastedCells& cells);

} // namespace sparkout
