// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/text_box.h"

#include "ui/report/format/formula_box.h"

#include <QFontMetricsF>
#include <QPainter>
#include <QRegularExpression>
#include <QTextLayout>

#include <algorithm>
#include <utility>

namespace sparkout::report {

namespace {
constexpr double unitsPerPoint = 10;
constexpr QChar wordJoiner(0x2060);

/// Units and double names stay whole.
QString kept(QString paragraph) {
    for (const QChar mark : {QChar(u'/'), QChar(u'–')}) {
        paragraph.replace(mark, mark + QString(wordJoiner));
    }
    return paragraph;
}

} // namespace

void TextBox::wrap(const QString& text, double indent) {
    for (const QString& given : text.split(u'\n')) {
        double start = indent;
        if (given.isEmpty()) { // Qt 6.4 makes no line of it, and an empty one later
            m_lines += QString();
            m_goesOn += true;
            m_starts += start;
            continue;
        }
        const QString paragraph = kept(given);
        QTextLayout layout(paragraph, m_font);
        QTextOption option;
        option.setWrapMode(QTextOption::WrapAtWordBoundaryOrAnywhere);
        layout.setTextOption(option);
        layout.beginLayout();
        for (QTextLine row = layout.createLine(); row.isValid(); row = layout.createLine()) {
            row.setLineWidth(m_width - start);
            const QString line = paragraph.mid(row.textStart(), row.textLength());
            m_lines += QString(line).remove(wordJoiner).trimmed();
            m_goesOn += line.isEmpty() || line.back().isSpace();
            m_starts += start;
            start = 0;
        }
        layout.endLayout();
        m_goesOn.back() = true;
    }
    m_goesOn.back() = false;
}

TextBox::TextBox(QString text, QFont font, double width, Qt::Alignment align)
    : TextBox(std::move(text), std::move(font), width, align, Setting()) {}

TextBox::TextBox(QString text, QFont font, double width, Qt::Alignment align,
                 const Setting& setting)
    : m_font(std::move(font)), m_width(width), m_align(align) {
    const QFontMetricsF metrics(m_font);
    m_lineHeight = metrics.height() * setting.spacing;
    m_ascent = metrics.ascent() + (m_lineHeight - metrics.height()) / 2;
    wrap(text, setting.indent);
}

TextBox TextBox::part(int first, int count) const {
    TextBox box = *this;
    box.m_lines = m_lines.mid(first, count);
    box.m_goesOn = m_goesOn.mid(first, count);
    box.m_starts = m_starts.mid(first, count);
    return box;
}

void TextBox::paint(QPainter& painter, double x, double y) const {
    painter.setFont(m_font);
    const QFontMetricsF metrics(m_font);
    for (qsizetype i = 0; i < m_lines.size(); ++i) {
        const double spare = m_width - metrics.horizontalAdvance(m_lines[i]);
        const double shift = m_align & Qt::AlignRight     ? spare
                             : m_align & Qt::AlignHCenter ? spare / 2
                                                          : m_starts[i];
        const QPointF at(x + std::max(0.0, shift), y + m_ascent + double(i) * m_lineHeight);
        if (m_indices) {
            const bool isWords = m_lines[i].contains(u' '); // a radical sign covers a symbol alone
            const FormulaNode line =
                isWords ? FormulaNode{FormulaNode::Kind::text, m_lines[i], 2, 0, {}}
                        : leafNode(m_lines[i], 0);
            formulaBox(line, m_font.pixelSize() / unitsPerPoint).paint(painter, at.x(), at.y());
        } else {
            // Includes the space between words, so that a screen reader separates them.
            painter.drawText(at, m_goesOn[i] ? m_lines[i] + u' ' : m_lines[i]);
        }
    }
}

double TextBox::widestWord(const QString& text, const QFont& font) {
    static const QRegularExpression space(QStringLiteral("[ \\n]+"));
    double width = 0;
    for (const QString& word : text.split(space)) {
        width = std::max(width, QFontMetricsF(font).horizontalAdvance(word));
    }
    return width;
}

double TextBox::widestLine(const QString& text, const QFont& font) {
    double width = 0;
    for (const QString& line : text.split(u'\n')) {
        width = std::max(width, QFontMetricsF(font).horizontalAdvance(line));
    }
    return width;
}

QFont reportFont(double points, bool bold) {
    QFont font;
    font.setPixelSize(qRound(points * unitsPerPoint));
    font.setBold(bold);
    font.setHintingPreference(QFont::PreferNoHinting);
    return font;
}

} // namespace sparkout::report
