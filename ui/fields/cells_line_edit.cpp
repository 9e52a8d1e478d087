// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/cells_line_edit.h"

#include <QAction>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QMimeData>

namespace sparkout {

/// A line of text is not a block of cells, whatever separates its words.
bool CellsLineEdit::takeCells() {
    const QMimeData* const copied = QGuiApplication::clipboard()->mimeData();
    const QString text = copied ? copied->text().trimmed() : QString();
    const bool block = text.isEmpty() || text.contains(u'\n') || text.contains(u'\t');
    const PastedCells cells = PastedCells::of(copied);
    if (!m_take || isReadOnly() || !block || cells.empty() || cells.single()) {
        return false;
    }
    m_take(cells);
    return true;
}

void CellsLineEdit::keyPressEvent(QKeyEvent* event) {
    if (event->matches(QKeySequence::Paste) && takeCells()) {
        event->accept();
        return;
    }
    QLineEdit::keyPressEvent(event);
}

void CellsLineEdit::contextMenuEvent(QContextMenuEvent* event) {
    QMenu* const menu = createStandardContextMenu();
    menu->setAttribute(Qt::WA_DeleteOnClose);
    if (auto* paste = menu->findChild<QAction*>(QStringLiteral("edit-paste")); paste && m_take) {
        paste->disconnect(SIGNAL(triggered()));
        paste->disconnect(SIGNAL(triggered(bool)));
        connect(paste, &QAction::triggered, this, [this] {
            if (!takeCells()) {
                QLineEdit::paste();
            }
        });
    }
    menu->popup(event->globalPos());
    event->accept();
}

} // namespace sparkout
