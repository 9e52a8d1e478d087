// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/stage_delegate.h"

#include "ui/inputs/spark_out_editor.h"
#include "ui/inputs/stage_model.h"
#include "ui/session/document.h"

namespace sparkout {

namespace {

constexpr int sparkOutWidth = 200;

const StageModel& modelOf(const QModelIndex& index) {
    return *static_cast<const StageModel*>(index.model());
}

} // namespace

QWidget* StageDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                                     const QModelIndex& index) const {
    const Field& field = modelOf(index).field(index);
    if (field.kind != Kind::sparkOut) {
        return ListDelegate::createEditor(parent, option, index);
    }
    auto* self = const_cast<StageDelegate*>(this);
    const bool traverse = document().project().operation == Operation::traverse;
    auto* editor = new SparkOutEditor(field, traverse, parent);
    connect(editor, &SparkOutEditor::edited, self,
            [self, editor] { emit self->commitData(editor); });
    return editor;
}

void StageDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    if (auto* sparkOut = qobject_cast<SparkOutEditor*>(editor)) {
        sparkOut->setValue(modelOf(index).stage(index).spark_out);
    } else {
        ListDelegate::setEditorData(editor, index);
    }
}

void StageDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                 const QModelIndex& index) const {
    auto* sparkOut = qobject_cast<SparkOutEditor*>(editor);
    if (!sparkOut) {
        ListDelegate::setModelData(editor, model, index);
    } else if (!sparkOut->refused()) {
        static_cast<StageModel*>(model)->setSparkOut(index, sparkOut->value());
    }
}

void StageDelegate::updateEditorGeometry(QWidget* editor, const QStyleOptionViewItem& option,
                                         const QModelIndex& index) const {
    if (!qobject_cast<SparkOutEditor*>(editor)) {
        QStyledItemDelegate::updateEditorGeometry(editor, option, index);
        return;
    }
    QRect place = option.rect; // over its neighbours: a cell is too narrow for it
    place.setLeft(qMax(0, place.right() - sparkOutWidth));
    editor->setGeometry(place);
}

} // namespace sparkout
