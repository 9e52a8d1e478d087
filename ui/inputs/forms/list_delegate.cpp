// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/list_delegate.h"

#include "core/project/machine_steps.h"
#include "ui/fields/number_field.h"
#include "ui/inputs/forms/list_model.h"
#include "ui/session/document.h"

#include <QAbstractItemView>
#include <QKeyEvent>
#include <QPointer>

namespace sparkout {

namespace {

constexpr const char* startedProperty = "sparkoutStarted";
constexpr const char* originalProperty = "sparkoutOriginal"; ///< invalid when not given
constexpr const char* cellProperty = "sparkoutCell";

const ListModel& modelOf(const QModelIndex& index) {
    return *static_cast<const ListModel*>(index.model());
}

} // namespace

ListDelegate::ListDelegate(Document& document, QObject* parent)
    : QStyledItemDelegate(parent), m_document(document) {}

QWidget* ListDelegate::createEditor(QWidget* parent, const QStyleOptionViewItem&,
                                    const QModelIndex& index) const {
    auto* self = const_cast<ListDelegate*>(this);
    const ListModel& model = modelOf(index);
    NumberSpec spec = NumberSpec::of(model.field(index), m_document.project(), model.item(index));
    spec.optional = false; // a visible column is required
    auto* editor = new NumberField(spec, parent);
    setCell(*editor, index);
    editor->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
    editor->setAccessibleName(index.data(Qt::AccessibleTextRole).toString());
    connect(editor, &NumberField::valueEdited, self, [self, editor] { self->commit(editor); });
    connect(editor, &NumberField::remarkChanged, self, // a pause in typing
            [self, editor] { self->commit(editor); });
    editor->setFits([&model, cell = QPersistentModelIndex(index)](std::optional<double> value) {
        return !cell.isValid() || model.fits(cell, value);
    });
    editor->setSteps([this, path = model.path(index)](double value, int steps) {
        return steppedOnMachine(m_document.project(), path, value, steps);
    });
    return editor;
}

void ListDelegate::setCell(QWidget& editor, const QModelIndex& cell) {
    editor.setProperty(cellProperty, QVariant::fromValue(QPersistentModelIndex(cell)));
}

bool ListDelegate::isOpen(const QWidget& editor) {
    const auto* view =
        qobject_cast<const QAbstractItemView*>(editor.parentWidget()->parentWidget());
    const auto cell = editor.property(cellProperty).value<QPersistentModelIndex>();
    return view && view->indexWidget(cell) == &editor;
}

void ListDelegate::commit(QWidget* editor) {
    if (isOpen(*editor)) {
        emit commitData(editor);
    }
}

void ListDelegate::close(QWidget* editor) {
    if (isOpen(*editor)) {
        emit commitData(editor);
        emit closeEditor(editor, SubmitModelCache);
    }
}

void ListDelegate::setEditorData(QWidget* editor, const QModelIndex& index) const {
    const ListModel& model = modelOf(index);
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

void ListDelegate::setModelData(QWidget* editor, QAbstractItemModel* model,
                                const QModelIndex& index) const {
    auto* list = static_cast<ListModel*>(model);
    const auto* field = static_cast<NumberField*>(editor);
    list->setNumber(index, field->value()); // restores the text before the refused one
    if (field->refused() && !field->typing()) {
        list->refuse(index, field->text(), field->refusal());
    } else if (!field->refused()) {
        list->accept(index);
    }
}

void ListDelegate::dropRefusal(const QAbstractItemView& view) {
    auto* field = view.viewport()->findChild<NumberField*>();
    if (field && field->refused()) {
        field->revert();
    }
}

void ListDelegate::destroyEditor(QWidget* editor, const QModelIndex& index) const {
    if (index.isValid()) { // the editor may be left without a pause in typing
        auto fields = editor->findChildren<NumberField*>();
        if (auto* own = qobject_cast<NumberField*>(editor)) {
            fields += own;
        }
        for (NumberField* field : fields) {
            field->settle();
        }
        setModelData(editor, const_cast<QAbstractItemModel*>(index.model()), index);
    }
    m_document.endMerge();
    QStyledItemDelegate::destroyEditor(editor, index);
}

bool ListDelegate::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::KeyPress) {
        auto* field = qobject_cast<NumberField*>(watched);
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (field && key == Qt::Key_Escape) {
            const QVariant original = field->property(originalProperty);
            field->reset(original.isValid() ? std::optional(original.toDouble()) : std::nullopt);
            if (field->value()) {
                commit(field);
            }
        }
        if (field && (key == Qt::Key_Up || key == Qt::Key_Down)) {
            return false; // steps the number; the view would leave the cell
        }
        if (auto* editor = qobject_cast<QWidget*>(watched);
            editor && (key == Qt::Key_Return || key == Qt::Key_Enter)) {
            // As the base class does, after the editor has received the key, unless a click
            // elsewhere has closed it meanwhile.
            QMetaObject::invokeMethod(
                this,
                [this, open = QPointer<QWidget>(editor)] {
                    if (open) {
                        close(open);
                    }
                },
                Qt::QueuedConnection);
            return false;
        }
    }
    return QStyledItemDelegate::eventFilter(watched, event);
}

} // namespace sparkout
