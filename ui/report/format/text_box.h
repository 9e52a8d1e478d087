// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/formula_node.h"

#include <QFont>
#include <QList>
#include <QString>
#include <QStringList>

#include <functional>

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
