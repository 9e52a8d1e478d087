// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/identification/stiffness_model.h"

#include "ui/fields/mark.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QGuiApplication>
#include <QLocale>
#include <QPalette>

#include <algorithm>
#include <cstddef>

namespace sparkout {

namespace {

constexpr std::size_t mostReadings = 1000;

bool isEmptyRow(const std::array<QString, StiffnessModel::columns>& row) {
    return std::ranges::all_of(row, &QString::isEmpty);
}

} // namespace

StiffnessModel::StiffnessModel(const std::vector<double>& places_mm, double load_n, QObject* parent)
    : TableModel(parent) {
    const QLocale locale;
    constexpr int times = 2;
    for (const double place_mm : places_mm) {
        for (int i = 0; i < times; ++i) {
            for (const double force_n : {load_n / 2, load_n}) {
                m_rows.push_back({showNumber(place_mm, locale), showNumber(force_n, locale), {}});
            }
        }
    }
    m_rows.emplace_back();
}

std::vector<StiffnessReading> StiffnessModel::readings() const {
    std::vector<StiffnessReading> list;
    for (const Row& row : m_rows) {
        const auto at = pastedNumber(row[place]), force = pastedNumber(row[load]),
                   read = pastedNumber(row[deflection]);
        if (at && force && *force > 0 && read) {
            list.push_back({*at, *force, *read});
        }
    }
    return list;
}

QString StiffnessModel::faultOf(const Row& row, int column) {
    const QString& text = row.at(static_cast<std::size_t>(column));
    const auto number = pastedNumber(text);
    if (!text.isEmpty() && !number) {
        return tr("“%1” is not a number.").arg(printableText(text));
    }
    const bool isRead = !row[deflection].isEmpty();
    if (column == place && isRead && text.isEmpty()) {
        return tr("The place is missing.");
    }
    if (column == load && isRead && (!number || *number <= 0)) {
        return tr("The load must be above 0 N.");
    }
    return {};
}

QString StiffnessModel::fault() const {
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        for (int column = 0; column < columns; ++column) {
            if (const QString text = faultOf(m_rows[i], column); !text.isEmpty()) {
                return tr("Row %1: %2").arg(i + 1).arg(text);
            }
        }
    }
    return {};
}

void StiffnessModel::put(int row, int column, const QString& text) {
    const auto at = static_cast<std::size_t>(row);
    if (column >= columns || at >= mostReadings) {
        return;
    }
    if (at >= m_rows.size()) {
        m_rows.resize(at + 1);
    }
    m_rows[at].at(static_cast<std::size_t>(column)) = text.trimmed();
}

void StiffnessModel::follow() {
    if (m_rows.empty() || !isEmptyRow(m_rows.back())) {
        m_rows.emplace_back();
    }
}

void StiffnessModel::paste(const QModelIndex& from, const PastedCells& cells) {
    beginResetModel();
    for (std::size_t i = 0; i < cells.rows.size(); ++i) {
        for (qsizetype k = 0; k < cells.rows[i].size(); ++k) {
            put(std::max(from.row(), 0) + static_cast<int>(i),
                std::max(from.column(), 0) + static_cast<int>(k), cells.rows[i][k]);
        }
    }
    follow();
    endResetModel();
    emit edited();
}

void StiffnessModel::clear(const QModelIndexList& cells) {
    for (const QModelIndex& one : cells) {
        put(one.row(), one.column(), {});
    }
    cellsChanged();
    emit edited();
}

Qt::ItemFlags StiffnessModel::flags(const QModelIndex& index) const {
    return TableModel::flags(index) | Qt::ItemIsEditable;
}

bool StiffnessModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (!index.isValid() || role != Qt::EditRole) {
        return false;
    }
    put(index.row(), index.column(), value.toString());
    cellsChanged(); // faults of a row are shown in its other cells
    if (!isEmptyRow(m_rows.back())) {
        beginInsertRows({}, rowsShown(), rowsShown());
        m_rows.emplace_back();
        endInsertRows();
    }
    emit edited();
    return true;
}

QVariant StiffnessModel::cell(int row, int column, int role) const {
    const Row& shown = m_rows.at(static_cast<std::size_t>(row));
    const QString fault = faultOf(shown, column);
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole: return shown.at(static_cast<std::size_t>(column));
    case Qt::ToolTipRole: return fault.isEmpty() ? QVariant() : fault;
    case Qt::AccessibleTextRole:
        return tr("%1, row %2").arg(head(column, Qt::DisplayRole).toString()).arg(row + 1);
    case Qt::ForegroundRole:
        return fault.isEmpty() ? QVariant()
                               : QVariant(markColor(Mark::error, QGuiApplication::palette()));
    case Qt::TextAlignmentRole: return aligned(true);
    default: return {};
    }
}

QVariant StiffnessModel::head(int column, int role) const {
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (column) {
    case place: return tr("Place, mm");
    case load: return tr("Load, N");
    default: return tr("Deflection, µm");
    }
}

QVariant StiffnessModel::side(int row, int role) const {
    return role == Qt::DisplayRole ? QVariant(row + 1) : QVariant();
}

} // namespace sparkout
