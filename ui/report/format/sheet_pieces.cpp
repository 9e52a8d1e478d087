// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/sheet_pieces.h"

#include <QPainter>

#include <algorithm>
#include <functional>
#include <map>
#include <memory>
#include <utility>

namespace sparkout::report {

namespace {

using Id = PdfStructure::Id;

/// The elements of a sheet's table: every row has a cell for each column, or one spanning several.
class SheetTable {
public:
    SheetTable(const FormSheet& sheet, PdfStructure& structure, Id parent) {
        std::map<std::pair<int, int>, int> spans; // by row and column
        for (const SheetText& text : sheet.texts) {
            if (text.place) {
                int& span = spans[{text.place->row, text.place->column}];
                span = std::max(span, text.place->span);
            }
        }
        if (spans.empty()) {
            return;
        }
        const Id table = structure.add({"Table", parent});
        for (int row = 0; row <= spans.rbegin()->first.first; ++row) {
            const Id line = structure.add({"TR", table});
            for (int column = 0; column < sheet.columns;) {
                const auto given = spans.find({row, column});
                const int span = given == spans.end() ? 1 : given->second;
                m_cells[{row, column}] =
                    structure.add({row == 0 ? "TH" : "TD", line, QString(), span});
                column += span;
            }
        }
    }
    [[nodiscard]] Id cell(const TablePlace& place) const {
        return m_cells.at({place.row, place.column});
    }

private:
    std::map<std::pair<int, int>, Id> m_cells;
};

/// The area of the drawing's lines [units of the page].
QRectF boxOf(const FormSheet& sheet) {
    QRectF box;
    for (std::size_t i = sheet.drawing.lines.from; i < sheet.drawing.lines.to; ++i) {
        const SheetLine& line = sheet.lines[i];
        const double w = line.width_mm / 2; // so that none is empty
        box |= QRectF(line.line.p1(), line.line.p2()).normalized().adjusted(-w, -w, w, w);
    }
    return {box.topLeft() * unitsPerMm, box.size() * unitsPerMm};
}

} // namespace

std::vector<Pages::Piece> sheetPieces(const FormSheet& given, PdfStructure& structure) {
    const auto sheet = std::make_shared<const FormSheet>(given);
    const SheetDrawing& drawing = sheet->drawing;
    std::vector<Pages::Piece> pieces;
    const Id section = structure.add({"Sect"});
    const auto add = [&](Id element, std::function<void(QPainter&)> paint) {
        pieces.push_back({std::move(paint), element});
    };
    const auto addText = [&](Id element, std::size_t i) {
        add(element, [sheet, i](QPainter& p) { sheet->texts[i].paint(p); });
    };
    for (std::size_t i = 0; i < sheet->texts.size(); ++i) { // at the foot, but read first
        if (sheet->texts[i].isHeading) {
            addText(structure.add({"H1", section}), i);
        }
    }
    for (std::size_t i = 0; i < sheet->pictures.size(); ++i) {
        const QRectF& cell = sheet->pictures[i].cell;
        const QRectF box(cell.topLeft() * unitsPerMm, cell.size() * unitsPerMm);
        add(structure.add({"Figure", section, sheet->pictures[i].description, 1, box}),
            [sheet, i](QPainter& p) { FormSheet::paintPicture(p, sheet->pictures[i]); });
    }
    add(PdfStructure::artifact, [sheet](QPainter& p) {
        const SheetDrawing& of = sheet->drawing;
        sheet->paintLines(p, {0, of.lines.from});
        sheet->paintLines(p, {of.lines.to, sheet->lines.size()});
        sheet->paintShapes(p, {0, of.shapes.from});
        sheet->paintShapes(p, {of.shapes.to, sheet->shapes.size()});
    });
    const auto isDrawn = [&drawing](std::size_t i) {
        return i >= drawing.texts.from && i < drawing.texts.to;
    };
    const auto addTexts = [&](bool ofTable, const SheetTable* table) {
        for (std::size_t i = 0; i < sheet->texts.size(); ++i) {
            const SheetText& text = sheet->texts[i];
            if (!text.isHeading && !isDrawn(i) && text.place.has_value() == ofTable) {
                addText(ofTable ? table->cell(*text.place) : structure.add({"P", section}), i);
            }
        }
    };
    addTexts(false, nullptr);
    const SheetTable table(*sheet, structure, section);
    addTexts(true, &table);
    if (!drawing.description.isEmpty()) {
        const Id figure = structure.add({"Figure", section, drawing.description, 1, boxOf(*sheet)});
        add(figure, [sheet](QPainter& p) {
            sheet->paintLines(p, sheet->drawing.lines);
            sheet->paintShapes(p, sheet->drawing.shapes);
            for (std::size_t i = sheet->drawing.texts.from; i < sheet->drawing.texts.to; ++i) {
                sheet->texts[i].paint(p);
            }
        });
    }
    return pieces;
}

} // namespace sparkout::report
