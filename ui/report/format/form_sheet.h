// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/text_box.h"

#include <QFont>
#include <QImage>
#include <QLineF>
#include <QPainterPath>
#include <QRectF>
#include <QString>

#include <cstddef>
#include <optional>
#include <vector>

class QPainter;

/// A sheet of a form as values: everything with its position on the paper, in millimetres.
namespace sparkout::report {

inline constexpr double unitsPerMm = 720 / 25.4; ///< units of the page

/// The narrow font of a form with a size in points.
[[nodiscard]] QFont sheetFont(double points);

/// The position of a cell in the table of a sheet; row 0 is the head.
struct TablePlace {
    int row = 0, column = 0;
    int span = 1; ///< number of columns
};

/// A text within its cell, vertically centred.
struct SheetText {
    QRectF cell;
    QString text;
    double points = 9;
    Qt::Alignment align = Qt::AlignLeft;
    /// Its role for a screen reader: a text by itself, a cell of the sheet's table, or its heading.
    std::optional<TablePlace> place = {};
    bool isHeading = false;

    [[nodiscard]] TextBox box() const; ///< wrapped to the cell
    void paint(QPainter& painter) const;
};

/// The text in the largest font up to this size in which it fits into the cell, wrapped if needed;
/// a text too long for the smallest size ends in an ellipsis.
[[nodiscard]] SheetText fitted(const QRectF& cell, const QString& text, double points,
                               Qt::Alignment align = Qt::AlignLeft);

struct SheetLine {
    QLineF line;
    double width_mm = 0.3;
    Qt::PenStyle style = Qt::SolidLine;
};

struct SheetShape {
    QPainterPath path;
    double width_mm = 0.3; ///< width of its outline
    bool isFilled = false;
};

struct SheetPicture {
    QRectF cell;
    QImage image;
    QString description; ///< in words
};

/// The drawing on a sheet: ranges of its lines, shapes and texts.
struct SheetDrawing {
    struct Range {
        std::size_t from = 0, to = 0;
    };
    QString description; ///< in words
    Range lines, shapes, texts;
};

struct FormSheet {
    QString title; ///< title in the outline
    std::vector<SheetText> texts;
    std::vector<SheetLine> lines;
    std::vector<SheetShape> shapes;
    std::vector<SheetPicture> pictures;
    SheetDrawing drawing; ///< may be empty
    int columns = 0;      ///< columns of the table, if there is one

    void frame(const QRectF& box, double width_mm);
    // At 720 units per inch, from the paper's corner.
    void paint(QPainter& painter) const;
    static void paintPicture(QPainter& painter, const SheetPicture& picture);
    void paintLines(QPainter& painter, SheetDrawing::Range range) const;
    void paintShapes(QPainter& painter, SheetDrawing::Range range) const;
};

} // namespace sparkout::report
