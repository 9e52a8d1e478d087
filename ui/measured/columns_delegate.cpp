// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/columns_delegate.h"

#include "ui/measured/columns_model.h"

#include <QComboBox>
#include <QKeyEvent>
#include <QSignalBlocker>

namespace sparkout {

QWidget* ColumnsDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                       const QModelIndex& index) const {
    auto* box = new QComboBox(parent);
    box->setObjectName(QStringLiteral("column-%1-%2").arg(index.row()).arg(index.column()));
    box->setAccessibleName(index.data(Qt::AccessibleTextRole).toString());
    auto* self = const_cast<ColumnsDelegate*>(this);
    connect(box, &QComboBox::currentIndexChanged, self,
            [self, box] { emit self->commitData(box); });
    return box;
}

void ColumnsDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    auto* box = static_cast<QComboBox*>(editor);
    const QSignalBlocker quiet(box);
    box->clear();
    for (const auto& [text, value] :
         static_cast<const ColumnsModel*>(index.model())->choices(index)) {
        box->addItem(text, value);
    }
    box->setCurrentIndex(box->findData(index.data(Qt::EditRole)));
    box->setEnabled(box->count() > 1);
}

void ColumnsDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                   const QModelIndex& index) const {
    model->setData(index, static_cast<QComboBox*>(editor)->currentData(), Qt::EditRole);
}

/// A box passes each choice on at once. At Return the delegate would do so later, when the table
/// may have been read again and the box deleted.
bool ColumnsDelegate::eventFilter(QObject* editor, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            return false;
        }
    }
    return QStyledItemDelegate::eventFilter(editor, event);
}

} // namespace sparkout
