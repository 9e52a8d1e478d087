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

/// A sheet of a form as values: everything at its place on the paper, in millimetres.
namespace sparkout::report {

inline constexpr double unitsPerMm = 720 / 25.4; ///< of the page

/// The narrow type of a form, so many points high.
[[nodiscard]] QFont sheetFont(double points);

/// Of a cell in the table of a sheet; row 0 is the head.
struct TablePlace {
    int row = 0, column = 0;
    int span = 1; ///< columns that it takes
};

/// A text within its cell, in the middle of its height.
struct SheetText {
    QRectF cell;
    QString text;
    double points = 9;
    Qt::Alignment align = Qt::AlignLeft;
    /// What it is to who hears it read: a text by itself unless it is said to be a cell of the
    /// sheet's table, or its heading.
    std::optional<TablePlace> place = {};
    bool isHeading = false;

    [[nodiscard]] TextBox box() const; ///< as wrapped to the cell
    void paint(QPainter& painter) const;
};

/// The text in the largest type up to that many points in which it fits into the cell, wrapped if
/// need be; what does not fit in the smallest ends in an ellipsis.
[[nodiscard]] SheetText fitted(const QRectF& cell, const QString& text, double points,
                               Qt::Alignment align = Qt::AlignLeft);

struct SheetLine {
    QLineF line;
    double width_mm = 0.3;
    Qt::PenStyle style = Qt::SolidLine;
};

struct SheetShape {
    QPainterPath path;
    double width_mm = 0.3; ///< of its outline
    bool isFilled = false;
};

struct SheetPicture {
    QRectF cell;
    QImage image;
    QString description; ///< in words
};

/// The drawing on a sheet: which of its lines, shapes and texts, from one up to another.
struct SheetDrawing {
    struct Range {
        std::size_t from = 0, to = 0;
    };
    QString description; ///< in words
    Range lines, shapes, texts;
};

struct FormSheet {
    QString title; ///< of its entry in the outline
    std::vector<SheetText> texts;
    std::vector<SheetLine> lines;
    std::vector<SheetShape> shapes;
    std::vector<SheetPicture> pictures;
    SheetDrawing drawing; ///< empty where there is none
    int columns = 0;      ///< of the table, where there is one

    void frame(const QRectF& box, double width_mm);
    // At 720 units an inch, from the paper's corner.
    void paint(QPainter& painter) const;
    static void paintPicture(QPainter& painter, const SheetPicture& picture);
    void paintLines(QPainter& painter, SheetDrawing::Range range) const;
    void paintShapes(QPainter& painter, SheetDrawing::Range range) const;
};

} // namespace sparkout::report
