// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tables/pasted_cells.h"

#include <QLineEdit>

#include <functional>
#include <utility>

namespace sparkout {

/// A text field that passes on several cells of a spreadsheet when they are pasted.
class CellsLineEdit : public QLineEdit {
    Q_OBJECT

public:
    using QLineEdit::QLineEdit;

    /// Sets the receiver of cells; without one they are pasted as text.
    void setTakesCells(std::function<void(const PastedCells&)> take) { m_take = std::move(take); }

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    bool takeCells();

    std::function<void(const PastedCells&)> m_take;
};

} // namespace sparkout
