// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/preview_model.h"

#include "ui/fields/mark.h"
#include "ui/measured/measured_text.h"
#include "ui/text/texts.h"

#include <QGuiApplication>
#include <QPalette>

#include <algorithm>

namespace sparkout {

namespace {

constexpr std::size_t previewRows = 50;
constexpr qsizetype columnsAtMost = 200;
constexpr std::size_t bytesOfCell = 60;

QStringList textsOf(const std::vector<std::string_view>& cells) {
    QStringList texts;
    for (const std::string_view cell : cells) {
        if (texts.size() == columnsAtMost) {
            break;
        }
        texts << printableText(QString::fromUtf8(cell.substr(0, bytesOfCell)));
    }
    return texts;
}

} // namespace

void PreviewModel::show(std::string_view text, const MeasuredTable& table) {
    beginResetModel();
    m_rows.clear();
    m_lines.clear();
    m_heads.clear();
    m_faults.clear();
    TableReader rows(text, table.dialect.delimiter);
    if (!table.isKeyValue && rows.next()) {
        m_heads = textsOf(rows.cells());
    }
    qsizetype columns = m_heads.size();
    while (m_rows.size() < previewRows && rows.next()) {
        m_rows.push_back(textsOf(rows.cells()));
        m_lines.push_back(rows.line());
        columns = std::max(columns, m_rows.back().size());
    }
    m_columns = static_cast<int>(columns);
    endResetModel();
}

void PreviewModel::setFaults(const CellFaults& faults) {
    m_faults.clear();
    for (const CellFault& fault : faults) {
        if (std::ranges::binary_search(m_lines, fault.line)) {
            m_faults.push_back(fault);
        }
    }
    cellsChanged();
}

QString PreviewModel::faultAt(int row, int column) const {
    const std::size_t line = m_lines[static_cast<std::size_t>(row)];
    const auto found = std::ranges::find_if(m_faults, [&](const CellFault& fault) {
        return fault.line == line
               && (fault.column == 0 || fault.column == static_cast<std::size_t>(column) + 1);
    });
    return found == m_faults.end() ? QString() : MeasuredText::fault(*found);
}

QVariant PreviewModel::cell(int row, int column, int role) const {
    const QString text = m_rows[static_cast<std::size_t>(row)].value(column);
    if (role == Qt::DisplayRole) {
        return text;
    }
    if (role != Qt::ForegroundRole && role != Qt::DecorationRole && role != Qt::ToolTipRole
        && role != Qt::AccessibleDescriptionRole) {
        return {};
    }
    const QString fault = faultAt(row, column);
    if (fault.isEmpty()) {
        return {};
    }
    switch (role) {
    case Qt::ForegroundRole: return markColor(Mark::error, QGuiApplication::palette());
    case Qt::DecorationRole: return markIcon(Mark::error);
    default: return fault;
    }
}

QVariant PreviewModel::head(int column, int role) const {
    if (role != Qt::DisplayRole) {
        return {};
    }
    const QString heading = m_heads.value(column);
    return heading.isEmpty() ? QString::number(column + 1) : heading;
}

QVariant PreviewModel::side(int row, int role) const {
    return role == Qt::DisplayRole
               ? QVariant(static_cast<int>(m_lines[static_cast<std::size_t>(row)]))
               : QVariant();
}

} // namespace sparkout
