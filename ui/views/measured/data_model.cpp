// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/measured/data_model.h"

#include "core/project/measured.h"
#include "core/project/member.h"
#include "ui/fields/mark.h"
#include "ui/measured/measured_text.h"
#include "ui/session/document.h"
#include "ui/text/hint_text.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QGuiApplication>
#include <QLocale>
#include <QPalette>
#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string_view>
#include <utility>

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

// --- what is shown ------------------------------------------------------------------------------

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

} // namespace sparkout
