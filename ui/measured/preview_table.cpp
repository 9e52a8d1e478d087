// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/preview_table.h"

#include "ui/measured/measured_text.h"
#include "ui/text/texts.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace sparkout {

namespace {

constexpr std::size_t previewRows = 50;
constexpr std::size_t columnsAtMost = 200;
constexpr std::size_t bytesOfCell = 60;

QString textOf(std::string_view cell) {
    return printableText(QString::fromUtf8(cell.substr(0, bytesOfCell)));
}

/// The cells of a line with their faults.
std::vector<ValueCell> cellsOf(const std::vector<std::string_view>& cells,
                               const CellFaults& ofLine) {
    std::vector<ValueCell> shown;
    for (const std::string_view cell : cells) {
        const std::size_t column = shown.size() + 1;
        if (column > columnsAtMost) {
            break;
        }
        const auto fault = std::ranges::find_if(ofLine, [column](const CellFault& each) {
            return each.column == 0 || each.column == column;
        });
        shown.push_back({.text = textOf(cell),
                         .fault = fault == ofLine.end() ? QString() : MeasuredText::fault(*fault)});
    }
    return shown;
}

CellFaults faultsOf(const CellFaults& faults, std::size_t line) {
    CellFaults of;
    std::ranges::copy_if(faults, std::back_inserter(of),
                         [line](const CellFault& fault) { return fault.line == line; });
    return of;
}

} // namespace

ValueTable previewTable(std::string_view text, const MeasuredTable& table,
                        const CellFaults& faults) {
    ValueTable shown;
    TableReader rows(text, table.dialect.delimiter);
    if (!table.isKeyValue && rows.next()) {
        for (ValueCell& head : cellsOf(rows.cells(), {})) {
            shown.columns.push_back({.text = std::move(head.text), .isText = true});
        }
    }
    std::size_t columns = shown.columns.size();
    while (shown.rows.size() < previewRows && rows.next()) {
        std::vector<ValueCell> cells = cellsOf(rows.cells(), faultsOf(faults, rows.line()));
        columns = std::max(columns, cells.size());
        shown.addRow({.text = QString::number(rows.line())}, std::move(cells));
    }
    shown.columns.resize(columns, {.isText = true});
    for (std::size_t i = 0; i < shown.columns.size(); ++i) {
        if (shown.columns[i].text.isEmpty()) {
            shown.columns[i].text = QString::number(i + 1);
        }
    }
    for (std::vector<ValueCell>& cells : shown.cells) {
        cells.resize(shown.columns.size());
    }
    return shown;
}

} // namespace sparkout
