// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/page_flow.h"

#include "ui/report/formula_box.h"
#include "ui/report/text_box.h"

#include <QCoreApplication>
#include <QPainter>

#include <algorithm>
#include <memory>
#include <numeric>

namespace sparkout::report {

namespace {

// Sizes in tenths of a point, fonts in points.
constexpr double bodySize = 9, smallSize = 7.5, headingSize = 11, titleSize = 15;
constexpr double gap = 60, cellPad = 30, rowPad = 14, line = 5;
constexpr QColor rule(150, 150, 150), shade(236, 236, 236), printInk(0, 0, 0),
    printFaint(90, 90, 90);
constexpr double headingRoom = 300; ///< for a heading, or the caption of a figure
constexpr double formulaSize = 9.5, formulaIndent = 120, labelRoom = 260;
constexpr double leastLines = 3; ///< that follow a heading on its page

struct PageText {
    Q_DECLARE_TR_FUNCTIONS(PageText)
public:
    static QString number(int page, int count) { return tr("page %1 of %2").arg(page).arg(count); }
};

/// Widths of the columns that fill the page: each at least its longest word, or its longest number
/// with all that belongs to it, the rest by need.
std::vector<double> columnWidths(const Table& table, double width, bool wholeNumbers = true) {
    const auto columns = static_cast<std::size_t>(table.head.size());
    std::vector<double> least(columns), wanted(columns);
    const auto measure = [&](const QStringList& cells, const QFont& font, bool head) {
        for (std::size_t c = 0; c < columns; ++c) {
            const QString& text = cells[static_cast<qsizetype>(c)];
            const bool isText = head || (c < table.texts.size() && table.texts[c]);
            const double whole = TextBox::widestLine(text, font);
            const double word = wholeNumbers && !isText ? whole : TextBox::widestWord(text, font);
            least[c] = std::max(least[c], word + 2 * cellPad);
            wanted[c] = std::max(wanted[c], whole + 2 * cellPad);
        }
    };
    for (const QStringList& row : table.rows) {
        measure(row, reportFont(bodySize, table.lastIsSum && &row == &table.rows.back()), false);
    }
    measure(table.head, reportFont(smallSize, true), true);
    const double sumLeast = std::accumulate(least.begin(), least.end(), 0.0);
    const double sumWanted = std::accumulate(wanted.begin(), wanted.end(), 0.0);
    if (wholeNumbers && sumLeast > width) {
        return columnWidths(table, width, false);
    }
    std::vector<double> widths(columns);
    for (std::size_t c = 0; c < columns; ++c) {
        if (sumLeast >= width) {
            widths[c] = least[c] * width / sumLeast;
        } else if (sumWanted <= width) {
            widths[c] = wanted[c] * width / sumWanted;
        } else {
            widths[c] =
                least[c]
                + (wanted[c] - least[c]) * (width - sumLeast) / std::max(1.0, sumWanted - sumLeast);
        }
    }
    return widths;
}

double rowHeight(const QStringList& cells, const std::vector<double>& widths, const QFont& font) {
    double height = 0;
    for (std::size_t c = 0; c < widths.size(); ++c) {
        const TextBox box(cells[static_cast<qsizetype>(c)], font, widths[c] - 2 * cellPad);
        height = std::max(height, box.height());
    }
    return height + 2 * rowPad;
}

} // namespace

PageFlow::PageFlow(const Report& report, QSizeF area, const KeepGoing& keepGoing)
    : m_report(report)
    , m_area(area)
    , m_top(2 * smallSize * 10 + gap / 2)
    , m_bottom(area.height() - 2 * smallSize * 10 - gap / 2) {
    newPage();
    addTitle();
    for (std::size_t i = 0; i < report.blocks.size(); ++i) {
        if (std::holds_alternative<Heading>(report.blocks[i]) && i + 1 < report.blocks.size()) {
            need(headingRoom + together(report.blocks[i + 1]));
        }
        std::visit(*this, report.blocks[i]);
        if (!keepGoing(double(i + 1) / double(report.blocks.size()))) {
            break;
        }
    }
    addMargins();
}

void PageFlow::newPage() {
    m_pages.emplace_back();
    m_y = m_top;
}

void PageFlow::need(double height) {
    if (height > room() && m_y > m_top) {
        newPage();
    }
}

void PageFlow::addTitle() {
    const TextBox title(m_report.title, reportFont(titleSize, true), m_area.width());
    add([title, y = m_y](QPainter& p) { title.paint(p, 0, y); });
    m_y += title.height() + gap / 2;
}

void PageFlow::operator()(const Heading& heading) {
    const TextBox box(heading.text, reportFont(headingSize, true), m_area.width());
    m_y += m_y > m_top ? gap : 0;
    need(box.height());
    m_marks.push_back({heading.text, static_cast<int>(m_pages.size()) - 1, m_y});
    add([box, y = m_y](QPainter& p) { box.paint(p, 0, y); });
    m_y += box.height() + gap / 3;
}

void PageFlow::operator()(const Paragraph& paragraph) {
    const TextBox box(paragraph.text, reportFont(bodySize, paragraph.strong), m_area.width());
    const double lineHeight = box.height() / box.lines();
    for (int first = 0; first < box.lines();) {
        need(lineHeight);
        const int fitting = std::max(1, static_cast<int>(room() / lineHeight));
        const TextBox part = box.part(first, std::min(fitting, box.lines() - first));
        add([part, y = m_y](QPainter& p) { part.paint(p, 0, y); });
        m_y += part.height();
        first += part.lines();
    }
    m_y += gap / 3;
}

/// Two pairs abreast, framed as a card's head is.
void PageFlow::operator()(const Facts& facts) {
    const double half = m_area.width() / 2;
    const QFont nameFont = reportFont(smallSize);
    const QFont valueFont = reportFont(bodySize, true);
    for (std::size_t i = 0; i < facts.facts.size(); i += 2) {
        std::vector<std::pair<TextBox, TextBox>> boxes;
        double height = 0;
        for (std::size_t k = i; k < std::min(i + 2, facts.facts.size()); ++k) {
            const auto& [name, value] = facts.facts[k];
            boxes.emplace_back(TextBox(name, nameFont, half - 2 * cellPad),
                               TextBox(value, valueFont, half - 2 * cellPad));
            height = std::max(height, boxes.back().first.height() + boxes.back().second.height());
        }
        height += 2 * rowPad;
        need(height);
        add([boxes, y = m_y, height, half](QPainter& p) {
            for (std::size_t k = 0; k < 2; ++k) {
                const double x = double(k) * half;
                p.setPen(QPen(rule, line));
                p.drawRect(QRectF(x, y, half, height));
                if (k < boxes.size()) {
                    const auto& [name, value] = boxes[k];
                    p.setPen(printFaint);
                    name.paint(p, x + cellPad, y + rowPad);
                    p.setPen(printInk);
                    value.paint(p, x + cellPad, y + rowPad + name.height());
                }
            }
        });
        m_y += height;
    }
    m_y += gap / 2;
}

std::vector<TextBox> PageFlow::boxesOf(const QStringList& cells, const std::vector<double>& widths,
                                       const Table& table, const QFont& font) {
    std::vector<TextBox> boxes;
    for (std::size_t c = 0; c < widths.size(); ++c) {
        const bool left = c < table.texts.size() && table.texts[c];
        boxes.emplace_back(cells[static_cast<qsizetype>(c)], font, widths[c] - 2 * cellPad,
                           left ? Qt::AlignLeft : Qt::AlignRight);
    }
    if (table.symbols && &cells != &table.head) {
        boxes.front().showIndices();
    }
    return boxes;
}

void PageFlow::addRow(const std::vector<TextBox>& boxes, const std::vector<double>& widths,
                      const QColor& ground) {
    double height = 0;
    for (const TextBox& box : boxes) {
        height = std::max(height, box.height());
    }
    height += 2 * rowPad;
    add([boxes, widths, y = m_y, height, ground](QPainter& p) {
        double x = 0;
        for (std::size_t c = 0; c < boxes.size(); ++c) {
            p.setPen(QPen(rule, line));
            p.setBrush(ground.isValid() ? QBrush(ground) : QBrush(Qt::NoBrush));
            p.drawRect(QRectF(x, y, widths[c], height));
            p.setPen(printInk);
            boxes[c].paint(p, x + cellPad, y + rowPad);
            x += widths[c];
        }
    });
    m_y += height;
}

/// A row that no page can hold goes on over the next ones, line by line.
void PageFlow::operator()(const Table& table) {
    const std::vector<double> widths = columnWidths(table, m_area.width());
    const QFont headFont = reportFont(smallSize, true);
    const double head = rowHeight(table.head, widths, headFont);
    const double wholePage = m_bottom - m_top - head;
    bool begun = false;
    for (std::size_t r = 0; r < table.rows.size(); ++r) {
        const bool sum = table.lastIsSum && r + 1 == table.rows.size();
        const std::vector<TextBox> boxes =
            boxesOf(table.rows[r], widths, table, reportFont(bodySize, sum));
        const int lines = std::ranges::max_element(boxes, {}, &TextBox::lines)->lines();
        const double lineHeight = boxes.front().height() / boxes.front().lines();
        for (int first = 0; first < lines;) {
            const double rest = lineHeight * (lines - first) + 2 * rowPad;
            const double least = rest > wholePage ? leastLines * lineHeight : rest;
            const std::size_t pages = m_pages.size();
            need(begun ? least : head + least);
            if (!begun || m_pages.size() > pages) {
                addRow(boxesOf(table.head, widths, table, headFont), widths, shade);
                begun = true;
            }
            const int fitting = std::max(1, static_cast<int>((room() - 2 * rowPad) / lineHeight));
            std::vector<TextBox> piece;
            for (const TextBox& box : boxes) {
                piece.push_back(box.part(first, fitting));
            }
            addRow(piece, widths, sum ? shade : QColor());
            first += fitting;
        }
    }
    m_y += gap / 2;
}

double PageFlow::together(const Block& block) const {
    if (const auto* figure = std::get_if<Figure>(&block)) {
        return figure->size.height() * scaleOf(*figure) + headingRoom;
    }
    const double lines = leastLines * 2 * bodySize * 10;
    if (const auto* table = std::get_if<Table>(&block)) {
        const std::vector<double> widths = columnWidths(*table, m_area.width());
        double whole = rowHeight(table->head, widths, reportFont(smallSize, true));
        for (const QStringList& row : table->rows) {
            whole += rowHeight(row, widths, reportFont(bodySize));
        }
        return whole < (m_bottom - m_top) / 3 ? whole : lines;
    }
    return lines;
}

double PageFlow::scaleOf(const Figure& figure) const {
    return std::min(m_area.width() / figure.size.width(),
                    (m_bottom - m_top - 2 * headingRoom) / figure.size.height());
}

void PageFlow::operator()(const Figure& figure) {
    const TextBox caption(figure.caption, reportFont(smallSize), m_area.width(), Qt::AlignHCenter);
    const double scale = scaleOf(figure);
    need(figure.size.height() * scale + caption.height());
    add([figure, scale, y = m_y](QPainter& p) {
        p.translate(0, y);
        p.scale(scale, scale);
        figure.paint(p);
    });
    m_y += figure.size.height() * scale;
    add([caption, y = m_y](QPainter& p) {
        p.setPen(printFaint);
        caption.paint(p, 0, y);
    });
    m_y += caption.height() + gap / 2;
}

namespace {

/// The sides of an equation in lines that fit: each begins with its sign.
std::vector<std::vector<FormulaBox>> formulaLines(const Formula& formula, double width) {
    const FormulaBox equals =
        formulaBox({FormulaNode::Kind::sign, QStringLiteral(" = "), 2, 0, {}}, formulaSize);
    std::vector<std::vector<FormulaBox>> lines(1);
    double taken = 0;
    for (const FormulaNode& side : formula.sides) {
        const FormulaBox box = formulaBox(side, formulaSize);
        const double needed = box.width + equals.width;
        if (lines.back().size() > 1 && taken + needed > width) {
            lines.emplace_back();
            taken = formulaIndent;
        }
        if (&side != &formula.sides.front()) {
            lines.back().push_back(equals);
        }
        lines.back().push_back(box);
        taken += needed;
    }
    return lines;
}

} // namespace

void PageFlow::operator()(const Formula& formula) {
    const TextBox label(formula.label, reportFont(bodySize), labelRoom, Qt::AlignRight);
    const double width = m_area.width() - formulaIndent - labelRoom;
    double x = formulaIndent;
    for (const std::vector<FormulaBox>& boxes : formulaLines(formula, width)) {
        double wide = 0, ascent = 0, descent = 0;
        for (const FormulaBox& box : boxes) {
            wide += box.width;
            ascent = std::max(ascent, box.ascent);
            descent = std::max(descent, box.descent);
        }
        const double scale = std::min(1.0, (width + formulaIndent - x) / wide);
        const double height = (ascent + descent) * scale;
        need(height);
        const bool first = x == formulaIndent;
        add([=, y = m_y + ascent * scale, right = m_area.width() - labelRoom](QPainter& p) {
            p.setPen(printInk);
            if (first) {
                label.paint(p, right, y - label.height() * 0.8);
            }
            p.translate(x, y);
            p.scale(scale, scale);
            double at = 0;
            for (const FormulaBox& box : boxes) {
                box.paint(p, at, 0);
                at += box.width;
            }
        });
        m_y += height + gap / 6;
        x = 2 * formulaIndent;
    }
    m_y += gap / 4;
}

void PageFlow::operator()(const PageBreak&) {
    if (m_y > m_top) {
        newPage();
    }
}

void PageFlow::addMargins() {
    const double width = m_area.width();
    const double height = m_area.height();
    const QFont font = reportFont(smallSize);
    const QString origin = m_report.origin();
    const QString about = m_report.subject;
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        const QString number =
            PageText::number(static_cast<int>(i) + 1, static_cast<int>(m_pages.size()));
        m_pages[i].push_back([=, bottom = m_bottom, top = m_top](QPainter& p) {
            const QFontMetricsF metrics(font);
            const auto elided = [&](const QString& text, double room) {
                return metrics.elidedText(text, Qt::ElideRight, room);
            };
            p.setFont(font);
            p.setPen(printFaint);
            p.drawText(QPointF(0, metrics.ascent()), elided(about, width));
            const double base = height - metrics.descent();
            const double numberWidth = metrics.horizontalAdvance(number);
            p.drawText(QPointF(0, base), elided(origin, width - numberWidth - gap));
            p.drawText(QPointF(width - numberWidth, base), number);
            p.setPen(QPen(rule, line));
            p.drawLine(QPointF(0, top - gap / 2), QPointF(width, top - gap / 2));
            p.drawLine(QPointF(0, bottom + gap / 2), QPointF(width, bottom + gap / 2));
        });
    }
}

} // namespace sparkout::report
