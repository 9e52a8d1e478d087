// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/pages.h"
#include "ui/report/text_box.h"

#include <QColor>
#include <QFont>
#include <QRectF>

#include <functional>
#include <vector>

namespace sparkout::report {

/// Lays the blocks of a report out one below the other, page by page [units: tenths of a point].
class PageFlow {
public:
    using Paint = std::function<void(QPainter&)>;
    PageFlow(const Report& report, QSizeF area, const KeepGoing& keepGoing);
    [[nodiscard]] std::vector<std::vector<Paint>> takePages() { return std::move(m_pages); }
    [[nodiscard]] std::vector<Pages::Mark> takeMarks() { return std::move(m_marks); }

    void operator()(const Heading& heading);
    void operator()(const Paragraph& paragraph);
    void operator()(const Facts& facts);
    void operator()(const Table& table);
    void operator()(const Figure& figure);
    void operator()(const Formula& formula);
    void operator()(const PageBreak&);

private:
    /// Height of what must not be parted from the heading above.
    [[nodiscard]] double together(const Block& block) const;
    [[nodiscard]] double scaleOf(const Figure& figure) const;
    void newPage();
    /// Begins a page unless so much fits below what is there.
    void need(double height);
    [[nodiscard]] double room() const { return m_bottom - m_y; }
    void add(Paint paint) { m_pages.back().push_back(std::move(paint)); }
    void addTitle();
    [[nodiscard]] static std::vector<TextBox> boxesOf(const QStringList& cells,
                                                      const std::vector<double>& widths,
                                                      const Table& table, const QFont& font);
    void addRow(const std::vector<TextBox>& boxes, const std::vector<double>& widths,
                const QColor& ground);
    void addMargins(); ///< head and foot of every page

    const Report& m_report;
    QSizeF m_area;
    double m_top, m_bottom;
    double m_y = 0;
    std::vector<std::vector<Paint>> m_pages;
    std::vector<Pages::Mark> m_marks;
};

} // namespace sparkout::report
