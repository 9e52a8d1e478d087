// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/data_sheet.h"

#include "core/project/measured.h"
#include "core/project/member.h"
#include "ui/dialogs/copy_table.h"
#include "ui/form/mark.h"
#include "ui/kit/metrics.h"
#include "ui/kit/theme_icon.h"
#include "ui/measured/measured_text.h"
#include "ui/session/document.h"
#include "ui/text/hint_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QItemSelectionModel>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QPalette>
#include <QPushButton>
#include <QRegularExpression>
#include <QStyledItemDelegate>
#include <QVBoxLayout>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>
#include <vector>

namespace sparkout {

namespace {

constexpr int gaugePlace = -1; ///< default place of a trace

const char* keyOf(DataModel::List list) {
    switch (list) {
    case DataModel::List::parts: return "parts";
    case DataModel::List::summaries: return "summaries";
    case DataModel::List::traces: break;
    }
    return "traces";
}

bool isOneOf(const Field& field, std::initializer_list<std::string_view> keys) {
    return std::ranges::find(keys, std::string_view(field.key)) != keys.end();
}

/// Breaks a text into two lines at the space nearest to the middle.
QString onTwoLines(QString text) {
    constexpr qsizetype longLabel = 14;
    if (text.size() <= longLabel) {
        return text;
    }
    const qsizetype middle = text.size() / 2;
    const qsizetype before = text.lastIndexOf(u' ', middle), after = text.indexOf(u' ', middle);
    const qsizetype at =
        after < 0 || (before >= 0 && middle - before < after - middle) ? before : after;
    if (at > 0) {
        text[at] = u'\n';
    }
    return text;
}

template <typename Item>
void dropItems(std::vector<Item>& items, const std::vector<int>& falling) {
    for (const int row : falling) {
        if (row >= 0 && row < static_cast<int>(items.size())) {
            items.erase(items.begin() + row);
        }
    }
}

} // namespace

DataModel::DataModel(List list, Document& document, QObject* parent)
    : TableModel(parent)
    , m_which(list)
    , m_list(*tableOf<Measured>().find(keyOf(list)))
    , m_document(document) {
    for (const Field& field : m_list.nested->fields) {
        if (!isOneOf(field, {"time_s", "source_sha256"})) {
            m_columns.push_back(&field);
        }
    }
    connect(&document, &Document::changed, this, &DataModel::follow);
    follow();
}

void DataModel::follow() {
    const Project& project = m_document.project();
    if (project.measured.isSharedWith(m_shown)) {
        return;
    }
    m_shown = project.measured;
    const int rows = static_cast<int>(m_list.size(&measured()));
    if (rows != m_rows) {
        beginResetModel();
        m_refused.clear();
        m_rows = rows;
        endResetModel();
    } else {
        cellsChanged();
    }
}

const Measured& DataModel::measured() const {
    static const Measured none;
    const Project& project = m_document.project();
    return project.measured ? *project.measured : none;
}

const void* DataModel::item(int row) const {
    return m_list.itemIn(&measured(), static_cast<std::size_t>(row));
}

bool DataModel::isPlace(const Field& field) const {
    return isOneOf(field, {"place"});
}

/// Of a trace only the descriptive members are editable.
bool DataModel::isEditable(const Field& field) const {
    return m_which != List::traces || isOneOf(field, {"place", "factor_kw_per_a", "idle", "note"});
}

// --- displayed data -----------------------------------------------------------------------------

QString DataModel::shown(int row, const Field& field) const {
    const void* const of = item(row);
    if (isPlace(field)) {
        const std::optional<double> place = numberIn(field, of);
        return place ? MeasuredText::place(m_document.project(), static_cast<int>(*place))
                     : inputText(field.nullMeaning);
    }
    switch (field.kind) {
    case Kind::choice:
        return choiceText(field.choices[static_cast<std::size_t>(field.getChoice(of))].label);
    case Kind::text:
        return printableText(QString::fromStdString(field.as<std::string>(of)).simplified());
    case Kind::samples:
        return QLocale().toString(static_cast<qulonglong>(field.as<Samples>(of).size()));
    case Kind::numberList: {
        QStringList numbers;
        for (const double number : field.as<std::vector<double>>(of)) {
            numbers << showNumber(number, QLocale());
        }
        return numbers.join(QStringLiteral("; "));
    }
    default: {
        const std::optional<double> number = numberIn(field, of);
        return number ? showNumber(*number, QLocale()) : QString();
    }
    }
}

QVariant DataModel::cell(int row, int column, int role) const {
    const Field& field = *m_columns[static_cast<std::size_t>(column)];
    const auto refused = m_refused.find({row, &field});
    const bool isRefused = refused != m_refused.end();
    const bool isText = field.kind == Kind::text || field.kind == Kind::choice || isPlace(field);
    switch (role) {
    case Qt::DisplayRole: return isRefused ? refused->second.text : shown(row, field);
    case Qt::EditRole:
        if (isPlace(field)) {
            return static_cast<int>(numberIn(field, item(row)).value_or(gaugePlace));
        }
        if (field.kind == Kind::choice) {
            return field.getChoice(item(row));
        }
        return isRefused ? refused->second.text : shown(row, field);
    case Qt::TextAlignmentRole: return aligned(!isText);
    case Qt::DecorationRole: return isRefused ? QVariant(markIcon(Mark::error)) : QVariant();
    case Qt::ForegroundRole:
        return isRefused ? QVariant(markColor(Mark::error, QGuiApplication::palette()))
                         : QVariant();
    case Qt::ToolTipRole:
        return isRefused ? QVariant(
                   QStringLiteral("<p>%1</p>").arg(refused->second.reason.toHtmlEscaped()))
                         : QVariant(hintMarkup(field));
    case Qt::AccessibleTextRole:
        return tr("Row %1, %2: %3")
            .arg(QString::number(row + 1), inputText(field.label),
                 isRefused ? refused->second.text : shown(row, field));
    case Qt::AccessibleDescriptionRole:
        return isRefused ? refused->second.reason : hintPlain(field);
    default: return {};
    }
}

QVariant DataModel::head(int column, int role) const {
    const Field& field = *m_columns[static_cast<std::size_t>(column)];
    if (role == Qt::ToolTipRole) {
        return hintMarkup(field);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    const QString label = field.kind == Kind::samples ? tr("Samples") : inputText(field.label);
    return onTwoLines(*field.unit ? QStringLiteral("%1, %2").arg(label, unitText(field.unit))
                                  : label);
}

DataModel::Choices DataModel::choices(const QModelIndex& cell) const {
    const Field& field = *m_columns.at(static_cast<std::size_t>(cell.column()));
    Choices choices;
    if (!isEditable(field)) {
        return choices;
    }
    if (isPlace(field)) {
        if (field.kind == Kind::optionalInteger) {
            choices.emplace_back(inputText(field.nullMeaning), gaugePlace);
        }
        const int present = static_cast<int>(numberIn(field, item(cell.row())).value_or(0));
        const int count = std::max(placeCount(m_document.project()), present + 1);
        for (int i = 0; i < count; ++i) {
            choices.emplace_back(MeasuredText::place(m_document.project(), i), i);
        }
    } else if (field.kind == Kind::choice) {
        for (std::size_t i = 0; i < field.choices.size(); ++i) {
            choices.emplace_back(choiceText(field.choices[i].label), static_cast<int>(i));
        }
    }
    return choices;
}

Qt::ItemFlags DataModel::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.isValid() && isEditable(*m_columns[static_cast<std::size_t>(index.column())])) {
        flags |= Qt::ItemIsEditable;
    }
    return flags;
}

CsvTable DataModel::table() const {
    CsvTable table;
    for (int column = 0; column < columnsShown(); ++column) {
        table.header << head(column, Qt::DisplayRole).toString().replace(u'\n', u' ');
    }
    for (int row = 0; row < m_rows; ++row) {
        std::vector<CsvCell> cells;
        for (const Field* field : m_columns) {
            const bool isNumber = field->kind == Kind::number || field->kind == Kind::optionalNumber
                                  || (field->kind == Kind::integer && !isPlace(*field));
            const std::optional<double> number =
                isNumber ? numberIn(*field, item(row)) : std::nullopt;
            cells.push_back(number     ? CsvCell(*number)
                            : isNumber ? CsvCell()
                                       : CsvCell(shown(row, *field)));
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

// --- edits --------------------------------------------------------------------------------------

QString DataModel::takeNumber(void* item, const Field& field, const QString& text) const {
    const bool isOptional =
        field.kind == Kind::optionalNumber || field.kind == Kind::optionalInteger;
    const std::optional<double> value = parseNumber(text);
    const bool isWhole = field.kind == Kind::integer || field.kind == Kind::optionalInteger;
    if (text.isEmpty() && isOptional) {
        setNumberIn(field, item, std::nullopt);
        return {};
    }
    const QString range = rangeShown(field.hard, field.unit);
    if (!value) {
        return tr("“%1” is not a number; allowed: %2").arg(text, range);
    }
    if (isWhole && *value != std::floor(*value)) {
        return tr("“%1” is not a whole number; allowed: %2").arg(text, range);
    }
    if (!field.hard.contains(*value)) {
        return tr("“%1” is out of range; allowed: %2").arg(text, range);
    }
    setNumberIn(field, item, value);
    return {};
}

QString DataModel::take(void* item, const Field& field, const QString& text) const {
    if (field.kind == Kind::text) {
        field.as<std::string>(item) = text.toStdString();
        return {};
    }
    if (field.kind != Kind::numberList) {
        return takeNumber(item, field, text);
    }
    static const QRegularExpression gap(QStringLiteral("[;\\s]+"));
    std::vector<double> numbers;
    for (const QString& part : text.split(gap, Qt::SkipEmptyParts)) {
        const std::optional<double> value = parseNumber(part);
        if (!value || !field.hard.contains(*value)) {
            return tr("“%1” is not a number from %2; separate several by semicolons")
                .arg(part, rangeShown(field.hard, field.unit));
        }
        numbers.push_back(*value);
    }
    field.as<std::vector<double>>(item) = std::move(numbers);
    return {};
}

bool DataModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !(flags(index) & Qt::ItemIsEditable)) {
        return false;
    }
    const Field& field = *m_columns[static_cast<std::size_t>(index.column())];
    const std::pair<int, const Field*> key{index.row(), &field};
    if (value == cell(index.row(), index.column(), Qt::EditRole)) {
        return true;
    }
    Project project = m_document.project();
    Measured& changed = project.measured ? *project.measured : project.measured.emplace();
    void* const of = m_list.at(&changed, static_cast<std::size_t>(index.row()));
    if (isPlace(field)) {
        const int place = value.toInt();
        setNumberIn(field, of, place == gaugePlace ? std::nullopt : std::optional<double>(place));
    } else if (field.kind == Kind::choice) {
        field.setChoice(of, value.toInt());
    } else {
        const QString text = value.toString().trimmed();
        const QString reason = take(of, field, text);
        if (!reason.isEmpty()) {
            m_refused[key] = {text, reason};
            emit dataChanged(index, index);
            return false;
        }
    }
    m_refused.erase(key);
    m_document.endMerge();
    m_document.edit(std::move(project), {"Input", field.label});
    return true;
}

const char* DataModel::editName() const {
    return m_list.label;
}

void DataModel::addRow() {
    Project project = m_document.project();
    Measured& changed = project.measured ? *project.measured : project.measured.emplace();
    switch (m_which) {
    case List::parts: {
        MeasuredPart part;
        part.part = std::to_string(changed.parts.size() + 1);
        part.place = changed.parts.empty() ? 0 : changed.parts.back().place;
        changed.parts.push_back(std::move(part));
        break;
    }
    case List::summaries: {
        MeasuredSummary summary =
            changed.summaries.empty() ? MeasuredSummary() : changed.summaries.back();
        changed.summaries.push_back(std::move(summary));
        break;
    }
    case List::traces: return; // they are imported
    }
    m_document.endMerge();
    m_document.edit(std::move(project), {"Input", editName()});
}

void DataModel::takeAway(std::vector<int> rows) {
    if (rows.empty()) {
        return;
    }
    std::ranges::sort(rows, std::greater<>());
    Project project = m_document.project();
    Measured& changed = project.measured ? *project.measured : project.measured.emplace();
    switch (m_which) {
    case List::parts: dropItems(changed.parts, rows); break;
    case List::summaries: dropItems(changed.summaries, rows); break;
    case List::traces: dropItems(changed.traces, rows); break;
    }
    if (changed.parts.empty() && changed.summaries.empty() && changed.traces.empty()
        && changed.calibrations.empty()) {
        project.measured.reset();
    }
    m_document.endMerge();
    m_document.edit(std::move(project), {"Input", editName()});
}

namespace {

/// Editors for the cells of a DataModel: a combo box for choices, otherwise a line.
class DataDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QWidget* createEditor(QWidget* parent, const QStyleOptionViewItem& option,
                          const QModelIndex& index) const override;
    void setEditorData(QWidget* editor, const QModelIndex& index) const override;
    void setModelData(QWidget* editor, QAbstractItemModel* model,
                      const QModelIndex& index) const override;
};

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

constexpr int rowsMeasured = 50; ///< number used for column widths: a list may have thousands

} // namespace

DataSheet::DataSheet(DataModel::List list, Document& document, Settings* settings, QWidget* parent)
    : QWidget(parent)
    , m_list(list)
    , m_model(new DataModel(list, document, this))
    , m_table(new CopyTable([this] { return tabSeparated(m_model->table(), QLocale()); }, this))
    , m_note(new QLabel(this))
    , m_add(new QPushButton(this))
    , m_remove(new QPushButton(this)) {
    static constexpr std::array tables{"measuredParts", "measuredSummaries", "measuredTraces"};
    const QString name = QLatin1String(tables.at(static_cast<std::size_t>(list)));
    m_table->setObjectName(name);
    m_add->setObjectName(name + QStringLiteral("Add"));
    m_remove->setObjectName(name + QStringLiteral("Remove"));
    m_add->setIcon(themeIcon(u"add"));
    m_remove->setIcon(themeIcon(u"remove"));
    m_table->setModel(m_model);
    m_table->setItemDelegate(new DataDelegate(this));
    m_table->setSaving(
        [this] { return m_model->table(); },
        [&document] { return QString::fromStdString(document.project().title).simplified(); },
        settings);
    m_table->setSelectionBehavior(QAbstractItemView::SelectItems);
    m_table->setSelectionMode(QAbstractItemView::ExtendedSelection);
    m_table->setShowGrid(true);
    m_table->setVerticalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    m_table->horizontalHeader()->setResizeContentsPrecision(rowsMeasured);
    m_note->setTextFormat(Qt::PlainText);
    m_note->setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->addWidget(m_note, 1);
    row->addWidget(m_add);
    row->addWidget(m_remove);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(metrics::tight);
    column->addLayout(row);
    column->addWidget(m_table, 1);
    m_add->setVisible(list != DataModel::List::traces);
    connect(m_add, &QPushButton::clicked, this, &DataSheet::addRow);
    connect(m_remove, &QPushButton::clicked, this, &DataSheet::removeRows);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
            &DataSheet::showButtons);
    connect(m_model, &QAbstractItemModel::modelReset, this, &DataSheet::showButtons);
    retranslate();
}

void DataSheet::fitRows() {
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height()
                                                     + 2 * metrics::tight);
}

void DataSheet::addRow() {
    m_model->addRow();
    const QModelIndex added = m_model->index(m_model->rowCount() - 1, 0);
    m_table->setCurrentIndex(added);
    m_table->scrollTo(added);
    m_table->setFocus();
}

void DataSheet::removeRows() {
    std::vector<int> rows;
    for (const QModelIndex& cell : m_table->selectionModel()->selectedIndexes()) {
        if (std::ranges::find(rows, cell.row()) == rows.end()) {
            rows.push_back(cell.row());
        }
    }
    m_model->takeAway(std::move(rows));
}

void DataSheet::keyPressEvent(QKeyEvent* event) {
    if (event->keyCombination() == QKeyCombination(Qt::ControlModifier, Qt::Key_Delete)) {
        removeRows();
    } else {
        QWidget::keyPressEvent(event);
    }
}

void DataSheet::showButtons() {
    m_remove->setEnabled(m_table->selectionModel()->hasSelection());
}

void DataSheet::retranslate() {
    const auto tell = [](QPushButton& button, const QString& text, const QString& tip) {
        button.setText(text);
        button.setAccessibleName(text);
        button.setToolTip(tip);
    };
    switch (m_list) {
    case DataModel::List::parts:
        m_table->setAccessibleName(tr("Measured parts"));
        m_note->setText(tr("A row for each zone or section of a part. Double click or F2 edits a "
                           "cell; separate several diameters by semicolons."));
        break;
    case DataModel::List::summaries:
        m_table->setAccessibleName(tr("Measured statistics"));
        m_note->setText(tr("Statistics of parts that are not listed one by one, as in a printed "
                           "table: the mean with the value after ±, and the number of parts."));
        break;
    case DataModel::List::traces:
        m_table->setAccessibleName(tr("Measured traces"));
        m_note->setText(tr("Quantities over the time of one cycle, as they were imported. Place, "
                           "power to current, idle value and note can be edited."));
        break;
    }
    tell(*m_add, tr("Add a row"), tr("Add a row at the end"));
    tell(*m_remove, tr("Remove"), tr("Remove the rows of the selected cells (Ctrl+Del)"));
    fitRows();
    m_model->retranslate();
    m_table->retranslate();
    showButtons();
}

} // namespace sparkout
