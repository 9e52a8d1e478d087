// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/measured/data_delegate.h"

#include "ui/views/measured/data_model.h"

#include <QComboBox>
#include <QLineEdit>

namespace sparkout {

QWidget* DataDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                    const QModelIndex& index) const {
    const auto choices = static_cast<const DataModel*>(index.model())->choices(index);
    const QString name = index.data(Qt::AccessibleTextRole).toString();
    if (choices.empty()) {
        auto* line = new QLineEdit(parent);
        line->setFrame(false);
        line->setAccessibleName(name);
        return line;
    }
    auto* box = new QComboBox(parent);
    for (const auto& [text, value] : choices) {
        box->addItem(text, value);
    }
    box->setAccessibleName(name);
    auto* self = const_cast<DataDelegate*>(this);
    connect(box, &QComboBox::activated, self, [self, box] {
        emit self->commitData(box);
        emit self->closeEditor(box);
    });
    return box;
}

void DataDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    if (auto* box = qobject_cast<QComboBox*>(editor)) {
        box->setCurrentIndex(box->findData(index.data(Qt::EditRole)));
    } else if (auto* line = qobject_cast<QLineEdit*>(editor)) {
        line->setText(index.data(Qt::EditRole).toString());
    }
}

void DataDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                const QModelIndex& index) const {
    if (const auto* box = qobject_cast<QComboBox*>(editor)) {
        model->setData(index, box->currentData(), Qt::EditRole);
    } else if (const auto* line = qobject_cast<QLineEdit*>(editor)) {
        model->setData(index, line->text(), Qt::EditRole);
    }
}

} // namespace sparkout
