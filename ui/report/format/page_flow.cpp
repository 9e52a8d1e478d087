// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/page_flow.h"

#include "ui/report/format/form_sheet.h"
#include "ui/report/format/formula_writer.h"

#include <QCoreApplication>
#include <QFontMetricsF>
#include <QPainter>

#include <algorithm>
#include <array>
#include <functional>
#include <iterator>
#include <limits>
#include <numeric>
#include <utility>

namespace sparkout::report {

namespace {

// Sizes in tenths of a point, fonts in points.
constexpr double tenths = 10; ///< parts of a point
constexpr double gap = 60, cellPad = 30, rowPad = 14, ruleWidth = 5;
constexpr double cellRoom = 2 * cellPad + 2; ///< beside the text, with an allowance for rounding
constexpr QColor rule(150, 150, 150), shade(236, 236, 236), printInk(0, 0, 0),
    printFaint(90, 90, 90);
constexpr double formulaIndent = 120, labelRoom = 260;
constexpr double blankLine = 280;                                   ///< between ruled lines
constexpr double smallerBy = 0.5, leastSize = 6.5, leastHead = 5.5; ///< font sizes of a table
constexpr double leastOneLine = 7.5; ///< least size to keep every row on one line
constexpr int leastLines = 3;        ///< least lines of a text or a row on the page of its heading
constexpr std::size_t leastRows = 3; ///< least rows of a divided table on each of its pages
constexpr double wholeShare = 0.5;   ///< smaller blocks, as a share of a page, are not divided
constexpr int introLines = 6;        ///< so short a text belongs to the next or previous block

struct PageText {
    Q_DECLARE_TR_FUNCTIONS(PageText)
public:
    static QString number(int page, int count) { return tr("page %1 of %2").arg(page).arg(count); }
};

/// The widths that the columns of a table need.
struct ColumnNeeds {
    std::vector<double> least;  ///< longest word, or longest number with its unit
    std::vector<double> wanted; ///< longest line of the rows
    std::vector<double> head;   ///< including the head
};

/// `goesOn` is called for each row, here and below; results after a stop are discarded.
using GoesOn = std::function<bool()>;

ColumnNeeds needsOf(const Table& table, double body, double head, bool wholeNumbers,
                    const GoesOn& goesOn) {
    const auto columns = static_cast<std::size_t>(table.head.size());
    ColumnNeeds needs{std::vector<double>(columns), std::vector<double>(columns),
                      std::vector<double>(columns)};
    const auto raise = [](double& value, double to) { value = std::max(value, to); };
    for (const QStringList& row : table.rows) {
        if (!goesOn()) {
            break;
        }
        const QFont font = reportFont(body, table.lastIsSum && &row == &table.rows.back());
        for (std::size_t c = 0; c < columns; ++c) {
            const QString& text = row[static_cast<qsizetype>(c)];
            const bool isText = c < table.texts.size() && table.texts[c];
            const double whole = TextBox::widestLine(text, font) + cellRoom;
            const double word = TextBox::widestWord(text, font) + cellRoom;
            raise(needs.least[c], wholeNumbers && !isText ? whole : word);
            raise(needs.wanted[c], whole);
        }
    }
    const QFont font = reportFont(head, true);
    for (std::size_t c = 0; c < columns; ++c) {
        const QString& text = table.head[static_cast<qsizetype>(c)];
        raise(needs.least[c], TextBox::widestWord(text, font) + cellRoom);
        raise(needs.wanted[c], needs.least[c]);
        needs.head[c] = std::max(needs.wanted[c], TextBox::widestLine(text, font) + cellRoom);
    }
    return needs;
}

double sumOf(const std::vector<double>& widths) {
    return std::accumulate(widths.begin(), widths.end(), 0.0);
}

/// The words of a column's cells, for the number of lines at a width.
class ColumnWords {
public:
    ColumnWords(const Table& table, std::size_t column, double body, const GoesOn& goesOn) {
        const QFontMetricsF metrics(reportFont(body));
        m_space = metrics.horizontalAdvance(u' ');
        for (const QStringList& row : table.rows) {
            auto& lines = m_cells.emplace_back();
            if (!goesOn()) {
                continue;
            }
            for (const QString& paragraph : row[static_cast<qsizetype>(column)].split(u'\n')) {
                auto& words = lines.emplace_back();
                for (const QString& word : paragraph.split(u' ', Qt::SkipEmptyParts)) {
                    words.push_back(metrics.horizontalAdvance(word));
                }
            }
        }
    }
    [[nodiscard]] std::vector<int> lines(double width) const {
        std::vector<int> counts;
        for (const auto& cell : m_cells) {
            int count = 0;
            for (const std::vector<double>& words : cell) {
                double taken = 0;
                ++count;
                for (const double word : words) {
                    const double with = taken > 0 ? taken + m_space + word : word;
                    count += with > width && taken > 0 ? 1 : 0;
                    taken = with > width ? word : with;
                }
            }
            counts.push_back(count);
        }
        return counts;
    }

private:
    double m_space = 0;
    std::vector<std::vector<std::vector<double>>> m_cells; ///< by row, line and word
};

/// Widens columns to their wanted widths, the smallest first, as far as possible.
void widen(std::vector<double>& widths, const std::vector<double>& wanted, double width,
           std::size_t spared = 0) {
    std::vector<std::size_t> order(widths.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::ranges::stable_sort(order, {}, [&](std::size_t c) { return wanted[c] - widths[c]; });
    order.resize(order.size() - std::min(spared, order.size()));
    double spare = width - sumOf(widths);
    for (const std::size_t c : order) {
        const double more = std::clamp(wanted[c] - widths[c], 0.0, std::max(0.0, spare));
        widths[c] += more;
        spare -= more;
    }
}

/// Shares the width among the columns for the fewest lines: the three widest ones are tried in
/// steps, the others get their wanted widths.
void share(std::vector<double>& widths, const std::vector<double>& wanted, double width,
           const Table& table, double body, const GoesOn& goesOn) {
    constexpr std::size_t tried = 3;
    constexpr int steps = 24;
    if (sumOf(wanted) <= width || widths.size() < tried) {
        widen(widths, wanted, width);
        return;
    }
    widen(widths, wanted, width, tried);
    const double spare = width - sumOf(widths);
    std::vector<std::size_t> most(widths.size());
    std::iota(most.begin(), most.end(), std::size_t{0});
    std::ranges::stable_sort(most, std::greater<>(),
                             [&](std::size_t c) { return wanted[c] - widths[c]; });
    most.resize(tried);
    std::array<std::array<std::vector<int>, steps + 1>, tried> lines;
    for (std::size_t i = 0; i < tried; ++i) {
        const ColumnWords words(table, most[i], body, goesOn);
        for (int k = 0; k <= steps; ++k) {
            lines[i][static_cast<std::size_t>(k)] =
                words.lines(widths[most[i]] + spare * k / steps - cellRoom);
        }
    }
    std::array<int, tried> best{steps, 0, 0};
    std::pair<int, double> least{std::numeric_limits<int>::max(), 0};
    for (int a = 0; a <= steps && goesOn(); ++a) {
        for (int b = 0; a + b <= steps; ++b) {
            const std::array<int, tried> given{a, b, steps - a - b};
            std::pair<int, double> cost{0, 0};
            for (std::size_t r = 0; r < table.rows.size(); ++r) {
                int row = 0;
                for (std::size_t i = 0; i < tried; ++i) {
                    row = std::max(row, lines[i][static_cast<std::size_t>(given[i])][r]);
                }
                cost.first += row;
            }
            for (std::size_t i = 0; i < tried; ++i) { // of equal ones that with the least shortage
                const double missing = wanted[most[i]] - widths[most[i]] - spare * given[i] / steps;
                cost.second += missing * missing / wanted[most[i]];
            }
            if (cost < least) {
                least = cost;
                best = given;
            }
        }
    }
    for (std::size_t i = 0; i < tried; ++i) {
        widths[most[i]] += spare * best[i] / steps;
    }
}

} // namespace

/// Columns that fill the page: preferably rows on one line each, in a slightly smaller font if
/// needed, then short heads.
PageFlow::Columns PageFlow::columnsOf(const Table& table) const {
    const double width = m_area.width();
    const PageMetrics& m = m_metrics;
    const auto headOf = [&m](double body) {
        return std::max(leastHead, m.cellHead - (m.cell - body));
    };
    const GoesOn goesOn = [this] { return this->goesOn(); };
    Columns columns{{}, m.cell, m.cellHead};
    ColumnNeeds needs = needsOf(table, m.cell, m.cellHead, true, goesOn);
    for (double body = m.cell; body >= leastOneLine; body -= smallerBy) {
        const ColumnNeeds smaller = needsOf(table, body, headOf(body), true, goesOn);
        if (sumOf(smaller.wanted) <= width) {
            needs = smaller;
            columns.body = body;
            break;
        }
    }
    while (sumOf(needs.least) > width && columns.body > leastSize) {
        columns.body -= smallerBy;
        needs = needsOf(table, columns.body, headOf(columns.body), true, goesOn);
    }
    columns.head = headOf(columns.body);
    if (sumOf(needs.least) > width) {
        needs = needsOf(table, columns.body, columns.head, false, goesOn);
    }
    columns.widths = needs.least;
    share(columns.widths, needs.wanted, width, table, columns.body, goesOn);
    widen(columns.widths, needs.head, width);
    const double scale = width / sumOf(columns.widths); // distributes the surplus or the shortage
    std::ranges::for_each(columns.widths, [scale](double& w) { w *= scale; });
    return columns;
}

PageFlow::Row PageFlow::rowOf(const QStringList& cells, const Columns& columns, const Table& table,
                              const QFont& font) {
    Row row{{}, 0};
    for (std::size_t c = 0; c < columns.widths.size(); ++c) {
        const bool left = c < table.texts.size() && table.texts[c];
        row.boxes.emplace_back(cells[static_cast<qsizetype>(c)], font,
                               columns.widths[c] - 2 * cellPad,
                               left ? Qt::AlignLeft : Qt::AlignRight);
        row.height = std::max(row.height, row.boxes.back().height());
    }
    if (table.symbols && &cells != &table.head) {
        row.boxes.front().showIndices();
    }
    row.height += 2 * rowPad;
    return row;
}

PageFlow::Row PageFlow::headOf(const Table& table, const Columns& columns) const {
    return rowOf(table.head, columns, table, reportFont(columns.head, true));
}

std::vector<PageFlow::Row> PageFlow::rowsOf(const Table& table, const Columns& columns) const {
    std::vector<Row> rows;
    for (const QStringList& cells : table.rows) {
        if (!goesOn()) {
            break;
        }
        const bool sum = table.lastIsSum && &cells == &table.rows.back();
        rows.push_back(rowOf(cells, columns, table, reportFont(columns.body, sum)));
    }
    return rows;
}

const PageFlow::LaidOutTable& PageFlow::laidOut(const Table& table) const {
    if (m_laidOut.table != &table) {
        const Columns columns = columnsOf(table);
        m_laidOut = {&table, columns, headOf(table, columns), rowsOf(table, columns)};
    }
    return m_laidOut;
}

std::vector<PageFlow::Row> PageFlow::rowsOf(const Facts& facts) const {
    const double width = m_area.width() / 2 - 2 * cellPad;
    std::vector<Row> rows;
    for (std::size_t i = 0; i < facts.facts.size(); i += 2) {
        Row row{{}, 0};
        for (std::size_t k = i; k < std::min(i + 2, facts.facts.size()); ++k) {
            row.boxes.emplace_back(facts.facts[k].first, reportFont(m_metrics.cellHead), width);
            row.boxes.emplace_back(facts.facts[k].second, reportFont(m_metrics.cell, true), width);
            const auto pair = row.boxes.end() - 2;
            row.height = std::max(row.height, pair->height() + (pair + 1)->height());
        }
        row.height += 2 * rowPad;
        rows.push_back(std::move(row));
    }
    return rows;
}

PageFlow::PageFlow(const Report& report, QSizeF area, const KeepGoing& keepGoing)
    : m_report(report)
    , m_keepGoing(keepGoing)
    , m_area(area)
    , m_metrics(metricsOf(report.style))
    , m_top(m_metrics.head)
    , m_bottom(area.height() - m_metrics.foot) {
    newPage();
    if (report.style == PageStyle::sheet) {
        addTitle();
    }
    for (m_block = 0; m_block < report.blocks.size(); ++m_block) {
        need(std::min(together(m_block), m_bottom - m_top));
        std::visit(*this, report.blocks[m_block]);
        if (!goesOn()) {
            break;
        }
    }
    addContents();
    if (report.style == PageStyle::sheet) {
        addMargins();
    } else {
        addNumbers();
    }
}

bool PageFlow::goesOn() const {
    m_stopped = m_stopped || !m_keepGoing(double(m_block) / double(m_report.blocks.size()));
    return !m_stopped;
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

void PageFlow::mark(Pages::Box::Kind kind, double height, std::vector<TextBox> cells) {
    m_boxes.push_back(
        {kind, m_block, static_cast<int>(m_pages.size()) - 1, m_y, height, std::move(cells)});
}

void PageFlow::addTitle() {
    const TextBox title(m_report.title, reportFont(m_metrics.title, true), m_area.width());
    mark(Pages::Box::Kind::title, title.height(), {title});
    add(m_structure.add({"H1"}), [title, y = m_y](QPainter& p) { title.paint(p, 0, y); });
    m_y += title.height() + gap / 2;
}

TextBox PageFlow::boxOf(const Heading& heading) const {
    const QFont font = reportFont(m_metrics.heading, true);
    const double width = m_area.width();
    return heading.level == Heading::Level::part
               ? TextBox(heading.text.toUpper(), font, width, Qt::AlignHCenter)
               : TextBox(heading.text, font, width, Qt::AlignLeft, {m_metrics.indent, 1});
}

bool PageFlow::beginsPage(const Heading& heading) const {
    return m_report.style == PageStyle::standard && heading.level != Heading::Level::subsection;
}

void PageFlow::operator()(const Heading& heading) {
    const TextBox box = boxOf(heading);
    if (beginsPage(heading) && m_y > m_top) {
        newPage();
    }
    m_y += m_y > m_top ? gap : 0;
    m_marks.push_back({heading.text, static_cast<int>(m_pages.size()) - 1, m_y});
    mark(Pages::Box::Kind::heading, box.height(), {box});
    const bool below = heading.level == Heading::Level::subsection;
    add(m_structure.add({below ? "H3" : "H2"}),
        [box, y = m_y](QPainter& p) { box.paint(p, 0, y); });
    m_y += box.height() + gap / 3;
}

void PageFlow::operator()(const Paragraph& paragraph) {
    const TextBox box = boxOf(paragraph);
    const double lineHeight = box.height() / box.lines();
    const Element element = m_structure.add({"P"});
    for (int first = 0; first < box.lines();) {
        need(lineHeight);
        const int left = box.lines() - first;
        int fitting = std::max(1, static_cast<int>(room() / lineHeight));
        if (fitting < left && left - fitting < leastLines - 1 && fitting > leastLines) {
            fitting = left - leastLines + 1; // no single line on the next page
        }
        const TextBox part = box.part(first, std::min(fitting, left));
        mark(Pages::Box::Kind::text, part.height(), {part});
        add(element, [part, y = m_y](QPainter& p) { part.paint(p, 0, y); });
        m_y += part.height();
        first += part.lines();
        if (first < box.lines()) {
            newPage();
        }
    }
    m_y += gap / 3;
}

TextBox PageFlow::boxOf(const Paragraph& paragraph) const {
    TextBox box(paragraph.text, reportFont(m_metrics.body, paragraph.strong), m_area.width(),
                Qt::AlignLeft, {m_metrics.indent, m_metrics.lineSpacing});
    if (paragraph.symbols) {
        box.showIndices();
    }
    return box;
}

bool PageFlow::introduces(std::size_t block, const TextBox& box) const {
    if (block + 1 >= m_report.blocks.size() || box.lines() > introLines) {
        return false;
    }
    const Block& next = m_report.blocks[block + 1];
    return std::holds_alternative<Table>(next) || std::holds_alternative<Facts>(next)
           || std::holds_alternative<Formula>(next) || std::holds_alternative<Blank>(next);
}

double PageFlow::noteBelow(std::size_t table) const {
    const auto* note = table + 1 < m_report.blocks.size()
                           ? std::get_if<Paragraph>(&m_report.blocks[table + 1])
                           : nullptr;
    if (!note) {
        return 0;
    }
    const TextBox box = boxOf(*note);
    return box.lines() > introLines || introduces(table + 1, box) ? 0 : gap / 2 + box.height();
}

std::size_t PageFlow::rowsThatFit(const std::vector<Row>& rows, std::size_t first,
                                  double note) const {
    double taken = 0;
    std::size_t end = first;
    while (end < rows.size() && taken + rows[end].height <= room()) {
        taken += rows[end].height;
        ++end;
    }
    const std::size_t over = end == rows.size() && taken + note > room() ? 1 : rows.size() - end;
    if (over > 0 && over < leastRows && rows.size() - first >= 2 * leastRows) {
        end = rows.size() - leastRows;
    }
    return end;
}

/// Lays out two pairs side by side, framed like the head of a card.
void PageFlow::operator()(const Facts& facts) {
    const double half = m_area.width() / 2;
    const std::vector<Row> rows = rowsOf(facts);
    const Element list = m_structure.add({"L"});
    for (std::size_t r = 0, end = 0; r < rows.size(); ++r) {
        if (r == end) {
            need(rows[r].height);
            end = std::max(r + 1, rowsThatFit(rows, r, noteBelow(m_block)));
        }
        const Row& row = rows[r];
        mark(Pages::Box::Kind::facts, row.height, row.boxes);
        add(PdfStructure::artifact, [height = row.height, y = m_y, half](QPainter& p) {
            p.setPen(QPen(rule, ruleWidth));
            p.drawRect(QRectF(0, y, half, height));
            p.drawRect(QRectF(half, y, half, height));
        });
        for (std::size_t k = 0; k < row.boxes.size(); k += 2) {
            const Element item = m_structure.add({"LI", list});
            const TextBox& name = row.boxes[k];
            const double x = static_cast<double>(k / 2) * half + cellPad, y = m_y + rowPad;
            add(m_structure.add({"Lbl", item}), [name, x, y](QPainter& p) {
                p.setPen(printFaint);
                name.paint(p, x, y);
            });
            add(m_structure.add({"LBody", item}),
                [value = row.boxes[k + 1], x, y = y + name.height()](QPainter& p) {
                    p.setPen(printInk);
                    value.paint(p, x, y);
                });
        }
        m_y += row.height;
        if (r + 1 == end && end < rows.size()) {
            newPage();
        }
    }
    m_y += gap / 2;
}

std::vector<PageFlow::Element> PageFlow::addCells(Element table, const Row& row, const char* type) {
    const Element line = m_structure.add({"TR", table});
    std::vector<Element> cells;
    for (std::size_t c = 0; c < row.boxes.size(); ++c) {
        cells.push_back(m_structure.add({type, line}));
    }
    return cells;
}

void PageFlow::addHead(const LaidOutTable& table, std::vector<Element>& cells) {
    addRow(table.head, table.columns, shade, Pages::Box::Kind::head, cells);
    std::ranges::fill(cells, PdfStructure::pagination);
}

void PageFlow::addRow(const Row& row, const Columns& columns, const QColor& ground,
                      Pages::Box::Kind kind, const std::vector<Element>& cells) {
    mark(kind, row.height, row.boxes);
    add(PdfStructure::artifact,
        [height = row.height, widths = columns.widths, y = m_y, ground](QPainter& p) {
            p.setPen(QPen(rule, ruleWidth));
            p.setBrush(ground.isValid() ? QBrush(ground) : QBrush(Qt::NoBrush));
            double x = 0;
            for (const double width : widths) {
                p.drawRect(QRectF(x, y, width, height));
                x += width;
            }
        });
    double x = 0;
    for (std::size_t c = 0; c < row.boxes.size(); ++c) {
        add(cells[c], [box = row.boxes[c], x = x + cellPad, y = m_y + rowPad](QPainter& p) {
            p.setPen(printInk);
            box.paint(p, x, y);
        });
        x += columns.widths[c];
    }
    m_y += row.height;
}

/// A row higher than a page continues on the next ones, line by line.
void PageFlow::addLongRow(const Row& row, const LaidOutTable& table, const QColor& ground,
                          const std::vector<Element>& cells) {
    const int lines = std::ranges::max_element(row.boxes, {}, &TextBox::lines)->lines();
    const double lineHeight = row.boxes.front().height() / row.boxes.front().lines();
    std::vector<Element> head(row.boxes.size(), PdfStructure::pagination);
    for (int first = 0; first < lines;) {
        if (room() < std::min(leastLines, lines - first) * lineHeight + 2 * rowPad) {
            newPage();
            addHead(table, head);
        }
        const int fitting = std::max(1, static_cast<int>((room() - 2 * rowPad) / lineHeight));
        Row piece{{}, 0};
        for (const TextBox& box : row.boxes) {
            piece.boxes.push_back(box.part(first, fitting));
            piece.height = std::max(piece.height, piece.boxes.back().height());
        }
        piece.height += 2 * rowPad;
        addRow(piece, table.columns, ground, Pages::Box::Kind::row, cells);
        first += fitting;
    }
}

TextBox PageFlow::captionBox(const QString& caption) const {
    TextBox box(caption, reportFont(m_metrics.small), m_area.width());
    return caption.isEmpty() ? box.part(0, 0) : box;
}

void PageFlow::addCaption(const TextBox& caption, Element table) {
    if (caption.lines() == 0) {
        return;
    }
    mark(Pages::Box::Kind::caption, caption.height(), {caption});
    add(m_structure.add({"Caption", table}), [caption, y = m_y](QPainter& p) {
        p.setPen(printInk);
        caption.paint(p, 0, y);
    });
    m_y += caption.height();
}

void PageFlow::operator()(const Table& table) {
    const LaidOutTable& made = laidOut(table);
    const std::vector<Row>& rows = made.rows;
    const double headHeight = made.head.height;
    const double wholePage = m_bottom - m_top - headHeight - captionBox(captionOf(table)).height();
    const Element element = m_structure.add({"Table"});
    std::vector<Element> head = addCells(element, made.head, "TH");
    for (std::size_t r = 0, end = 0; r < rows.size() && goesOn(); ++r) {
        const bool isLong = rows[r].height > wholePage;
        if (r == end) {
            const double least =
                isLong ? leastLines * rows[r].boxes.front().height() : rows[r].height;
            const TextBox caption = captionBox(r == 0 ? captionOf(table) : continuationOf(table));
            m_y += m_y > m_top ? m_metrics.apart : 0;
            need(caption.height() + headHeight + std::min(least, wholePage));
            addCaption(caption, element);
            addHead(made, head);
            end = std::max(r + 1, rowsThatFit(rows, r, noteBelow(m_block)));
        }
        const std::vector<Element> cells = addCells(element, rows[r], "TD");
        const bool sum = table.lastIsSum && r + 1 == rows.size();
        const QColor ground = sum ? shade : QColor();
        if (isLong) {
            addLongRow(rows[r], made, ground, cells);
            end = std::max(r + 1, rowsThatFit(rows, r + 1, noteBelow(m_block)));
        } else {
            addRow(rows[r], made.columns, ground, Pages::Box::Kind::row, cells);
        }
        if (r + 1 == end && end < rows.size()) {
            newPage();
        }
    }
    m_y += gap / 2 + m_metrics.apart;
}

namespace {

/// The height of rows kept together: all if they are few, otherwise the least of a divided table.
double rowsTogether(const std::vector<double>& heights, double above, double below, double page) {
    const double whole = above + std::accumulate(heights.begin(), heights.end(), below);
    if (whole <= wholeShare * page) {
        return whole;
    }
    double first = above;
    for (std::size_t r = 0; r < std::min(leastRows, heights.size()); ++r) {
        first += heights[r];
    }
    return std::min(first, page);
}

} // namespace

double PageFlow::together(std::size_t block) const {
    if (block >= m_report.blocks.size()) {
        return 0;
    }
    const double page = m_bottom - m_top;
    const auto heights = [](const std::vector<Row>& rows) {
        std::vector<double> all;
        std::ranges::transform(rows, std::back_inserter(all), &Row::height);
        return all;
    };
    const Block& of = m_report.blocks[block];
    if (const auto* heading = std::get_if<Heading>(&of)) {
        const double height = gap + boxOf(*heading).height() + gap / 3;
        return beginsPage(*heading) ? height : height + together(block + 1);
    }
    if (const auto* paragraph = std::get_if<Paragraph>(&of)) {
        const TextBox box = boxOf(*paragraph);
        const double lineHeight = box.height() / box.lines();
        if (introduces(block, box)) {
            return box.height() + gap / 3 + together(block + 1);
        }
        return lineHeight * (box.lines() <= leastLines + 1 ? box.lines() : leastLines);
    }
    if (const auto* facts = std::get_if<Facts>(&of)) {
        return rowsTogether(heights(rowsOf(*facts)), 0, noteBelow(block), page);
    }
    if (const auto* table = std::get_if<Table>(&of)) {
        const LaidOutTable& all = laidOut(*table);
        const double above =
            m_metrics.apart + captionBox(captionOf(*table)).height() + all.head.height;
        return rowsTogether(heights(all.rows), above, noteBelow(block), page);
    }
    if (const auto* figure = std::get_if<Figure>(&of)) {
        return heightOf(*figure);
    }
    if (const auto* blank = std::get_if<Blank>(&of)) {
        return std::min(blank->lines * blankLine, wholeShare * page);
    }
    if (const auto* formula = std::get_if<Formula>(&of)) {
        return std::min(heightOf(*formula), page);
    }
    return 0;
}

double PageFlow::scaleOf(const Figure& figure) const {
    const TextBox caption(figure.caption, reportFont(m_metrics.small), m_area.width());
    const double heading = 2 * (m_metrics.heading * tenths + gap); // keeps the previous one with it
    return std::min(m_area.width() / figure.size.width(),
                    (m_bottom - m_top - m_metrics.apart - caption.height() - heading)
                        / figure.size.height());
}

double PageFlow::heightOf(const Figure& figure) const {
    const TextBox caption(figure.caption, reportFont(m_metrics.small), m_area.width());
    return m_metrics.apart + figure.size.height() * scaleOf(figure) + caption.height();
}

void PageFlow::operator()(const Figure& figure) {
    const TextBox caption(figure.caption, reportFont(m_metrics.small), m_area.width(),
                          Qt::AlignHCenter);
    const double scale = scaleOf(figure);
    mark(Pages::Box::Kind::figure, heightOf(figure), {caption});
    m_y += m_metrics.apart;
    const QRectF box(QPointF(0, m_y), figure.size * scale);
    const Element element = m_structure.add(
        {"Figure", PdfStructure::document,
         figure.description.isEmpty() ? figure.caption : figure.description, 1, box});
    add(element, [figure, scale, y = m_y](QPainter& p) {
        p.translate(0, y);
        p.scale(scale, scale);
        figure.paint(p);
    });
    m_y += figure.size.height() * scale;
    const QColor ink = m_report.style == PageStyle::sheet ? printFaint : printInk;
    add(m_structure.add({"Caption", element}), [caption, ink, y = m_y](QPainter& p) {
        p.setPen(ink);
        caption.paint(p, 0, y);
    });
    m_y += caption.height() + gap / 2 + m_metrics.apart;
}

namespace {

/// The sides of an equation in lines that fit: each begins with its sign.
std::vector<std::vector<FormulaBox>> formulaLines(const Formula& formula, double width,
                                                  double points) {
    const FormulaBox equals =
        formulaBox({FormulaNode::Kind::sign, QStringLiteral(" = "), 2, 0, {}}, points);
    std::vector<std::vector<FormulaBox>> lines(1);
    double taken = 0;
    for (const FormulaNode& side : formula.sides) {
        const FormulaBox box = formulaBox(side, points);
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

/// A line of an equation with its size, compressed if it is too wide.
struct FormulaLine {
    FormulaLine(const std::vector<FormulaBox>& boxes, double room) {
        double wide = 0, below = 0, above = 0;
        for (const FormulaBox& box : boxes) {
            wide += box.width;
            above = std::max(above, box.ascent);
            below = std::max(below, box.descent);
        }
        scale = std::min(1.0, room / wide);
        ascent = above * scale;
        height = (above + below) * scale;
    }
    double scale, ascent, height;
};

double indentOf(bool first) {
    return first ? formulaIndent : 2 * formulaIndent;
}

} // namespace

double PageFlow::heightOf(const Formula& formula) const {
    const double width = m_area.width() - formulaIndent - labelRoom;
    double height = 0;
    for (const std::vector<FormulaBox>& boxes : formulaLines(formula, width, m_metrics.formula)) {
        const double x = indentOf(height == 0);
        height += FormulaLine(boxes, width + formulaIndent - x).height + gap / 6;
    }
    return height;
}

void PageFlow::operator()(const Formula& formula) {
    const TextBox label(formula.label, reportFont(m_metrics.body), labelRoom, Qt::AlignRight);
    const double width = m_area.width() - formulaIndent - labelRoom;
    const Element element =
        m_structure.add({"Formula", PdfStructure::document,
                         QStringList{inOneLine(formula), formula.label}.join(u' ').trimmed()});
    bool first = true;
    for (const std::vector<FormulaBox>& boxes : formulaLines(formula, width, m_metrics.formula)) {
        const double x = indentOf(first);
        const FormulaLine size(boxes, width + formulaIndent - x);
        need(size.height);
        mark(Pages::Box::Kind::formula, size.height);
        add(element, [=, y = m_y + size.ascent, right = m_area.width() - labelRoom](QPainter& p) {
            p.setPen(printInk);
            if (first) {
                label.paint(p, right, y - label.height() * 0.8);
            }
            p.translate(x, y);
            p.scale(size.scale, size.scale);
            double at = 0;
            for (const FormulaBox& box : boxes) {
                box.paint(p, at, 0);
                at += box.width;
            }
        });
        m_y += size.height + gap / 6;
        first = false;
    }
    m_y += gap / 4;
}

void PageFlow::operator()(const FormHead& head) {
    (*this)(Facts{head.entries});
}

void PageFlow::operator()(const PageBreak&) {
    if (m_y > m_top) {
        newPage();
    }
}

void PageFlow::operator()(const Blank& blank) {
    for (int line = 0; line < blank.lines; ++line) {
        need(blankLine);
        mark(Pages::Box::Kind::text, blankLine);
        m_y += blankLine;
        add(PdfStructure::artifact, [y = m_y, width = m_area.width()](QPainter& p) {
            p.setPen(QPen(rule, ruleWidth));
            p.drawLine(QPointF(0, y), QPointF(width, y));
        });
    }
    m_y += gap;
}

void PageFlow::operator()(const TitlePage& title) {
    for (TitleSheet::Line& line : TitleSheet::lines(title, m_area)) {
        m_y = line.y;
        mark(Pages::Box::Kind::title, line.box.height(), {line.box});
        add(m_structure.add({"P"}), [line](QPainter& p) { line.box.paint(p, line.x, line.y); });
    }
    m_hasTitlePage = true;
    newPage();
}

void PageFlow::operator()(const Contents& contents) {
    const TextBox title(contents.title.toUpper(), reportFont(m_metrics.heading, true),
                        m_area.width(), Qt::AlignHCenter);
    mark(Pages::Box::Kind::heading, title.height(), {title});
    add(m_structure.add({"H2"}), [title, y = m_y](QPainter& p) { title.paint(p, 0, y); });
    m_y += title.height() + gap;
    const Element toc = m_structure.add({"TOC"});
    for (const Block& block : m_report.blocks) {
        if (const auto* heading = std::get_if<Heading>(&block)) {
            const bool below = heading->level == Heading::Level::subsection;
            const double x = below ? m_metrics.indent / 2 : 0;
            const TextBox text(heading->text, reportFont(m_metrics.body),
                               m_area.width() - x - labelRoom);
            need(text.height());
            mark(Pages::Box::Kind::text, text.height(), {text});
            m_entries.push_back({text, m_pages.size() - 1, x, m_y, m_structure.add({"TOCI", toc})});
            m_y += text.height() + gap / 3;
        }
    }
}

void PageFlow::addContents() {
    const QFont font = reportFont(m_metrics.body);
    for (std::size_t i = 0; i < std::min(m_entries.size(), m_marks.size()); ++i) {
        const Entry& entry = m_entries[i];
        const QString number = QString::number(m_marks[i].page + 1);
        const auto paint = [entry, number, font, width = m_area.width()](QPainter& p) {
            p.setPen(printInk);
            entry.text.paint(p, entry.x, entry.y);
            const QFontMetricsF metrics(font);
            const TextBox last = entry.text.part(entry.text.lines() - 1, 1);
            const double base = entry.y + entry.text.height() - metrics.descent();
            const double end = width - metrics.horizontalAdvance(number);
            const double dot = metrics.horizontalAdvance(QStringLiteral(" ."));
            p.setFont(font);
            p.drawText(QPointF(end, base), number);
            const double from = entry.x + metrics.horizontalAdvance(last.texts().value(0)) + dot;
            for (double x = end - 2 * dot; x > from; x -= dot) {
                p.drawText(QPointF(x, base), QStringLiteral("."));
            }
        };
        m_pages[entry.page].push_back({paint, entry.element});
    }
}

/// Centred below the text; the title page is counted but not numbered.
void PageFlow::addNumbers() {
    const QFont font = reportFont(m_metrics.body);
    for (std::size_t i = m_hasTitlePage ? 1 : 0; i < m_pages.size(); ++i) {
        const auto paint = [number = QString::number(i + 1), font, size = m_area](QPainter& p) {
            const QFontMetricsF metrics(font);
            p.setFont(font);
            p.setPen(printInk);
            p.drawText(QPointF((size.width() - metrics.horizontalAdvance(number)) / 2,
                               size.height() - metrics.descent()),
                       number);
        };
        m_pages[i].push_back({paint, PdfStructure::pagination});
    }
}

void PageFlow::addMargins() {
    const double width = m_area.width();
    const double height = m_area.height();
    const QFont font = reportFont(m_metrics.small);
    const QString origin = m_report.origin();
    const QString about = m_report.subject;
    for (std::size_t i = 0; i < m_pages.size(); ++i) {
        const QString number =
            PageText::number(static_cast<int>(i) + 1, static_cast<int>(m_pages.size()));
        const Paint margins = [=, bottom = m_bottom, top = m_top](QPainter& p) {
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
            p.setPen(QPen(rule, ruleWidth));
            p.drawLine(QPointF(0, top - gap / 2), QPointF(width, top - gap / 2));
            p.drawLine(QPointF(0, bottom + gap / 2), QPointF(width, bottom + gap / 2));
        };
        m_pages[i].push_back({margins, PdfStructure::pagination});
    }
}

} // namespace sparkout::report
