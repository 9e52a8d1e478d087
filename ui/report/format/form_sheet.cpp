// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/form_sheet.h"

#include <QColor>
#include <QFontMetricsF>
#include <QPainter>
#include <QStringList>

#include <algorithm>

namespace sparkout::report {

namespace {

constexpr QColor formInk(0, 0, 0);
constexpr double leastType = 5, typeStep = 0.5;

QRectF scaled(const QRectF& mm) {
    return {mm.topLeft() * unitsPerMm, mm.size() * unitsPerMm};
}

bool fits(const SheetText& text) {
    const TextBox box = text.box();
    return box.height() <= text.cell.height() * unitsPerMm
           && TextBox::widestWord(text.text, box.font()) <= text.cell.width() * unitsPerMm;
}

} // namespace

QFont sheetFont(double points) {
    QFont font = reportFont(points);
    font.setFamilies({QStringLiteral("DejaVu Sans Condensed"),
                      QStringLiteral("Liberation Sans Narrow"), QStringLiteral("Arial Narrow"),
                      QStringLiteral("DejaVu Sans"), font.family()});
    return font;
}

TextBox SheetText::box() const {
    return {text, sheetFont(points), cell.width() * unitsPerMm, align};
}

SheetText fitted(const QRectF& cell, const QString& text, double points, Qt::Alignment align) {
    SheetText made{cell, text, points, align};
    while (!fits(made) && made.points > leastType) {
        made.points = std::max(leastType, made.points - typeStep);
    }
    const TextBox box = made.box();
    const double height = QFontMetricsF(box.font()).height();
    const int room = std::max(1, static_cast<int>(cell.height() * unitsPerMm / height));
    if (box.lines() > room) {
        QStringList lines = box.texts().mid(0, room);
        lines.last() =
            QFontMetricsF(box.font())
                .elidedText(lines.last() + QChar(u'…'), Qt::ElideRight, cell.width() * unitsPerMm);
        made.text = lines.join(u'\n');
    }
    return made;
}

void FormSheet::frame(const QRectF& box, double width_mm) {
    for (const QLineF& side :
         {QLineF(box.topLeft(), box.topRight()), QLineF(box.topRight(), box.bottomRight()),
          QLineF(box.bottomRight(), box.bottomLeft()), QLineF(box.bottomLeft(), box.topLeft())}) {
        lines.push_back({side, width_mm});
    }
}

void SheetText::paint(QPainter& painter) const {
    const TextBox wrapped = box();
    const QRectF at = scaled(cell);
    painter.setPen(formInk);
    wrapped.paint(painter, at.left(), at.center().y() - wrapped.height() / 2);
}

void FormSheet::paintPicture(QPainter& painter, const SheetPicture& picture) {
    const QRectF cell = scaled(picture.cell);
    QSizeF size = picture.image.size();
    size.scale(cell.size(), Qt::KeepAspectRatio);
    painter.drawImage(
        QRectF(cell.left(), cell.center().y() - size.height() / 2, size.width(), size.height()),
        picture.image);
}

void FormSheet::paintLines(QPainter& painter, SheetDrawing::Range range) const {
    for (std::size_t i = range.from; i < range.to; ++i) {
        const SheetLine& line = lines[i];
        QPen pen(formInk, line.width_mm * unitsPerMm, Qt::SolidLine, Qt::SquareCap);
        if (line.style == Qt::DashDotLine) { // in pen widths: a centre line
            constexpr double dash_mm = 8, gap_mm = 1.2, dot_mm = 0.6;
            pen.setCapStyle(Qt::FlatCap);
            pen.setDashPattern({dash_mm / line.width_mm, gap_mm / line.width_mm,
                                dot_mm / line.width_mm, gap_mm / line.width_mm});
        }
        painter.setPen(pen);
        painter.drawLine(QLineF(line.line.p1() * unitsPerMm, line.line.p2() * unitsPerMm));
    }
}

void FormSheet::paintShapes(QPainter& painter, SheetDrawing::Range range) const {
    for (std::size_t i = range.from; i < range.to; ++i) {
        const SheetShape& shape = shapes[i];
        painter.setPen(shape.width_mm > 0 ? QPen(formInk, shape.width_mm * unitsPerMm)
                                          : QPen(Qt::NoPen));
        painter.setBrush(shape.isFilled ? QBrush(formInk) : QBrush());
        painter.drawPath(QTransform::fromScale(unitsPerMm, unitsPerMm).map(shape.path));
    }
}

void FormSheet::paint(QPainter& painter) const {
    for (const SheetPicture& picture : pictures) {
        paintPicture(painter, picture);
    }
    paintLines(painter, {0, lines.size()});
    paintShapes(painter, {0, shapes.size()});
    for (const SheetText& text : texts) {
        text.paint(painter);
    }
}

} // namespace sparkout::report
