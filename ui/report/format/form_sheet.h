// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/formula_node.h"

#include <QFont>
#include <QImage>
#include <QLineF>
#include <QList>
#include <QPainterPath>
#include <QRectF>
#include <QString>
#include <QStringList>

#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

class QPainter;

namespace sparkout::report {

/// A typeset expression relative to its base line [units of the page].
struct FormulaBox {
    double width = 0;
    double ascent = 0; ///< above the base line
    double descent = 0;
    std::function<void(QPainter&, double x, double base)> paint;
};

/// In a font of this size in points: fractions with a bar, roots with a roof, lowered indices.
[[nodiscard]] FormulaBox formulaBox(const FormulaNode& node, double points);

/// A text wrapped to a width: between words, or within a word that is wider. Independent of any
/// device: the font's size is in units of the page.
class TextBox {
public:
    /// The setting of its lines.
    struct Setting {
        double indent = 0;  ///< indent of the first line of a paragraph
        double spacing = 1; ///< in line heights
    };

    TextBox(QString text, QFont font, double width, Qt::Alignment align = Qt::AlignLeft);
    TextBox(QString text, QFont font, double width, Qt::Alignment align, const Setting& setting);

    [[nodiscard]] double height() const { return m_lineHeight * double(m_lines.size()); }
    [[nodiscard]] int lines() const { return static_cast<int>(m_lines.size()); }
    [[nodiscard]] double width() const { return m_width; }
    [[nodiscard]] const QFont& font() const { return m_font; }
    [[nodiscard]] const QStringList& texts() const { return m_lines; } ///< line by line
    /// The lines from one on, with this count.
    [[nodiscard]] TextBox part(int first, int count) const;
    /// Paints "k_s" with a lowered index.
    void showIndices() { m_indices = true; }
    void paint(QPainter& painter, double x, double y) const;

    [[nodiscard]] static double widestWord(const QString& text, const QFont& font);
    [[nodiscard]] static double widestLine(const QString& text, const QFont& font);

private:
    void wrap(const QString& text, double indent);

    QFont m_font;
    double m_width;
    Qt::Alignment m_align;
    double m_lineHeight;
    double m_ascent;
    QStringList m_lines;
    QList<bool> m_goesOn;   ///< by line: it ends with a word, and the text continues
    QList<double> m_starts; ///< left ends of the lines
    bool m_indices = false;
};

/// The font of the report with a size in points on paper.
[[nodiscard]] QFont reportFont(double points, bool bold = false);

} // namespace sparkout::report

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
