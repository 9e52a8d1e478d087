// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QMimeData>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

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
