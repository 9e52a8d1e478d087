// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/columns_model.h"

#include "ui/measured/measured_text.h"
#include "ui/text/texts.h"

#include <algorithm>
#include <array>
#include <utility>

namespace sparkout {

namespace {

constexpr int noPlace = -1;
constexpr std::array allUnits{ColumnUnit::none, ColumnUnit::mm,  ColumnUnit::um, ColumnUnit::s,
                              ColumnUnit::ms,   ColumnUnit::min, ColumnUnit::kw, ColumnUnit::w,
                              ColumnUnit::n,    ColumnUnit::kn,  ColumnUnit::a};

} // namespace

ColumnsModel::ColumnsModel(const Project& project, QObject* parent)
    : TableModel(parent), m_project(project) {}

void ColumnsModel::show(std::vector<ColumnMatch> matches) {
    beginResetModel();
    m_matches = std::move(matches);
    endResetModel();
}

QString ColumnsModel::name(int column) {
    switch (column) {
    case heading: return tr("Heading");
    case quantity: return tr("Column contents");
    case unit: return tr("Unit");
    case place: return tr("Zone or section");
    default: return {};
    }
}

bool ColumnsModel::hasPlace(const ColumnMatch& match) const {
    return isNumeric(match.quantity) && match.quantity != ColumnQuantity::place
           && match.quantity != ColumnQuantity::time;
}

ColumnsModel::Choices ColumnsModel::choices(const QModelIndex& cell) const {
    const ColumnMatch& match = m_matches.at(static_cast<std::size_t>(cell.row()));
    Choices choices;
    switch (cell.column()) {
    case quantity:
        for (int i = 0; i < static_cast<int>(ColumnQuantity::count_); ++i) {
            choices.emplace_back(MeasuredText::column(static_cast<ColumnQuantity>(i)), i);
        }
        break;
    case unit:
        for (const ColumnUnit of : allUnits) {
            const bool isNumber =
                isNumeric(match.quantity) && match.quantity != ColumnQuantity::place;
            if (isNumber ? factorOf(match.quantity, of).has_value() : of == match.unit) {
                choices.emplace_back(MeasuredText::unit(of), static_cast<int>(of));
            }
        }
        if (match.unit == ColumnUnit::unknown) {
            choices.emplace_back(MeasuredText::unit(match.unit), static_cast<int>(match.unit));
        }
        break;
    case place:
        if (hasPlace(match)) {
            choices.emplace_back(tr("as stated in the table"), noPlace);
            const int count = std::max(placeCount(m_project), match.place.value_or(0) + 1);
            for (int i = 0; i < count; ++i) {
                choices.emplace_back(MeasuredText::place(m_project, i), i);
            }
        }
        break;
    default: break;
    }
    return choices;
}

int ColumnsModel::valueOf(const ColumnMatch& match, int column) const {
    return column == quantity ? static_cast<int>(match.quantity)
           : column == unit   ? static_cast<int>(match.unit)
                              : match.place.value_or(noPlace);
}

QVariant ColumnsModel::cell(int row, int column, int role) const {
    const ColumnMatch& match = m_matches[static_cast<std::size_t>(row)];
    const QString head = printableText(QString::fromStdString(match.heading));
    if (role == Qt::EditRole && column != heading) {
        return valueOf(match, column);
    }
    if (role == Qt::AccessibleTextRole && column != heading) {
        return tr("%1 of the column “%2”").arg(name(column), head);
    }
    if (role != Qt::DisplayRole) {
        return {};
    }
    switch (column) {
    case heading: return head.isEmpty() ? tr("Column %1").arg(row + 1) : head;
    case quantity: return MeasuredText::column(match.quantity);
    case unit: return MeasuredText::unit(match.unit);
    default:
        return !hasPlace(match) ? QString()
               : match.place    ? MeasuredText::place(m_project, *match.place)
                                : tr("as stated in the table");
    }
}

QVariant ColumnsModel::head(int column, int role) const {
    return role == Qt::DisplayRole ? QVariant(name(column)) : QVariant();
}

Qt::ItemFlags ColumnsModel::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.column() != heading && choices(index).size() > 1) {
        flags |= Qt::ItemIsEditable;
    }
    return flags;
}

bool ColumnsModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    if (role != Qt::EditRole || !index.isValid() || index.column() == heading) {
        return false;
    }
    ColumnMatch& match = m_matches[static_cast<std::size_t>(index.row())];
    const int chosen = value.toInt();
    if (chosen == valueOf(match, index.column())) {
        return true;
    }
    switch (index.column()) {
    case quantity:
        match.quantity = static_cast<ColumnQuantity>(chosen);
        if (!factorOf(match.quantity, match.unit)) {
            match.unit = ColumnUnit::none; // its own
        }
        break;
    case unit: match.unit = static_cast<ColumnUnit>(chosen); break;
    default: match.place = chosen == noPlace ? std::nullopt : std::optional(chosen);
    }
    emit dataChanged(this->index(index.row(), 0), this->index(index.row(), columnCount_ - 1));
    emit edited();
    return true;
}

} // namespace sparkout
