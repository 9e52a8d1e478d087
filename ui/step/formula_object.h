// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/text_box.h"

#include <QObject>
#include <QTextCharFormat>
#include <QTextObjectInterface>

#include <vector>

namespace sparkout {

/// Typeset pieces of formulas within a text. Their vertical middle is the axis, the height of a
/// minus sign, so that all pieces of a line share a base line.
class FormulaObject : public QObject, public QTextObjectInterface {
    Q_OBJECT
    Q_INTERFACES(QTextObjectInterface)

public:
    static constexpr int type = QTextFormat::UserObject + 1;

    explicit FormulaObject(QObject* parent) : QObject(parent) {}

    void clear() { m_pieces.clear(); }
    /// The format of the character that represents a piece; `text` is its one-line form.
    [[nodiscard]] QTextCharFormat add(const report::FormulaNode& node, const QString& text);
    [[nodiscard]] static QString textOf(const QTextFormat& format);
    void setPixels(double fontSize) { m_pixels = fontSize; } ///< font size of the text
    void setRoom(double width) { m_room = width; }           ///< a wider piece is pressed together

    QSizeF intrinsicSize(QTextDocument* document, int position, const QTextFormat& format) override;
    void drawObject(QPainter* painter, const QRectF& rect, QTextDocument* document, int position,
                    const QTextFormat& format) override;

private:
    [[nodiscard]] const report::FormulaBox& piece(const QTextFormat& format) const;
    [[nodiscard]] double scaleOf(const report::FormulaBox& box) const;
    [[nodiscard]] static double halfHeight(const report::FormulaBox& box);

    std::vector<report::FormulaBox> m_pieces;
    double m_pixels = 12;
    double m_room = 1e6;
};

} // namespace sparkout
