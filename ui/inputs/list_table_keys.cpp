// SPDX-License-Identifier: GPL-3.0-or-later
// What a table of the inputs does by keys and by its menu.
#include "ui/inputs/list_model.h"
#include "ui/inputs/list_table.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QMenu>
#include <QTableView>
#include <QToolButton>

namespace sparkout {

bool ListTable::takeKey(const QKeyEvent& key) {
    const bool control = key.modifiers() & Qt::ControlModifier;
    if (key.matches(QKeySequence::Copy)) {
        copyTable();
    } else if (key.key() == Qt::Key_Insert && !control) {
        addRow();
    } else if (key.key() == Qt::Key_Delete) {
        removeRow();
    } else if (control && (key.key() == Qt::Key_Up || key.key() == Qt::Key_Down)) {
        moveRow(key.key() == Qt::Key_Up ? -1 : 1);
    } else {
        return false;
    }
    return true;
}

void ListTable::copyTable() const {
    QGuiApplication::clipboard()->setText(m_model->tableText());
}

void ListTable::showMenu(const QPoint& at) {
    auto* menu = new QMenu(m_view);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    for (QToolButton* button : {m_add, m_remove, m_up, m_down}) {
        QAction* action = menu->addAction(button->icon(), button->accessibleName());
        action->setEnabled(button->isEnabled());
        connect(action, &QAction::triggered, button, &QToolButton::click);
    }
    menu->addSeparator();
    connect(menu->addAction(tr("&Copy the table")), &QAction::triggered, this,
            &ListTable::copyTable);
    menu->popup(at);
}

bool ListTable::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_view && event->type() == QEvent::Resize) {
        const auto* resize = static_cast<const QResizeEvent*>(event);
        if (resize->size().width() != resize->oldSize().width()) {
            fitHeight();
        }
    }
    if (watched == m_view && event->type() == QEvent::ShortcutOverride) {
        // Copying is the table's while it has the focus.
        event->setAccepted(static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy));
        return event->isAccepted();
    }
    if (watched == m_view && event->type() == QEvent::KeyPress
        && takeKey(*static_cast<QKeyEvent*>(event))) {
        return true;
    }
    const bool ofTheTable = watched == m_view || watched == m_view->viewport();
    if (ofTheTable && event->type() == QEvent::ContextMenu) {
        showMenu(static_cast<QContextMenuEvent*>(event)->globalPos());
        return true;
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace sparkout
