// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/editors/rows_editor.h"

#include "ui/form/pasted_numbers.h"
#include "ui/text/number_text.h"

#include <QLocale>

namespace sparkout {

namespace {

QString joinedRows(const std::vector<std::vector<double>>& rows) {
    QStringList texts;
    for (const std::vector<double>& row : rows) {
        QStringList numbers;
        for (const double value : row) {
            numbers += showNumber(value, QLocale());
        }
        texts += numbers.join(u' ');
    }
    return texts.join(QStringLiteral("; "));
}

} // namespace

const NumberRows& RowsEditor::stored() const {
    return field().as<NumberRows>(owner());
}

QString RowsEditor::storedText() const {
    return stored() ? joinedRows(*stored()) : QString();
}

std::optional<NumberRows> RowsEditor::rowsOf(const QString& text) const {
    if (text.trimmed().isEmpty()) {
        return NumberRows();
    }
    std::vector<std::vector<double>> rows;
    for (const QString& line : text.split(u';', Qt::SkipEmptyParts)) {
        std::vector<double> row;
        for (const QString& number : line.simplified().split(u' ', Qt::SkipEmptyParts)) {
            const std::optional<double> value = parseNumber(number);
            if (!value) {
                return std::nullopt;
            }
            row.push_back(*value);
        }
        if (row.size() != field().count) {
            return std::nullopt;
        }
        rows.push_back(std::move(row));
    }
    return NumberRows(std::move(rows));
}

bool RowsEditor::isStored(const QString& text) const {
    const std::optional<NumberRows> rows = rowsOf(text);
    return rows && *rows == stored();
}

RowsEditor::CellsText RowsEditor::textOf(const PastedCells& cells) const {
    const PastedNumbers numbers(cells, field().stated(), "");
    return {joinedRows(numbers.rows()), numbers.fault()};
}

QString RowsEditor::accept(const QString& text) {
    const std::optional<NumberRows> rows = rowsOf(text);
    const auto set = [this, &rows](void* to) { field().as<NumberRows>(to) = *rows; };
    if (!rows) {
        return tr("rows of %n number(s) separated by semicolons, as in 0 50; 200 80", nullptr,
                  static_cast<int>(field().count));
    }
    if (!fits(set)) {
        return path().starts_with("/machine/wheel_contact/")
                   ? tr("the forces must rise from row to row, the stiffnesses lie above 0")
                   : tr("a number is out of range");
    }
    change(set);
    return {};
}

} // namespace sparkout
