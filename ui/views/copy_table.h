// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTableView>

#include <functional>

namespace sparkout {

/// A table to read on a page that scrolls as one: no grid, no scroll bar down its side, and as a
/// whole it goes to a spreadsheet with Ctrl+C or the context menu.
class CopyTable : public QTableView {
    Q_OBJECT
public:
    /// @param text the table as tab-separated text
    explicit CopyTable(std::function<QString()> text, QWidget* parent = nullptr);

    void copy() const;
    void retranslate(); ///< the tool tip; the owner names the table

signals:
    void resized();
    void rowChosen(int row);  ///< by a click, or Enter on the row
    void rowEntered(int row); ///< by a double click, or Enter on the row

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    std::function<QString()> m_text;
};

} // namespace sparkout
