// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/value_model.h"

#include "ui/kit/theme_icon.h"
#include "ui/text/texts.h"

#include <QGuiApplication>
#include <QIcon>
#include <QPalette>

#include <utility>

namespace sparkout {

namespace {

template <class List>
const auto& itemOf(const List& list, int index) {
    return list.at(static_cast<std::size_t>(index));
}

/// Marked up, or a tool tip does not wrap; V_k with its index below the line.
QString paragraphs(const QStringList& texts) {
    QString tip;
    for (const QString& text : texts) {
        if (!text.isEmpty()) {
            tip += QStringLiteral("<p>%1</p>").arg(withIndices(text));
        }
    }
    return tip;
}

} // namespace

void ValueModel::setTable(ValueTable table) {
    beginResetModel();
    m_table = std::move(table);
    endResetModel();
}

void ValueModel::setGreyed(bool grey) {
    if (std::exchange(m_grey, grey) != grey) {
        cellsChanged();
    }
}

QString ValueModel::spoken(int row, int column) const {
    const ValueCell& cell = itemOf(itemOf(m_table.cells, row), column);
    const QString said = QStringLiteral("%1, %2: %3")
                             .arg(itemOf(m_table.columns, column).fullName(),
                                  itemOf(m_table.rows, row).fullName(), cell.text);
    return cell.remark.isEmpty() ? said : said + QStringLiteral("; ") + cell.remark;
}

QVariant ValueModel::cell(int row, int column, int role) const {
    const ValueCell& cell = itemOf(itemOf(m_table.cells, row), column);
    switch (role) {
    case Qt::DisplayRole: return cell.text;
    case Qt::DecorationRole:
        return cell.remark.isEmpty() ? QVariant() : QVariant(themeIcon(u"warning"));
    case Qt::TextAlignmentRole: return aligned(true);
    case Qt::ForegroundRole:
        return m_grey
                   ? QVariant(QGuiApplication::palette().brush(QPalette::Disabled, QPalette::Text))
                   : QVariant();
    case Qt::AccessibleTextRole: return spoken(row, column);
    case Qt::ToolTipRole:
        return paragraphs({spoken(row, column), cell.tip, itemOf(m_table.rows, row).tip});
    default: return {};
    }
}

QVariant ValueModel::side(int row, int role) const {
    return row < rowsShown() ? headData(itemOf(m_table.rows, row), role, false) : QVariant();
}

QVariant ValueModel::head(int column, int role) const {
    return column < columnsShown() ? headData(itemOf(m_table.columns, column), role, true)
                                   : QVariant();
}

QVariant ValueModel::headData(const ValueHead& head, int role, bool right) {
    switch (role) {
    case Qt::DisplayRole: return head.text;
    case Qt::AccessibleTextRole: return head.fullName();
    case Qt::ToolTipRole: return paragraphs({head.fullName(), head.tip});
    case Qt::TextAlignmentRole: return aligned(right);
    default: return {};
    }
}

} // namespace sparkout
