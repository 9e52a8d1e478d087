// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/list_model.h"

#include "core/project/machine.h"
#include "core/project/member.h"
#include "ui/form/number_field.h"
#include "ui/inputs/column_header.h"
#include "ui/session/document.h"
#include "ui/table/pasted_cells.h"
#include "ui/text/hint_text.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QAbstractItemView>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QPalette>
#include <QPointer>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <utility>

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

ListModel::ListModel(std::string path, const Field& list, Document& document)
    : m_path(std::move(path)), m_list(list), m_document(document) {
    update(true);
}

std::string ListModel::rowPath(int row) const {
    return m_path + "/" + std::to_string(row);
}

const void* ListModel::item(const QModelIndex& index) const {
    return findMember(m_document.project(), rowPath(index.row())).owner;
}

std::vector<const Field*> ListModel::relevantColumns() const {
    std::vector<const Field*> columns;
    for (const Field& field : m_list.nested->fields) {
        const bool isRead =
            !field.relevant || field.relevant(m_document.project(), m_list.nested->defaults);
        if (isRead && shows(field)) {
            columns.push_back(&field);
        }
    }
    return columns;
}

int ListModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : m_rows;
}

int ListModel::columnCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_columns.size()) + resultColumns();
}

const char* ListModel::itemName() const {
    return m_list.nested->name;
}

bool ListModel::isField(const QModelIndex& index) const {
    return index.isValid() && index.column() < static_cast<int>(m_columns.size());
}

const Field& ListModel::field(const QModelIndex& index) const {
    return *m_columns[std::size_t(index.column())];
}

bool ListModel::relevant(const QModelIndex& index) const {
    const Field& column = field(index);
    return !column.relevant || column.relevant(m_document.project(), item(index));
}

std::optional<double> ListModel::number(const QModelIndex& index) const {
    return numberIn(field(index), item(index));
}

Project ListModel::withNumber(const QModelIndex& index, std::optional<double> value) const {
    Project project = m_document.project();
    const Member member = findMember(project, path(index));
    setNumberIn(*member.field, member.owner, value);
    return project;
}

void ListModel::setNumber(const QModelIndex& index, std::optional<double> value) {
    m_document.edit(withNumber(index, value), {"Input", field(index).label},
                    QString::fromStdString(path(index)));
}

bool ListModel::fits(const QModelIndex& index, std::optional<double> value) const {
    return !breaksRules(m_document.project(), withNumber(index, value));
}

std::string ListModel::path(const QModelIndex& index) const {
    return rowPath(index.row()) + "/" + field(index).key;
}

QString ListModel::shown(const QModelIndex& index) const {
    if (!relevant(index) || access(index) == Access::hidden) {
        return QStringLiteral("—");
    }
    const QString refused = refusedText(index);
    return refused.isNull() ? valueShown(index) : refused;
}

QString ListModel::valueShown(const QModelIndex& index) const {
    const auto value = number(index);
    return value ? showNumber(ShownScale::ofInput(field(index)).shown(*value), QLocale())
                 : QString();
}

QModelIndex ListModel::indexAt(const std::string& wanted) const {
    for (int row = 0; row < m_rows; ++row) {
        for (int column = 0; column < static_cast<int>(m_columns.size()); ++column) {
            const QModelIndex cell = index(row, column);
            if (path(cell) == wanted) {
                return cell;
            }
        }
        if (wanted == rowPath(row) || wanted.starts_with(rowPath(row) + "/")) {
            return index(row, 0);
        }
    }
    return wanted == m_path && m_rows > 0 ? index(0, 0) : QModelIndex();
}

Remark ListModel::remark(const QModelIndex& index) const {
    const auto refused = m_refused.constFind({index.row(), &field(index)});
    if (refused != m_refused.cend()) {
        return {Mark::error, refused->reason};
    }
    return remarkFor(m_issues, path(index));
}

QVariant ListModel::data(const QModelIndex& index, int role) const {
    if (!index.isValid()) {
        return {};
    }
    return isField(index) ? fieldData(index, role) : resultData(index, role);
}

QVariant ListModel::resultData(const QModelIndex&, int) const {
    return {};
}

QVariant ListModel::resultHeader(int, int) const {
    return {};
}

QVariant ListModel::fieldData(const QModelIndex& index, int role) const {
    const Remark mark = remark(index);
    switch (role) {
    case Qt::DisplayRole: return shown(index);
    case Qt::TextAlignmentRole: return int(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::DecorationRole:
        return mark.mark == Mark::none ? QVariant() : QVariant(markIcon(mark.mark));
    case Qt::ForegroundRole:
        if (mark.mark != Mark::none) {
            return markColor(mark.mark, QGuiApplication::palette());
        }
        return relevant(index) && access(index) == Access::free
                   ? QVariant()
                   : QVariant(QGuiApplication::palette().color(QPalette::Disabled, QPalette::Text));
    case Qt::ToolTipRole:
        return mark.mark == Mark::none
                   ? hintMarkup(field(index))
                         + (access(index) == Access::free
                                ? QString()
                                : QStringLiteral("<p><b>%1</b></p>").arg(m_access->lockText()))
                   : QStringLiteral("<p>%1</p>").arg(mark.reason.toHtmlEscaped());
    case Qt::AccessibleTextRole:
        return tr("%1 %2, %3: %4")
            .arg(structText(m_list.nested->name), QString::number(index.row() + 1),
                 StockReading::label(field(index)), shown(index));
    case Qt::AccessibleDescriptionRole:
        return mark.mark == Mark::none ? hintPlain(field(index)) : mark.reason;
    default: return {};
    }
}

QVariant ListModel::headerData(int section, Qt::Orientation orientation, int role) const {
    if (orientation == Qt::Vertical) {
        return role == Qt::DisplayRole ? QVariant(QString::number(section + 1)) : QVariant();
    }
    const int fields = static_cast<int>(m_columns.size());
    if (section >= fields) {
        return resultHeader(section - fields, role);
    }
    const Field& column = *m_columns[std::size_t(section)];
    switch (role) {
    case Qt::ToolTipRole: return hintMarkup(column);
    case Qt::DisplayRole: return columnText(column);
    case ColumnHeader::markupRole: return columnMarkup(column);
    default: return {};
    }
}

Qt::ItemFlags ListModel::flags(const QModelIndex& index) const {
    const Qt::ItemFlags usual = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    return isField(index) && relevant(index) && access(index) == Access::free
               ? usual | Qt::ItemIsEditable
               : usual;
}

void ListModel::refuse(const QModelIndex& index, const QString& text, const QString& reason) {
    m_refused.insert({index.row(), &field(index)}, {text, reason});
    emit dataChanged(index, index);
    emit refusalsChanged();
}

void ListModel::accept(const QModelIndex& index) {
    if (m_refused.remove({index.row(), &field(index)}) > 0) {
        emit dataChanged(index, index);
        emit refusalsChanged();
    }
}

QString ListModel::refusedText(const QModelIndex& index) const {
    return m_refused.value({index.row(), &field(index)}).text;
}

std::vector<Refusal> ListModel::refusals() const {
    std::vector<Refusal> list;
    for (auto it = m_refused.cbegin(); it != m_refused.cend(); ++it) {
        list.push_back({rowPath(it.key().first) + "/" + it.key().second->key, it->reason});
    }
    return list;
}

Access ListModel::access(const QModelIndex& index) const {
    return m_access->at(path(index));
}

void ListModel::setAccess(const FormAccessPtr& access) {
    m_access = access;
    setIssues(m_issues); // updates all cells
}

void ListModel::setIssues(const Issues& issues) {
    m_issues = issues;
    if (m_rows > 0) {
        emit dataChanged(index(0, 0), index(m_rows - 1, columnCount() - 1));
    }
}

QString ListModel::tableText() const {
    QStringList lines;
    for (int row = -1; row < m_rows; ++row) {
        QStringList cells{row < 0 ? structText(m_list.nested->name) : QString::number(row + 1)};
        for (int column = 0; column < columnCount(); ++column) {
            const QModelIndex cell = index(std::max(0, row), column);
            const bool empty = row >= 0 && isField(cell) && !relevant(cell);
            cells += empty     ? QString()
                     : row < 0 ? headerData(column, Qt::Horizontal, Qt::DisplayRole).toString()
                               : cell.data().toString();
        }
        lines += cells
                     .replaceInStrings(QRegularExpression(QStringLiteral("[\\t\\n\\r]+")),
                                       QStringLiteral(" "))
                     .join(u'\t');
    }
    return lines.join(u'\n') + u'\n';
}

QString ListModel::cellsText(const QModelIndexList& cells) const {
    QMap<int, QMap<int, QString>> texts;
    for (const QModelIndex& cell : cells) {
        const bool unused = isField(cell) && !relevant(cell);
        texts[cell.row()][cell.column()] = unused ? QString() : cell.data().toString();
    }
    PastedCells copied;
    for (const QMap<int, QString>& row : std::as_const(texts)) {
        copied.rows.push_back(row.values());
    }
    return copied.text();
}

std::size_t ListModel::lastRowsKept(const std::vector<const Field*>&) const {
    return 0;
}

void ListModel::resizeRows(Project& project, std::size_t rows, std::size_t) const {
    void* const owner = findMember(project, m_path).owner;
    m_list.resize(owner, std::min(rows, m_list.size(owner)));
    while (m_list.size(owner) < rows) {
        m_list.insert(owner, m_list.size(owner));
    }
}

QString ListModel::takeText(Project& project, int row, const Field& column,
                            const QString& text) const {
    const Member member = findMember(project, rowPath(row) + "/" + column.key);
    if (column.relevant && !column.relevant(project, member.owner)) {
        return text.isEmpty() || text == QStringLiteral("—")
                   ? QString()
                   : tr("“%1” cannot be entered: this row does not use the column").arg(text);
    }
    const Range& allowed = column.allowed(project, member.owner);
    const ShownScale scale = ShownScale::ofInput(column);
    const std::optional<double> value = scale.kept(pastedNumber(text));
    const bool whole = column.kind == Kind::integer || column.kind == Kind::optionalInteger;
    QString reason;
    if (text.isEmpty()) {
        reason = tr("a number is missing; allowed: %1");
    } else if (!value) {
        reason = tr("“%2” is not a number; allowed: %1");
    } else if (whole && *value != std::floor(*value)) {
        reason = tr("“%2” is not a whole number; allowed: %1");
    } else if (!allowed.contains(*value)) {
        reason = tr("“%2” is out of range; allowed: %1");
    } else {
        setNumberIn(column, member.owner, value);
        return {};
    }
    const QString range = rangeShown(scale.shown(allowed), column.unit);
    return text.isEmpty() ? reason.arg(range) : reason.arg(range, text);
}

void ListModel::update(bool replaced) {
    const ConstMember list = findMember(m_document.project(), m_path);
    const int rows = static_cast<int>(m_list.size(list.owner));
    auto columns = relevantColumns();
    if (replaced || rows != m_rows || columns != m_columns) {
        beginResetModel();
        m_refused.clear();
        m_rows = rows;
        m_columns = std::move(columns);
        endResetModel();
        emit refusalsChanged();
    } else if (m_rows > 0) {
        emit dataChanged(index(0, 0), index(m_rows - 1, columnCount() - 1));
    }
}

void ListModel::retranslate() {
    emit headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
    setIssues(m_issues);
}

} // namespace sparkout
