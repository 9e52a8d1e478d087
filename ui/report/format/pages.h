// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/pdf_details.h"
#include "ui/report/format/form_sheet.h"
#include "ui/report/format/report.h"
#include "ui/table/sheet.h"

#include <QByteArray>
#include <QMarginsF>
#include <QSizeF>

#include <functional>
#include <memory>
#include <vector>

class QPagedPaintDevice;
class QPainter;
class QPrinter;

namespace sparkout::report {

/// The measures of a page, by its style: type in points, distances in tenths of a point.
struct PageMetrics {
    double body, small, heading, title;
    double cell, cellHead; ///< font sizes of tables
    double formula;
    double lineSpacing;   ///< line spacing of texts, in line heights
    double indent;        ///< indent of a text's first line, and of a heading
    double apart;         ///< distance of tables and figures from their neighbours
    double head, foot;    ///< space for the head and foot of every page
    QMarginsF margins_mm; ///< margins of the paper in addition to that space
};

/// ГОСТ 7.32: 30, 15, 20 and 20 mm of margins, type of 12 points, a line and a half, 12.5 mm of
/// indent.
[[nodiscard]] const PageMetrics& metricsOf(PageStyle style);

/// A report laid out on pages of a size: one layout for the preview, the printer and the PDF. Rows
/// and lines are never cut; a continued table repeats its head.
class Pages {
public:
    static constexpr double unitsPerInch = 720; ///< tenths of a point

    /// The area is that of the paper within its margins. After a stop it has the pages begun so
    /// far.
    Pages(const Report& report, QSizeF area_units, const KeepGoing& keepGoing = {});

    /// A heading's place, from the top of the area [units].
    struct Mark {
        QString text;
        int page;
        double y;
    };
    [[nodiscard]] const std::vector<Mark>& marks() const { return m_marks; }

    /// The place of a row or line that is never cut, in the order of the report.
    struct Box {
        enum class Kind { title, heading, text, facts, caption, head, row, figure, formula };
        Kind kind;
        std::size_t block = 0; ///< block of the report; empty for a title
        int page = 0;
        double y = 0, height = 0;
        std::vector<TextBox> cells{}; ///< of a text, of facts (names and values) or of a row
    };
    [[nodiscard]] const std::vector<Box>& boxes() const { return m_boxes; }
    [[nodiscard]] int count() const { return static_cast<int>(m_pages.size()); }
    /// From 0; at 720 units per inch. For a PDF to be tagged, includes the marks of the structure.
    void paint(QPainter& painter, int page, bool marks = false) const;

    /// The contents of the pages in reading order; boxes in units of the area.
    [[nodiscard]] const PdfStructure& structure() const { return m_structure; }

    /// The part of an element of the structure that is painted at once.
    struct Piece {
        std::function<void(QPainter&)> paint;
        PdfStructure::Id element = PdfStructure::artifact;
    };

private:
    std::vector<std::vector<Piece>> m_pages;
    PdfStructure m_structure;
    std::vector<Mark> m_marks;
    std::vector<Box> m_boxes;
};

/// A4: portrait with the margins of the report, or landscape without margins for the sheets of a
/// form.
void setUpPaper(QPagedPaintDevice& device, const Report& report);
/// The area of a device within its margins [units].
[[nodiscard]] QSizeF areaOf(const QPagedPaintDevice& device);
/// Paints the pages, or those selected in the printer; false on failure. On any thread.
[[nodiscard]] bool printPages(const Pages& pages, QPrinter& printer);

/// A PDF with embedded fonts, an outline and its properties; empty on failure or after a stop.
[[nodiscard]] QByteArray pdf(const Report& report, const KeepGoing& keepGoing = {});

/// A title page laid out.
class TitleSheet {
public:
    struct Line {
        TextBox box;
        double x, y;
    };
    /// The institution at the top, the kind and title in the middle, the people at the right, place
    /// and year at the foot.
    [[nodiscard]] static std::vector<Line> lines(const TitlePage& title, QSizeF area);
};

} // namespace sparkout::report
