// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/cursor_model.h"

#include <algorithm>

namespace sparkout {

namespace {

/// A, B and B − A.
void put(std::vector<std::optional<double>>& into, std::size_t group,
         const std::optional<double>& a, const std::optional<double>& b) {
    into[3 * group] = a;
    into[3 * group + 1] = b;
    into[3 * group + 2] = a && b ? std::optional(*b - *a) : std::nullopt;
}

} // namespace

void CursorModel::show(const QString& axis, const Places& places, const ReadCurves& curves) {
    QStringList groups;
    for (const ReadCurve& curve : curves) {
        if (!groups.contains(curve.group)) {
            groups << curve.group;
        }
    }
    if (groups.isEmpty()) {
        groups << QString();
    }
    const auto width = static_cast<std::size_t>(groups.size()) * perGroup;
    std::vector<Row> rows{{axis, Digits::significant, true, {}}};
    rows.front().values.resize(width);
    for (std::size_t group = 0; group < width / perGroup; ++group) {
        put(rows.front().values, group, places[0], places[1]);
    }
    for (const ReadCurve& curve : curves) {
        auto row = std::ranges::find(rows, curve.name, &Row::name);
        if (row == rows.end()) {
            row = rows.insert(rows.end(), {curve.name, curve.digits, false, {}});
            row->values.resize(width);
        }
        const auto value = [&](const std::optional<double>& place) {
            return place ? curve.at(*place) : std::nullopt;
        };
        put(row->values, static_cast<std::size_t>(groups.indexOf(curve.group)), value(places[0]),
            value(places[1]));
    }
    const bool same = groups == m_groups && rows.size() == m_rows.size();
    if (same) {
        m_rows = std::move(rows);
        cellsChanged();
        return;
    }
    beginResetModel();
    m_groups = std::move(groups);
    m_rows = std::move(rows);
    endResetModel();
}

QString CursorModel::valueText(const Row& row, int column) const {
    const std::optional<double>& value = row.values[static_cast<std::size_t>(column)];
    if (!value) {
        return QStringLiteral("–");
    }
    const bool difference = column % perGroup == perGroup - 1;
    if (row.place) {
        return statedPlace(*value);
    }
    if (!difference) {
        return stated(*value, row.digits);
    }
    const std::optional<double>& beside = row.values[static_cast<std::size_t>(column) - 1];
    return statedDifference(*value, row.digits, beside.value_or(*value));
}

QVariant CursorModel::cell(int line, int column, int role) const {
    const Row& row = m_rows[static_cast<std::size_t>(line) + 1]; // row 0 has the places
    if (role == Qt::DisplayRole) {
        return column == 0 ? row.name : valueText(row, column - 1);
    }
    return role == Qt::TextAlignmentRole && column > 0 ? aligned(true) : QVariant();
}

QString CursorModel::header(int section, QChar between) const {
    if (section == 0) {
        return tr("Curve");
    }
    const QString& group = m_groups[(section - 1) / perGroup];
    const int which = (section - 1) % perGroup;
    const QString place = which == 0   ? QStringLiteral("A")
                          : which == 1 ? QStringLiteral("B")
                                       : QStringLiteral("B − A");
    return group.isEmpty() ? place : group + between + place;
}

QVariant CursorModel::head(int column, int role) const {
    const bool known = column >= 0 && column < columnsShown();
    return known && role == Qt::DisplayRole ? header(column, u'\n') : QVariant();
}

CsvTable CursorModel::table() const {
    CsvTable table;
    for (int section = 0; section < columnCount(); ++section) {
        table.header << header(section, u' ');
    }
    for (const Row& row : m_rows) {
        std::vector<CsvCell> cells{row.name};
        for (const std::optional<double>& value : row.values) {
            CsvCell& cell = cells.emplace_back();
            if (value) {
                cell.emplace<double>(row.place ? plainPlace(*value) : *value);
            }
        }
        table.rows.push_back(std::move(cells));
    }
    return table;
}

QString CursorModel::asTsv() const {
    return tabSeparated(table(), QLocale());
}

} // namespace sparkout
