// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/operation_card_report.h"

#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/setup/setup_file.h"
#include "ui/report/cell_text.h"
#include "ui/report/format/report.h"
#include "ui/report/logo.h"
#include "ui/report/operation_setup.h"
#include "ui/report/sketch_sheet.h"
#include "ui/session/project_io.h"
#include "ui/text/example_texts.h"
#include "ui/text/number_text.h"

#include <QLocale>
#include <QPainter>
#include <QStringList>

#include <array>
#include <cstddef>
#include <span>
#include <utility>

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

FormGrid inventoryGrid() {
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

FormGrid signersGrid(const CardHead& head) {
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

FormGrid followingGrid(const CardHead& head) {
    FormGrid grid = captionedRow(form::continued, head.following());
    constexpr double sheet_mm = 15;
    grid.widths_mm.front() -= sheet_mm;
    grid.widths_mm.push_back(sheet_mm);
    grid.rows.front().push_back(
        {QCoreApplication::translate("CardForm", "Sheet"), {}, 1, 1, FormCell::Count::page});
    return grid;
}

/// The head of card and sketch as cells, for an editable text; the sheets draw it with lines.
FormHead headGrids(const CardHead& head, const form::Kind& kind) {
    FormHead made;
    made.number = form::text(kind.first);
    made.symbol = form::text(kind.symbol);
    made.name = form::text(kind.name);
    made.grids = {inventoryGrid(), signersGrid(head)};
    if (&kind == &form::card) {
        made.grids.push_back(captionedRow(form::operationRow, head.operation));
        made.grids.push_back(captionedRow(form::equipmentRow, head.equipment));
    }
    made.following = followingGrid(head);
    return made;
}

constexpr double figureUnitsPerMm = 820.0 / 260; ///< as wide as the other figures

} // namespace

CardHead OperationCardReport::head(const Setup& setup, const OperationCard& card,
                                   const Company& company, const QDate& date) {
    const Project& project = setup.surfaces.front().project;
    CardHead head;
    const CardEntries& entries = *project.card;
    head.company = company.with(entries);
    head.letter = oneLine(entries.letter);
    head.part = manyLines(exampleTitle(project.part->name)).simplified();
    head.author = oneLine(project.author);
    head.date = date;
    const QString hardness =
        project.material->hardness_hrc
            ? QStringLiteral("HRC ") + printedNumber(*project.material->hardness_hrc)
            : QString();
    const auto mass = [](const std::optional<double>& value_kg) {
        return value_kg ? printedNumber(*value_kg) : QString();
    };
    head.operation = {CardRows::operation(setup),
                      oneLine(project.material->grade),
                      hardness,
                      tr("kg"),
                      mass(entries.mass_kg),
                      oneLine(entries.blank),
                      mass(entries.blank_mass_kg),
                      QStringLiteral("1")};
    const auto time = [&card](double PieceTime::*value) {
        return card.time ? CardRows::minutes((*card.time).*value) : QString();
    };
    const auto given = [](const QString& text, bool isGiven) { return isGiven ? text : QString(); };
    const bool auxiliary = card.time && card.time->auxiliary_min > 0;
    head.equipment = {
        oneLine(project.machine->name),
        oneLine(entries.program),
        time(&PieceTime::main_min),
        given(time(&PieceTime::auxiliary_min), auxiliary),
        given(time(&PieceTime::preparation_min), card.time && card.time->preparation_min > 0),
        given(time(&PieceTime::piece_min), card.time && card.time->isPieceEntered),
        oneLine(project.coolant)};
    return head;
}

FormHead OperationCardReport::formHead(const CardHead& head, const form::Kind& kind) {
    FormHead made = headGrids(head, kind);
    made.entries = entries(head);
    return made;
}

std::vector<std::pair<QString, QString>> OperationCardReport::entries(const CardHead& head) {
    std::vector<std::pair<QString, QString>> all;
    const auto add = [&all](const char* caption, const QString& value) {
        if (!value.isEmpty()) {
            all.emplace_back(form::text(caption), value);
        }
    };
    add(form::names.front().caption, head.part);
    const QStringList designations = head.designations(), names = head.names();
    for (std::size_t i = 0; i < form::designations.size(); ++i) {
        add(form::designations.at(i).caption, designations.value(static_cast<qsizetype>(i)));
    }
    for (std::size_t i = 1; i < form::names.size(); ++i) {
        add(form::names.at(i).caption, names.value(static_cast<qsizetype>(i)));
    }
    for (std::size_t i = 0; i < form::operationRow.size(); ++i) {
        add(form::operationRow.at(i).caption, head.operation.value(static_cast<qsizetype>(i)));
    }
    for (std::size_t i = 0; i < form::equipmentRow.size(); ++i) {
        add(form::equipmentRow.at(i).caption, head.equipment.value(static_cast<qsizetype>(i)));
    }
    for (std::size_t i = 0; i < form::signers.size(); ++i) {
        add(form::signers.at(i), head.people().value(static_cast<qsizetype>(i)));
    }
    return all;
}

Table OperationCardReport::table(const std::vector<CardRow>& rows) {
    Table table;
    for (const form::Cell& column : form::columns) {
        table.head << form::text(column.caption);
        table.widths.push_back(column.width_mm);
    }
    table.texts = {true, true};
    table.spread = {form::contentColumn, form::mainColumn};
    for (const CardRow& row : rows) {
        QStringList cells{cell(row.symbol), row.text};
        for (std::size_t i = form::firstValue; i < form::mainColumn; ++i) {
            cells << cell(row.cells.value(static_cast<qsizetype>(i - form::firstValue)));
        }
        table.rows.push_back(cells << cell(row.main) << cell(row.auxiliary));
    }
    return table;
}

namespace {

/// A report with all surfaces as its inputs.
Report begun(const QString& title, const Setup& setup, const QString& file, const QDate& date) {
    Report report = begunReport(title, setup.surfaces.front().project, file, date);
    report.inputs = inputsText(setup);
    return report;
}

} // namespace

Report OperationCardReport::write(const Setup& setup, const SetupRun& run, const Company& company,
                                  const QString& file, const QDate& date) {
    const OperationCard card = operationCard(setup, run);
    const std::vector<CardRow> rows = CardRows::of(card, setup, run);
    const CardHead head = OperationCardReport::head(setup, card, company, date);
    Report report = begun(tr("Operation card"), setup, file, date);
    report.blocks = {formHead(head, form::card), table(rows),
                     Paragraph{form::text(form::card.note)}};
    constexpr std::size_t sketches = 1;
    report.sheets = CardSheets(head).card(rows, sketches);
    addSketch(report, head, setup);
    return report;
}

Report OperationCardReport::sketch(const Setup& setup, const Company& company, const QString& file,
                                   const QDate& date) {
    Report report = begun(tr("Sketch sheet"), setup, file, date);
    const CardHead head = OperationCardReport::head(setup, {}, company, date);
    addSketch(report, head, setup);
    return report;
}

void OperationCardReport::addSketch(Report& report, const CardHead& head, const Setup& setup) {
    const int number = static_cast<int>(report.sheets.size()) + 1; // the last sheet of the document
    FormSheet sheet = CardSheets(head).sketch(number, number);
    SketchSheet::draw(sheet, CardSheets::sketchRoom(true), setup);
    report.sheets.push_back(std::move(sheet));
    const bool isAlone = report.blocks.empty(); // otherwise the card's head has these facts
    report.blocks.push_back(isAlone ? formHead(head, form::sketch) : headGrids(head, form::sketch));
    FormSheet figure;
    constexpr double width = 260, height = 150; // mm
    SketchSheet::draw(figure, {0, 0, width, height}, setup);
    report.blocks.push_back(
        Figure{form::text(form::sketch.name), SketchSheet::description(setup),
               QSizeF(width, height) * figureUnitsPerMm, [figure](QPainter& painter) {
                   painter.scale(figureUnitsPerMm / unitsPerMm, figureUnitsPerMm / unitsPerMm);
                   figure.paint(painter);
               }});
    report.blocks.push_back(Paragraph{form::text(form::sketch.note)});
}

} // namespace sparkout::report
