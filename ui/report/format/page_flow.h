// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/form_sheet.h"
#include "ui/report/format/pages.h"

#include <QColor>
#include <QFont>
#include <QRectF>

#include <functional>
#include <utility>
#include <vector>

namespace sparkout::report {

/// Lays the blocks of a report out one below the other, page by page [units: tenths of a point].
class PageFlow {
public:
    PageFlow(const Report& report, QSizeF area, const KeepGoing& keepGoing);
    [[nodiscard]] std::vector<std::vector<Pages::Piece>> takePages() { return std::move(m_pages); }
    [[nodiscard]] std::vector<Pages::Mark> takeMarks() { return std::move(m_marks); }
    [[nodiscard]] std::vector<Pages::Box> takeBoxes() { return std::move(m_boxes); }
    [[nodiscard]] PdfStructure takeStructure() { return std::move(m_structure); }

    void operator()(const Heading& heading);
    void operator()(const Paragraph& paragraph);
    void operator()(const Facts& facts);
    void operator()(const Table& table);
    void operator()(const Figure& figure);
    void operator()(const Formula& formula);
    void operator()(const FormHead& head);
    void operator()(const PageBreak&);
    void operator()(const Blank& blank);
    void operator()(const TitlePage& title);
    void operator()(const Contents& contents);

private:
    using Paint = std::function<void(QPainter&)>;
    using Element = PdfStructure::Id;
    /// Widths of a table's columns, and the size of its font [points], reduced if a number would
    /// not fit into its cell.
    struct Columns {
        std::vector<double> widths;
        double body, head;
    };
    /// A row with its layout.
    struct Row {
        std::vector<TextBox> boxes;
        double height;
    };
    struct LaidOutTable {
        const Table* table = nullptr;
        Columns columns;
        Row head;
        std::vector<Row> rows; ///< incomplete after a stop
    };
    [[nodiscard]] Columns columnsOf(const Table& table) const;
    /// Caches the last layout, which a preceding text needs, too.
    [[nodiscard]] const LaidOutTable& laidOut(const Table& table) const;
    [[nodiscard]] static Row rowOf(const QStringList& cells, const Columns& columns,
                                   const Table& table, const QFont& font);
    [[nodiscard]] Row headOf(const Table& table, const Columns& columns) const;
    [[nodiscard]] std::vector<Row> rowsOf(const Table& table, const Columns& columns) const;
    /// Pairs of facts, two abreast.
    [[nodiscard]] std::vector<Row> rowsOf(const Facts& facts) const;
    /// The least height of a block, with what is kept with it, on one page.
    [[nodiscard]] double together(std::size_t block) const;
    [[nodiscard]] double scaleOf(const Figure& figure) const;
    [[nodiscard]] double heightOf(const Figure& figure) const; ///< with its caption
    [[nodiscard]] double heightOf(const Formula& formula) const;
    [[nodiscard]] TextBox boxOf(const Paragraph& paragraph) const;
    [[nodiscard]] TextBox boxOf(const Heading& heading) const;
    /// Whether a heading starts a page.
    [[nodiscard]] bool beginsPage(const Heading& heading) const;
    [[nodiscard]] TextBox
    captionBox(const QString& caption) const; ///< without lines if there is none
    void addCaption(const TextBox& caption, Element table);
    /// Called for each row, since a table may fill hundreds of pages.
    [[nodiscard]] bool goesOn() const;
    void newPage();
    /// Starts a page unless this height is left.
    void need(double height);
    [[nodiscard]] double room() const { return m_bottom - m_y; }
    /// The end of the rows from the first that fit on this page: if few remain, more rows move to
    /// the next page, and the last ones leave space for the note below.
    [[nodiscard]] std::size_t rowsThatFit(const std::vector<Row>& rows, std::size_t first,
                                          double note) const;
    /// Whether a short text belongs to the next block.
    [[nodiscard]] bool introduces(std::size_t block, const TextBox& box) const;
    /// Height of the note below a table.
    [[nodiscard]] double noteBelow(std::size_t table) const;
    void add(Element element, Paint paint) {
        m_pages.back().push_back({std::move(paint), element});
    }
    void mark(Pages::Box::Kind kind, double height, std::vector<TextBox> cells = {});
    void addTitle();
    /// A row of a table as elements: its cells.
    [[nodiscard]] std::vector<Element> addCells(Element table, const Row& row, const char* type);
    /// The first head is an element of the table; its repetitions are not.
    void addHead(const LaidOutTable& table, std::vector<Element>& cells);
    void addRow(const Row& row, const Columns& columns, const QColor& ground, Pages::Box::Kind kind,
                const std::vector<Element>& cells);
    void addLongRow(const Row& row, const LaidOutTable& table, const QColor& ground,
                    const std::vector<Element>& cells);
    void addMargins();  ///< head and foot of every page
    void addNumbers();  ///< page numbers, if nothing else is in the margins
    void addContents(); ///< when the pages of the headings are known

    /// A heading among the contents.
    struct Entry {
        TextBox text;
        std::size_t page; ///< its page
        double x, y;
        Element element;
    };

    const Report& m_report;
    const KeepGoing& m_keepGoing;
    mutable bool m_stopped = false;
    mutable LaidOutTable m_laidOut;
    QSizeF m_area;
    const PageMetrics& m_metrics;
    double m_top, m_bottom;
    double m_y = 0;
    std::size_t m_block = 0; ///< the current block
    std::vector<std::vector<Pages::Piece>> m_pages;
    std::vector<Pages::Mark> m_marks;
    std::vector<Pages::Box> m_boxes;
    PdfStructure m_structure;
    std::vector<Entry> m_entries;
    bool m_hasTitlePage = false;
};

} // namespace sparkout::report
