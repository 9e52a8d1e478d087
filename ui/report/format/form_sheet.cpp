// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/form_sheet.h"

#include <QColor>
#include <QFontMetricsF>
#include <QPainter>
#include <QPainterPath>
#include <QRegularExpression>
#include <QStringList>
#include <QTextLayout>

#include <algorithm>
#include <utility>

namespace sparkout::report {

namespace {

using BoxKind = FormulaNode::Kind;

constexpr double scriptShare = 0.7;  ///< size of indices and exponents
constexpr double nestedShare = 0.85; ///< size of fractions
constexpr double leastPoints = 5.5;
constexpr double barShare = 0.06; ///< thickness of lines, relative to the font's size
constexpr double fontUnits = 10;

double smaller(double points, double share) {
    return std::max(leastPoints, points * share);
}

FormulaBox textPart(const QString& text, double points) {
    const QFont font = reportFont(points);
    const QFontMetricsF metrics(font);
    return {metrics.horizontalAdvance(text), metrics.ascent(), metrics.descent(),
            [text, font](QPainter& p, double x, double base) {
                p.setFont(font);
                p.drawText(QPointF(x, base), text);
            }};
}

FormulaBox moved(FormulaBox box, double down) {
    box.ascent -= down;
    box.descent += down;
    return {box.width, box.ascent, box.descent,
            [inner = box.paint, down](QPainter& p, double x, double base) {
                inner(p, x, base + down);
            }};
}

FormulaBox beside(std::vector<FormulaBox> boxes) {
    FormulaBox row;
    for (const FormulaBox& box : boxes) {
        row.width += box.width;
        row.ascent = std::max(row.ascent, box.ascent);
        row.descent = std::max(row.descent, box.descent);
    }
    row.paint = [boxes = std::move(boxes)](QPainter& p, double x, double base) {
        for (const FormulaBox& box : boxes) {
            box.paint(p, x, base);
            x += box.width;
        }
    };
    return row;
}

/// "k_s" with a lowered index.
FormulaBox symbolBox(const QString& text, double points) {
    static const QRegularExpression index(QStringLiteral("_(\\w+)"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    std::vector<FormulaBox> boxes;
    qsizetype from = 0;
    for (auto it = index.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        boxes.push_back(textPart(text.mid(from, match.capturedStart() - from), points));
        boxes.push_back(moved(textPart(match.captured(1), smaller(points, scriptShare)),
                              QFontMetricsF(reportFont(points)).descent() * 0.7));
        from = match.capturedEnd();
    }
    if (from < text.size()) {
        boxes.push_back(textPart(text.mid(from), points));
    }
    return beside(std::move(boxes));
}

void drawBar(QPainter& p, QPointF from, QPointF to, double thickness) {
    p.save();
    QPen pen(p.pen().color(), thickness);
    p.setPen(pen);
    p.drawLine(from, to);
    p.restore();
}

FormulaBox fractionBox(const FormulaNode& node, double points) {
    const double inner = smaller(points, nestedShare);
    const FormulaBox above = formulaBox(node.parts.front(), inner);
    const FormulaBox below = formulaBox(node.parts.back(), inner);
    const double size = points * fontUnits;
    const double axis = QFontMetricsF(reportFont(points)).xHeight() / 2;
    const double gap = size * 0.12, pad = size * 0.15;
    const double width = std::max(above.width, below.width) + 2 * pad;
    return {width + 2 * pad, axis + gap + above.ascent + above.descent,
            below.ascent + below.descent + gap - axis, [=](QPainter& p, double x, double base) {
                x += pad;
                const double bar = base - axis;
                drawBar(p, {x, bar}, {x + width, bar}, size * barShare);
                above.paint(p, x + (width - above.width) / 2, bar - gap - above.descent);
                below.paint(p, x + (width - below.width) / 2, bar + gap + below.ascent);
            }};
}

FormulaBox rootBox(const FormulaNode& node, double points) {
    const FormulaBox inside = formulaBox(node.parts.front(), points);
    const double size = points * fontUnits;
    const double hook = size * 0.6, gap = size * 0.08;
    const double top = inside.ascent + gap, bottom = inside.descent;
    const FormulaBox degree = node.degree == 2
                                  ? FormulaBox{0, 0, 0, [](QPainter&, double, double) {}}
                                  : textPart(QString::number(node.degree), points * 0.55);
    const double shift = std::max(0.0, degree.width - hook * 0.45);
    return {shift + hook + inside.width + gap, top + size * barShare, bottom,
            [=](QPainter& p, double x, double base) {
                degree.paint(p, x, base - size * 0.35);
                x += shift;
                p.save();
                p.setPen(QPen(p.pen().color(), size * barShare, Qt::SolidLine, Qt::FlatCap,
                              Qt::MiterJoin));
                p.setBrush(Qt::NoBrush);
                p.drawPolyline(QPolygonF{QPointF(x + hook * 0.1, base - size * 0.25),
                                         QPointF(x + hook * 0.3, base - size * 0.32),
                                         QPointF(x + hook * 0.6, base + bottom - gap),
                                         QPointF(x + hook * 0.95, base - top),
                                         QPointF(x + hook + inside.width + gap, base - top)});
                p.restore();
                inside.paint(p, x + hook, base);
            }};
}

FormulaBox powerBox(const FormulaNode& node, double points) {
    const FormulaBox base = formulaBox(node.parts.front(), points);
    const FormulaBox exponent = textPart(node.parts.back().text, smaller(points, scriptShare));
    const double lift = std::max(points * fontUnits * 0.35, base.ascent - exponent.ascent * 0.8);
    return beside({base, moved(exponent, -lift)});
}

/// Parentheses as high as their contents.
FormulaBox fencedBox(const FormulaNode& node, double points) {
    const FormulaBox inside = formulaBox(node.parts.front(), points);
    const FormulaBox plain = textPart(QStringLiteral("("), points);
    if (inside.ascent + inside.descent < 1.25 * (plain.ascent + plain.descent)) {
        return beside({plain, inside, textPart(QStringLiteral(")"), points)});
    }
    const double size = points * fontUnits, width = size * 0.4;
    return {inside.width + 2 * width, inside.ascent, inside.descent,
            [=](QPainter& p, double x, double base) {
                p.save();
                p.setPen(QPen(p.pen().color(), size * barShare));
                p.setBrush(Qt::NoBrush);
                const double top = base - inside.ascent, end = base + inside.descent;
                for (const auto& [at, side] : {std::pair(x + width * 0.9, -1.0),
                                               std::pair(x + inside.width + width * 1.1, 1.0)}) {
                    QPainterPath path(QPointF(at, top));
                    path.quadTo(at + side * width * 1.1, (top + end) / 2, at, end);
                    p.drawPath(path);
                }
                p.restore();
                inside.paint(p, x + width, base);
            }};
}

} // namespace

FormulaBox formulaBox(const FormulaNode& node, double points) {
    switch (node.kind) {
    case BoxKind::text:
    case BoxKind::sign: return symbolBox(node.text, points);
    case BoxKind::row: {
        std::vector<FormulaBox> boxes;
        for (const FormulaNode& part : node.parts) {
            boxes.push_back(formulaBox(part, points));
        }
        return beside(std::move(boxes));
    }
    case BoxKind::fraction: return fractionBox(node, points);
    case BoxKind::root: return rootBox(node, points);
    case BoxKind::power: return powerBox(node, points);
    case BoxKind::fenced: return fencedBox(node, points);
    }
    return {};
}

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
        if (given.isEmpty()) { // Qt 6.4 creates no line for it, later versions an empty one
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
