// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/step/formula_object.h"

#include "ui/report/format/text_box.h"

#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>

namespace sparkout {

namespace {

constexpr double boxPoints = 10; ///< the boxes are laid out in this size and scaled
constexpr int numberProperty = QTextFormat::UserProperty + 1;
constexpr int textProperty = QTextFormat::UserProperty + 2;
constexpr double leastScale = 0.6; ///< least legible scale of a compressed formula

double axisHeight() {
    return QFontMetricsF(report::reportFont(boxPoints)).xHeight() / 2;
}

} // namespace

QTextCharFormat FormulaObject::add(const report::FormulaNode& node, const QString& text) {
    QTextCharFormat format;
    format.setObjectType(type);
    format.setProperty(numberProperty, int(m_pieces.size()));
    format.setProperty(textProperty, text);
    format.setVerticalAlignment(QTextCharFormat::AlignMiddle);
    m_pieces.push_back(report::formulaBox(node, boxPoints));
    return format;
}

QString FormulaObject::textOf(const QTextFormat& format) {
    return format.property(textProperty).toString();
}

const report::FormulaBox& FormulaObject::piece(const QTextFormat& format) const {
    return m_pieces[std::size_t(format.property(numberProperty).toInt())];
}

double FormulaObject::scaleOf(const report::FormulaBox& box) const {
    const double usual = m_pixels / report::reportFont(boxPoints).pixelSize();
    return std::clamp(m_room / std::max(box.width, 1.0), usual * leastScale, usual);
}

double FormulaObject::halfHeight(const report::FormulaBox& box) {
    return std::max(box.ascent - axisHeight(), box.descent + axisHeight());
}

QSizeF FormulaObject::intrinsicSize(QTextDocument*, int, const QTextFormat& format) {
    const report::FormulaBox& box = piece(format);
    return QSizeF(box.width, 2 * halfHeight(box)) * scaleOf(box);
}

void FormulaObject::drawObject(QPainter* painter, const QRectF& rect, QTextDocument*, int,
                               const QTextFormat& format) {
    const report::FormulaBox& box = piece(format);
    painter->save();
    painter->translate(rect.topLeft());
    const double scale = scaleOf(box);
    painter->scale(scale, scale);
    painter->setRenderHint(QPainter::Antialiasing);
    box.paint(*painter, 0, halfHeight(box) + axisHeight());
    painter->restore();
}

} // namespace sparkout
