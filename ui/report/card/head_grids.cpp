// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/card/head_grids.h"

#include "ui/report/card/logo.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <array>
#include <cstddef>
#include <span>

namespace sparkout::report {

namespace {

/// Cells side by side, each with its caption.
FormGrid captionedRow(std::span<const form::Cell> cells, const QStringList& values) {
    FormGrid grid;
    std::vector<FormCell>& row = grid.rows.emplace_back();
    for (std::size_t i = 0; i < cells.size(); ++i) {
        grid.widths_mm.push_back(cells[i].width_mm);
        row.push_back({form::text(cells[i].caption), values.value(static_cast<qsizetype>(i))});
    }
    return grid;
}

} // namespace

FormGrid HeadGrids::inventory() {
    FormGrid grid;
    grid.widths_mm.assign(form::inventoryWidths.begin(), form::inventoryWidths.end());
    for (std::size_t i = 0; i < 2 * form::changes.size(); ++i) {
        grid.widths_mm.push_back(form::changes.at(i % form::changes.size()).width_mm);
    }
    double taken = 0;
    for (const double width : grid.widths_mm) {
        taken += width;
    }
    const double half = (form::width - taken) / 2;
    grid.widths_mm.insert(grid.widths_mm.end(), {half, half});
    const int rows = static_cast<int>(form::inventory.size());
    for (int row = 0; row < rows; ++row) {
        std::vector<FormCell>& cells = grid.rows.emplace_back();
        cells.push_back({form::text(form::inventory.at(static_cast<std::size_t>(row)))});
        cells.resize(form::inventoryWidths.size());
        for (std::size_t i = 0; i < 2 * form::changes.size(); ++i) {
            const bool isNamed = row + 1 == rows; // below cells to be filled in by hand
            cells.push_back({isNamed
                                 ? form::text(form::changes.at(i % form::changes.size()).caption)
                                 : QString()});
        }
        if (row == 0) {
            cells.push_back({QCoreApplication::translate("CardForm", "Sheets"),
                             {},
                             1,
                             rows,
                             FormCell::Count::pages});
            cells.push_back({QCoreApplication::translate("CardForm", "Sheet"),
                             {},
                             1,
                             rows,
                             FormCell::Count::page});
        }
    }
    return grid;
}

FormGrid HeadGrids::signers(const CardHead& head) {
    FormGrid grid;
    grid.widths_mm.assign(form::signerWidths.begin(), form::signerWidths.end());
    // Columns for both rows beside the signatures: designations and names.
    grid.widths_mm.insert(grid.widths_mm.end(), {72, 48, 12, 15, 15, 15, 15});
    constexpr std::array designationColumns{1, 2, 4};
    constexpr std::array nameColumns{2, 1, 1, 1, 1, 1};
    constexpr std::size_t namesFrom = 2;
    const QStringList people = head.people();
    const QStringList designations = head.designations(), names = head.names();
    for (std::size_t row = 0; row < form::signers.size(); ++row) {
        std::vector<FormCell>& cells = grid.rows.emplace_back();
        cells.push_back({form::text(form::signers.at(row))});
        cells.push_back({{}, people.value(static_cast<qsizetype>(row))});
        cells.push_back({});
        cells.push_back(
            {{},
             row == 0 ? QLocale().toString(head.date, form::text(form::dateFormat)) : QString()});
        for (std::size_t i = 0; row == 0 && i < form::designations.size(); ++i) {
            cells.push_back({form::text(form::designations.at(i).caption),
                             designations.value(static_cast<qsizetype>(i)),
                             designationColumns.at(i), static_cast<int>(namesFrom)});
        }
        if (row == 0) {
            cells.at(form::signerWidths.size()).picture = Logo::image(head.company.logo);
        }
        for (std::size_t i = 0; row == namesFrom && i < form::names.size(); ++i) {
            cells.push_back({form::text(form::names.at(i).caption),
                             names.value(static_cast<qsizetype>(i)), nameColumns.at(i),
                             static_cast<int>(form::signers.size() - namesFrom)});
        }
    }
    return grid;
}

FormGrid HeadGrids::following(const CardHead& head) {
    FormGrid grid = captionedRow(form::continued, head.following());
    constexpr double sheet_mm = 15;
    grid.widths_mm.front() -= sheet_mm;
    grid.widths_mm.push_back(sheet_mm);
    grid.rows.front().push_back(
        {QCoreApplication::translate("CardForm", "Sheet"), {}, 1, 1, FormCell::Count::page});
    return grid;
}

FormHead HeadGrids::of(const CardHead& head, const form::Kind& kind) {
    FormHead made;
    made.number = form::text(kind.first);
    made.symbol = form::text(kind.symbol);
    made.name = form::text(kind.name);
    made.grids = {inventory(), signers(head)};
    if (&kind == &form::card) {
        made.grids.push_back(captionedRow(form::operationRow, head.operation));
        made.grids.push_back(captionedRow(form::equipmentRow, head.equipment));
    }
    made.following = following(head);
    return made;
}

} // namespace sparkout::report
