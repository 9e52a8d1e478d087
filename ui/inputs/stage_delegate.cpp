// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/stage_delegate.h"

#include "ui/inputs/number_field.h"
#include "ui/inputs/spark_out_editor.h"
#include "ui/inputs/stage_model.h"
#include "ui/session/document.h"

#include <QKeyEvent>

namespace sparkout {

namespace {

constexpr const char* startedProperty = "sparkoutStarted";
constexpr const char* originalProperty = "sparkoutOriginal"; ///< invalid when not given
constexpr int sparkOutWidth = 200;

const StageModel& modelOf(const QModelIndex& index) {
    return *static_cast<const StageModel*>(index.model());
}

} // namespace

StageDelegate::StageDelegate(Document& document, QObject* parent)
    : QStyledItemDelegate(parent), m_document(document) {}

QWidget* StageDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                     const QModelIndex& index) const {
    auto* self = const_cast<StageDelegate*>(this);
    const Field& field = modelOf(index).field(index);
    if (field.kind == Kind::sparkOut) {
        const bool traverse = m_document.project().operation == Operation::traverse;
        auto* editor = new SparkOutEditor(field, traverse, parent);
        connect(editor, &SparkOutEditor::edited, self,
                [self, editor] { emit self->commitData(editor); });
        return editor;
    }
    NumberSpec spec = NumberSpec::of(field);
    spec.optional = false; // a column that is shown is needed
    auto* editor = new NumberField(spec, parent);
    editor->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    editor->setAccessibleName(index.data(Qt::AccessibleTextRole).toString());
    connect(editor, &NumberField::valueEdited, self,
            [self, editor] { emit self->commitData(editor); });
    return editor;
}

void StageDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    const StageModel& model = modelOf(index);
    if (auto* sparkOut = qobject_cast<SparkOutEditor*>(editor)) {
        sparkOut->setValue(model.stage(index).spark_out);
        return;
    }
    auto* field = static_cast<NumberField*>(editor);
    const auto value = model.number(index);
    if (field->property(startedProperty).toBool()) {
        field->setValue(value);
        return;
    }
    field->setProperty(startedProperty, true);
    field->setProperty(originalProperty, value ? QVariant(*value) : QVariant());
    field->reset(value);
    if (const QString refused = model.refusedText(index); !refused.isNull()) {
        field->setShownText(refused);
    }
    field->selectAll();
}

void StageDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                 const QModelIndex& index) const {
    auto* stages = static_cast<StageModel*>(model);
    if (auto* sparkOut = qobject_cast<SparkOutEditor*>(editor)) {
        if (!sparkOut->refused()) {
            stages->setSparkOut(index, sparkOut->value());
        }
        return;
    }
    const auto* field = static_cast<NumberField*>(editor);
    if (field->refused()) {
        stages->refuse(index, field->text(), field->refusal());
    } else {
        stages->accept(index);
        stages->setNumber(index, field->value());
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

void StageDelegate::destroyEditor(QWidget* editor, const QModelIndex& index) const {
    m_document.endMerge();
    QStyledItemDelegate::destroyEditor(editor, index);
}

bool StageDelegate::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        auto* field = qobject_cast<NumberField*>(watched);
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (field && key == Qt::Key_Escape) {
            const QVariant original = field->property(originalProperty);
            field->reset(original.isValid() ? std::optional(original.toDouble()) : std::nullopt);
            if (field->value()) {
                emit commitData(field);
            }
        }
        if (field && (key == Qt::Key_Up || key == Qt::Key_Down)) {
            return false; // steps the number; the view would leave the cell
        }
    }
    return QStyledItemDelegate::eventFilter(watched, event);
}

} // namespace sparkout
