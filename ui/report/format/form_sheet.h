// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/text_box.h"

#include <QFont>
#include <QImage>
#include <QLineF>
#include <QPainterPath>
#include <QRectF>
#include <QString>

#include <vector>

class QPainter;

/// A sheet of a form as values: everything at its place on the paper, in millimetres.
namespace sparkout::report {

inline constexpr double unitsPerMm = 720 / 25.4; ///< of the page

/// The narrow type of a form, so many points high.
[[nodiscard]] QFont sheetFont(double points);

/// A text within its cell, in the middle of its height.
struct SheetText {
    QRectF cell;
    QString text;
    double points = 9;
    Qt::Alignment align = Qt::AlignLeft;

    [[nodiscard]] TextBox box() const; ///< as wrapped to the cell
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
};

struct FormSheet {
    QString title; ///< of its entry in the outline
    std::vector<SheetText> texts;
    std::vector<SheetLine> lines;
    std::vector<SheetShape> shapes;
    std::vector<SheetPicture> pictures;

    void frame(const QRectF& box, double width_mm);
    void paint(QPainter& painter) const; ///< at 720 units an inch, from the paper's corner
};

} // namespace sparkout::report
