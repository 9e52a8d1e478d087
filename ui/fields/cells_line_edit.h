// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/pasted_cells.h"

#include <QLineEdit>

#include <functional>
#include <utility>

namespace sparkout {

/// A line of text that hands several cells of a spreadsheet on when they are pasted into it.
class CellsLineEdit : public QLineEdit {
    Q_OBJECT

public:
    using QLineEdit::QLineEdit;

    /// Who takes cells; without one they are pasted as any text.
    void setTakesCells(std::function<void(const PastedCells&)> take) { m_take = std::move(take); }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    bool takeCells();

    std::function<void(const PastedCells&)> m_take;
};

} // namespace sparkout
