// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/pdf/pdf_structure.h"
#include "ui/report/format/report.h"
#include "ui/report/format/text_box.h"
#include "ui/tables/sheet.h"

#include <QByteArray>

#include <functional>
#include <memory>
#include <vector>

class QPagedPaintDevice;
class QPainter;
class QPrinter;

namespace sparkout::report {

/// A report laid out on pages of a size: one layout for the preview, the printer and the PDF. Rows
/// and lines are never cut; a table that goes on repeats its head.
class Pages {
public:
    static constexpr double unitsPerInch = 720; ///< tenths of a point

    /// The area is that of the paper within its margins. Stopped, it has the pages begun so far.
    Pages(const Report& report, QSizeF area_units, const KeepGoing& keepGoing = {});

    /// Headings where they stand, counted from the top of the area [units].
    struct Mark {
        QString text;
        int page;
        double y;
    };
    [[nodiscard]] const std::vector<Mark>& marks() const { return m_marks; }

    /// What stands where, in the order of the report: rows and lines that are never cut.
    struct Box {
        enum class Kind { title, heading, text, facts, caption, head, row, figure, formula };
        Kind kind;
        std::size_t block = 0; ///< of the report; a title: none
        int page = 0;
        double y = 0, height = 0;
        std::vector<TextBox> cells{}; ///< of a text, of facts (names and values) or of a row
    };
    [[nodiscard]] const std::vector<Box>& boxes() const { return m_boxes; }
    [[nodiscard]] int count() const { return static_cast<int>(m_pages.size()); }
    /// From 0; at 720 units an inch. A PDF that is tagged afterwards has the structure's marks.
    void paint(QPainter& painter, int page, bool marks = false) const;

    /// What stands on the pages, in the order of reading; boxes in units of the area.
    [[nodiscard]] const PdfStructure& structure() const { return m_structure; }

    /// What is painted at once, of one element of the structure.
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

/// A4: upright with the margins of the report, or landscape and whole for the sheets of a form.
void setUpPaper(QPagedPaintDevice& device, const Report& report);
/// What a device has within its margins [units].
[[nodiscard]] QSizeF areaOf(const QPagedPaintDevice& device);
/// Paints the pages, or those of them the printer is asked for; false when it fails. In any thread.
[[nodiscard]] bool printPages(const Pages& pages, QPrinter& printer);

/// With embedded fonts, an outline and its properties; empty when it could not be made or was
/// stopped.
[[nodiscard]] QByteArray pdf(const Report& report, const KeepGoing& keepGoing = {});

} // namespace sparkout::report
