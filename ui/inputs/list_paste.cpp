// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/list_paste.h"

#include "core/project/member.h"
#include "ui/inputs/list_model.h"
#include "ui/table/pasted_cells.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QLocale>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

/// The heading of a stock column in the other reading, per side or on the diameter.
QString columnInOtherReading(const Field& field) {
    if (!StockReading::isStock(field)) {
        return {};
    }
    const QString name = StockReading::column(field, !StockReading::isOnDiameter(field));
    return QStringLiteral("%1, %2").arg(name, unitText(field.unit));
}

bool isWord(const QString& cell) {
    const QString text = cell.trimmed();
    return !text.isEmpty() && text.front().isLetter() && !pastedNumber(text);
}

bool takesNumbers(const Field& field) {
    return field.kind == Kind::number || field.kind == Kind::optionalNumber
           || field.kind == Kind::integer || field.kind == Kind::optionalInteger;
}

QString scaled(const QString& text, double factor) {
    const std::optional<double> value = factor == 1 ? std::nullopt : pastedNumber(text);
    return value ? showNumber(*value * factor, QLocale()) : text;
}

} // namespace

ListPaste::ListPaste(const ListModel& model, std::string path, const Field& list,
                     const Project& project)
    : m_model(model), m_path(std::move(path)), m_list(list), m_project(project) {}

void ListPaste::paste(PastedCells cells, const QModelIndex& at) {
    std::vector<Column> columns = columnsByHeads(cells.rows.front());
    const bool withHeads = !columns.empty();
    if (withHeads) {
        cells.rows.erase(cells.rows.begin());
    } else {
        qsizetype width = 0;
        for (const QStringList& row : cells.rows) {
            width = std::max(width, row.size());
        }
        m_first = std::max(0, at.row());
        columns = columnsFrom(std::max(0, at.column()), width);
    }
    if (!withHeads && hasForeignHeads(cells.rows, columns)) {
        cells.rows.erase(cells.rows.begin());
    }
    if (cells.rows.empty()) {
        m_faults += tr("there are no rows below the headings");
    }
    if (m_faults.isEmpty()) {
        makeRoom(cells.rows.size(), columns, withHeads);
    }
    if (m_faults.isEmpty()) {
        take(cells.rows, columns);
    }
    if (!m_faults.isEmpty()) {
        m_project.reset();
    }
}

/// Empty if the row has no heading of a member.
std::vector<ListPaste::Column> ListPaste::columnsByHeads(const QStringList& heads) const {
    std::vector<Column> columns;
    const std::vector<const Field*>& fields = m_model.columns();
    for (qsizetype i = 0; i < heads.size(); ++i) {
        const QString head = heads[i].simplified();
        for (std::size_t k = 0; k < fields.size(); ++k) {
            const QString own =
                m_model.headerData(int(k), Qt::Horizontal, Qt::DisplayRole).toString().simplified();
            const auto is = [&head](const QString& name) {
                return !head.isEmpty() && head.compare(name, Qt::CaseInsensitive) == 0;
            };
            if (is(own)) {
                columns.push_back({i, fields[k]});
            } else if (is(columnInOtherReading(*fields[k]))) {
                const bool onDiameter = StockReading::isOnDiameter(*fields[k]);
                columns.push_back({i, fields[k], onDiameter ? 2 : 0.5});
            }
        }
    }
    return columns;
}

/// Whether the first row has the headings of another table: only words, above numbers in some
/// numeric column.
bool ListPaste::hasForeignHeads(const std::vector<QStringList>& rows,
                                const std::vector<Column>& columns) {
    if (rows.size() < 2) {
        return false;
    }
    const auto isHead = [&rows](const Column& column) {
        return takesNumbers(*column.field) && isWord(rows[0].value(column.from))
               && pastedNumber(rows[1].value(column.from));
    };
    return std::ranges::none_of(
               rows[0],
               [](const QString& cell) { return !cell.trimmed().isEmpty() && !isWord(cell); })
           && std::ranges::any_of(columns, isHead);
}

std::vector<ListPaste::Column> ListPaste::columnsFrom(int first, qsizetype width) {
    std::vector<Column> columns;
    const std::vector<const Field*>& fields = m_model.columns();
    if (first + width > m_model.columnCount()) {
        m_faults += tr("%n column(s) too many from the selected cell on", nullptr,
                       static_cast<int>(first + width - m_model.columnCount()));
        return columns;
    }
    for (qsizetype i = 0; i < width && std::size_t(first + i) < fields.size(); ++i) {
        columns.push_back({i, fields[std::size_t(first + i)]});
    }
    return columns;
}

/// Gives the list the number of pasted rows, each new one a copy of the row before it.
void ListPaste::makeRoom(std::size_t rows, const std::vector<Column>& columns, bool all) {
    void* const owner = findMember(*m_project, m_path).owner;
    const std::size_t before = m_list.size(owner);
    const auto first = static_cast<std::size_t>(m_first);
    std::vector<const Field*> fields;
    for (const Column& column : columns) {
        fields.push_back(column.field);
    }
    std::size_t last = std::min(m_model.lastRowsKept(fields), before);
    if (first + last >= before && !all) {
        last = 0; // it is overwritten
    }
    const std::size_t wanted = all ? rows + last : std::max(before, first + rows + last);
    if (!m_list.hard.contains(double(wanted))) {
        m_faults += tr("there would be %1 rows; allowed: %2")
                        .arg(QString::number(wanted), rangeShown(m_list.hard, ""));
        return;
    }
    m_model.resizeRows(*m_project, wanted, last);
}

/// Takes words first: they may decide whether a number is needed.
void ListPaste::take(const std::vector<QStringList>& rows, const std::vector<Column>& columns) {
    for (const bool words : {true, false}) {
        for (std::size_t i = 0; i < rows.size(); ++i) {
            for (const Column& column : columns) {
                if ((column.field->kind == Kind::countOrWord) == words) {
                    takeCell(m_first + int(i), *column.field,
                             scaled(rows[i].value(column.from).trimmed(), column.factor));
                }
            }
        }
    }
}

void ListPaste::takeCell(int row, const Field& field, const QString& text) {
    const QString reason = m_model.takeText(*m_project, row, field, text);
    if (!reason.isEmpty()) {
        m_faults += tr("%1 %2, %3: %4", "stage 2, stock: reason")
                        .arg(structText(m_list.nested->name), QString::number(row + 1),
                             StockReading::column(field), reason);
    }
}

} // namespace sparkout
