// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/value_model.h"

#include "ui/fields/mark.h"
#include "ui/kit/theme_icon.h"
#include "ui/text/texts.h"

#include <QCollator>
#include <QFont>
#include <QGuiApplication>
#include <QIcon>
#include <QLocale>
#include <QPalette>

#include <algorithm>
#include <numeric>
#include <utility>

namespace sparkout {

namespace {

template <class List>
const auto& itemOf(const List& list, int index) {
    return list.at(static_cast<std::size_t>(index));
}

/// Marked up so that a tool tip wraps; the index of V_k is lowered. Names by the user or a file
/// stay literal.
QString paragraphs(const QString& named, bool hasSymbols, const QStringList& tips) {
    const auto paragraph = [](const QString& markup) {
        return markup.isEmpty() ? QString() : QStringLiteral("<p>%1</p>").arg(markup);
    };
    QString tip = paragraph(hasSymbols ? withIndices(named) : named.toHtmlEscaped());
    for (const QString& text : tips.join(u'\n').split(u'\n', Qt::SkipEmptyParts)) {
        tip += paragraph(withIndices(text));
    }
    return tip;
}

/// Sorts numbers before words; missing values come last in both directions.
struct SortKey {
    enum Kind { number, word, missing };
    Kind kind = missing;
    double value = 0;
    QString text = {};

    explicit SortKey(const ValueCell& cell) {
        if (const auto* const is = std::get_if<double>(&cell.value)) {
            kind = number;
            value = *is;
            return;
        }
        const auto* const said = std::get_if<QString>(&cell.value);
        text = said ? *said : cell.text;
        kind = text.isEmpty() ? missing : word;
    }
};

} // namespace

void ValueModel::setTable(ValueTable table) {
    beginResetModel();
    m_table = std::move(table);
    arrange();
    endResetModel();
}

void ValueModel::update(ValueTable table) {
    if (table.rows.size() != m_table.rows.size()
        || table.columns.size() != m_table.columns.size()) {
        setTable(std::move(table));
        return;
    }
    m_table = std::move(table);
    sort(m_sorted, m_direction);
    retranslate();
}

void ValueModel::setGreyed(bool grey) {
    if (std::exchange(m_grey, grey) != grey) {
        cellsChanged();
    }
}

QString ValueModel::asTsv() const {
    return tabSeparated(shown(), QLocale());
}

int ValueModel::rowAt(int line) const {
    return line < 0 || line >= rowsShown() ? -1 : static_cast<int>(itemOf(m_order, line));
}

int ValueModel::lineOf(int row) const {
    const auto found = std::ranges::find(m_order, static_cast<std::size_t>(row));
    return found == m_order.end() ? -1 : static_cast<int>(found - m_order.begin());
}

void ValueModel::arrange() {
    m_order.resize(m_table.rows.size());
    std::iota(m_order.begin(), m_order.end(), std::size_t{0});
    if (m_sorted < 0 || m_sorted >= columnsShown() || !m_table.isList
        || std::ranges::any_of(m_table.rows, &ValueHead::isGroup)) {
        return;
    }
    std::vector<SortKey> keys;
    for (const std::vector<ValueCell>& row : m_table.cells) {
        keys.emplace_back(itemOf(row, m_sorted));
    }
    QCollator words;
    words.setNumericMode(true);
    const bool falls = m_direction == Qt::DescendingOrder;
    std::ranges::stable_sort(m_order, [&](std::size_t one, std::size_t other) {
        const SortKey &a = keys[one], &b = keys[other];
        if (a.kind != b.kind) {
            return a.kind < b.kind;
        }
        const SortKey &first = falls ? b : a, &second = falls ? a : b;
        return a.kind == SortKey::number ? first.value < second.value
                                         : words.compare(first.text, second.text) < 0;
    });
}

void ValueModel::sort(int column, Qt::SortOrder order) {
    emit layoutAboutToBeChanged({}, QAbstractItemModel::VerticalSortHint);
    const std::vector<std::size_t> before = m_order;
    m_sorted = column;
    m_direction = order;
    arrange();
    const QModelIndexList from = persistentIndexList();
    QModelIndexList to;
    for (const QModelIndex& each : from) {
        to << index(lineOf(static_cast<int>(itemOf(before, each.row()))), each.column());
    }
    changePersistentIndexList(from, to);
    emit layoutChanged({}, QAbstractItemModel::VerticalSortHint);
}

const ValueHead& ValueModel::headOf(int line) const {
    return itemOf(m_table.rows, rowAt(line));
}

Qt::ItemFlags ValueModel::flags(const QModelIndex& index) const {
    return index.isValid() && headOf(index.row()).isGroup ? Qt::ItemFlags(Qt::ItemIsEnabled)
                                                          : TableModel::flags(index);
}

QString ValueModel::spoken(int line, int column) const {
    const ValueHead &row = headOf(line), &head = itemOf(m_table.columns, column);
    const ValueCell& cell = itemOf(itemOf(m_table.cells, rowAt(line)), column);
    if (row.isGroup) {
        return cell.text;
    }
    if (m_table.isList && column == 0 && head.isText) { // it names the row
        return cell.said.isEmpty() ? row.fullName()
                                   : QStringLiteral("%1: %2").arg(row.fullName(), cell.said);
    }
    const QString said =
        QStringLiteral("%1, %2: %3")
            .arg(head.fullName(), row.fullName(), cell.said.isEmpty() ? cell.text : cell.said);
    return cell.remark.isEmpty() ? said : said + QStringLiteral("; ") + cell.remark;
}

QVariant ValueModel::inkOf(const ValueCell& cell) const {
    if (!cell.fault.isEmpty()) {
        return markColor(Mark::error, QGuiApplication::palette());
    }
    return m_grey ? QVariant(QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text))
                  : QVariant();
}

QVariant ValueModel::cell(int line, int column, int role) const {
    const ValueHead& row = headOf(line);
    const ValueCell& cell = itemOf(itemOf(m_table.cells, rowAt(line)), column);
    switch (role) {
    case Qt::DisplayRole: return cell.text;
    case Qt::DecorationRole:
        return !cell.fault.isEmpty()    ? QVariant(markIcon(Mark::error))
               : !cell.remark.isEmpty() ? QVariant(themeIcon(u"warning"))
               : cell.icon.isNull()     ? QVariant()
                                        : QVariant(cell.icon);
    case Qt::TextAlignmentRole: {
        const bool right = !itemOf(m_table.columns, column).isText;
        const Qt::Alignment side = right ? Qt::AlignRight : Qt::AlignLeft;
        return m_table.atTop ? static_cast<int>(side | Qt::AlignTop) : aligned(right);
    }
    case Qt::FontRole: {
        QFont font;
        font.setBold(true);
        const bool isBold = row.isStrong && !itemOf(m_table.columns, column).isPlain;
        return isBold || row.isGroup ? QVariant(font) : QVariant();
    }
    case Qt::ForegroundRole: return inkOf(cell);
    case Qt::AccessibleTextRole: return spoken(line, column);
    case Qt::AccessibleDescriptionRole: return cell.fault;
    case Qt::ToolTipRole:
        return row.isGroup ? QVariant()
                           : paragraphs(spoken(line, column), !m_table.isList,
                                        {cell.fault, cell.tip, row.tip});
    default: return {};
    }
}

QVariant ValueModel::side(int line, int role) const {
    return line < rowsShown() ? headData(headOf(line), role, false) : QVariant();
}

QVariant ValueModel::head(int column, int role) const {
    if (column >= columnsShown()) {
        return {};
    }
    const ValueHead& of = itemOf(m_table.columns, column);
    return role == Qt::TextAlignmentRole
               ? aligned(!of.isText).toInt() | static_cast<int>(Qt::TextWordWrap)
               : headData(of, role, !of.isText);
}

QVariant ValueModel::headData(const ValueHead& head, int role, bool right) const {
    switch (role) {
    case Qt::DisplayRole: return head.text;
    case Qt::AccessibleTextRole: return head.fullName();
    case Qt::ToolTipRole: return paragraphs(head.fullName(), !m_table.isList, {head.tip});
    case Qt::TextAlignmentRole: return aligned(right);
    default: return {};
    }
}

} // namespace sparkout
