// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/pages.h"

#include "ui/kit/pdf_details.h"
#include "ui/report/format/form_sheet.h"
#include "ui/report/format/page_flow.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFont>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QPrinter>

#include <algorithm>
#include <map>
#include <optional>
#include <utility>

namespace sparkout::report {

const PageMetrics& metricsOf(PageStyle style) {
    // The left margin is for filing. Head and foot have a line of text and a rule.
    static const PageMetrics sheet{.body = 9,
                                   .small = 7.5,
                                   .heading = 11,
                                   .title = 15,
                                   .cell = 9,
                                   .cellHead = 7.5,
                                   .formula = 9.5,
                                   .lineSpacing = 1,
                                   .indent = 0,
                                   .apart = 0,
                                   .head = 180,
                                   .foot = 180,
                                   .margins_mm = {18, 12, 12, 12}};
    // The page number takes 10 of the 20 mm below the text.
    static const PageMetrics standard{.body = 12,
                                      .small = 12,
                                      .heading = 14,
                                      .title = 16,
                                      .cell = 10,
                                      .cellHead = 9,
                                      .formula = 12,
                                      .lineSpacing = 1.5,
                                      .indent = 354,
                                      .apart = 100,
                                      .head = 0,
                                      .foot = 283,
                                      .margins_mm = {30, 20, 15, 10}};
    return style == PageStyle::sheet ? sheet : standard;
}

namespace {

using Id = PdfStructure::Id;

/// The elements of a sheet's table: every row has a cell for each column, or one spanning several.
class SheetTable {
public:
    SheetTable(const FormSheet& sheet, PdfStructure& structure, Id parent) {
        std::map<std::pair<int, int>, int> spans; // by row and column
        for (const SheetText& text : sheet.texts) {
            if (text.place) {
                int& span = spans[{text.place->row, text.place->column}];
                span = std::max(span, text.place->span);
            }
        }
        if (spans.empty()) {
            return;
        }
        const Id table = structure.add({"Table", parent});
        for (int row = 0; row <= spans.rbegin()->first.first; ++row) {
            const Id line = structure.add({"TR", table});
            for (int column = 0; column < sheet.columns;) {
                const auto given = spans.find({row, column});
                const int span = given == spans.end() ? 1 : given->second;
                m_cells[{row, column}] =
                    structure.add({row == 0 ? "TH" : "TD", line, QString(), span});
                column += span;
            }
        }
    }
    [[nodiscard]] Id cell(const TablePlace& place) const {
        return m_cells.at({place.row, place.column});
    }

private:
    std::map<std::pair<int, int>, Id> m_cells;
};

/// The area of the drawing's lines [units of the page].
QRectF boxOf(const FormSheet& sheet) {
    QRectF box;
    for (std::size_t i = sheet.drawing.lines.from; i < sheet.drawing.lines.to; ++i) {
        const SheetLine& line = sheet.lines[i];
        const double w = line.width_mm / 2; // so that none is empty
        box |= QRectF(line.line.p1(), line.line.p2()).normalized().adjusted(-w, -w, w, w);
    }
    return {box.topLeft() * unitsPerMm, box.size() * unitsPerMm};
}

/// A sheet of a form as painted pieces, by the elements of the structure: its heading, its texts,
/// the table and the drawing; frames belong to none.
std::vector<Pages::Piece> sheetPieces(const FormSheet& given, PdfStructure& structure) {
    const auto sheet = std::make_shared<const FormSheet>(given);
    const SheetDrawing& drawing = sheet->drawing;
    std::vector<Pages::Piece> pieces;
    const Id section = structure.add({"Sect"});
    const auto add = [&](Id element, std::function<void(QPainter&)> paint) {
        pieces.push_back({std::move(paint), element});
    };
    const auto addText = [&](Id element, std::size_t i) {
        add(element, [sheet, i](QPainter& p) { sheet->texts[i].paint(p); });
    };
    for (std::size_t i = 0; i < sheet->texts.size(); ++i) { // at the foot, but read first
        if (sheet->texts[i].isHeading) {
            addText(structure.add({"H1", section}), i);
        }
    }
    for (std::size_t i = 0; i < sheet->pictures.size(); ++i) {
        const QRectF& cell = sheet->pictures[i].cell;
        const QRectF box(cell.topLeft() * unitsPerMm, cell.size() * unitsPerMm);
        add(structure.add({"Figure", section, sheet->pictures[i].description, 1, box}),
            [sheet, i](QPainter& p) { FormSheet::paintPicture(p, sheet->pictures[i]); });
    }
    add(PdfStructure::artifact, [sheet](QPainter& p) {
        const SheetDrawing& of = sheet->drawing;
        sheet->paintLines(p, {0, of.lines.from});
        sheet->paintLines(p, {of.lines.to, sheet->lines.size()});
        sheet->paintShapes(p, {0, of.shapes.from});
        sheet->paintShapes(p, {of.shapes.to, sheet->shapes.size()});
    });
    const auto isDrawn = [&drawing](std::size_t i) {
        return i >= drawing.texts.from && i < drawing.texts.to;
    };
    const auto addTexts = [&](bool ofTable, const SheetTable* table) {
        for (std::size_t i = 0; i < sheet->texts.size(); ++i) {
            const SheetText& text = sheet->texts[i];
            if (!text.isHeading && !isDrawn(i) && text.place.has_value() == ofTable) {
                addText(ofTable ? table->cell(*text.place) : structure.add({"P", section}), i);
            }
        }
    };
    addTexts(false, nullptr);
    const SheetTable table(*sheet, structure, section);
    addTexts(true, &table);
    if (!drawing.description.isEmpty()) {
        const Id figure = structure.add({"Figure", section, drawing.description, 1, boxOf(*sheet)});
        add(figure, [sheet](QPainter& p) {
            sheet->paintLines(p, sheet->drawing.lines);
            sheet->paintShapes(p, sheet->drawing.shapes);
            for (std::size_t i = sheet->drawing.texts.from; i < sheet->drawing.texts.to; ++i) {
                sheet->texts[i].paint(p);
            }
        });
    }
    return pieces;
}

constexpr int pdfResolution = 1200;
constexpr double pointsPerInch = 72;

/// The title as shown in a list of documents.
QString fullTitle(const Report& report) {
    return report.subject.isEmpty() ? report.title
                                    : report.title + QStringLiteral(" – ") + report.subject;
}

/// The properties as XMP, required by newer readers.
QByteArray xmp(const Report& report) {
    return QStringLiteral("<?xpacket begin=\"\uFEFF\" id=\"W5M0MpCehiHzreSzNTczkc9d\"?>\n"
                          "<x:xmpmeta xmlns:x=\"adobe:ns:meta/\"><rdf:RDF "
                          "xmlns:rdf=\"http://www.w3.org/1999/02/22-rdf-syntax-ns#\">"
                          "<rdf:Description rdf:about=\"\" "
                          "xmlns:dc=\"http://purl.org/dc/elements/1.1/\" "
                          "xmlns:xmp=\"http://ns.adobe.com/xap/1.0/\">"
                          "<dc:title><rdf:Alt><rdf:li xml:lang=\"x-default\">%1</rdf:li></rdf:Alt>"
                          "</dc:title><dc:creator><rdf:Seq><rdf:li>%2</rdf:li></rdf:Seq>"
                          "</dc:creator><xmp:CreatorTool>%3</xmp:CreatorTool></rdf:Description>"
                          "</rdf:RDF></x:xmpmeta>\n<?xpacket end=\"w\"?>\n")
        .arg(report.title.toHtmlEscaped(), report.author.toHtmlEscaped(),
             report.program.toHtmlEscaped())
        .toUtf8();
}

constexpr double layoutShare = 0.3; ///< approximate share of the time for a PDF

bool paintRange(const Pages& pages, QPagedPaintDevice& device, int first, int last,
                bool marks = false, const KeepGoing& keepGoing = {}) {
    QPainter painter;
    if (!painter.begin(&device)) {
        return false;
    }
    const double scale = device.logicalDpiX() / Pages::unitsPerInch;
    for (int page = first; page <= last; ++page) {
        const double share = layoutShare + (1 - layoutShare) * (page - first) / (last - first + 1);
        if ((keepGoing && !keepGoing(share)) || (page > first && !device.newPage())) {
            return false;
        }
        painter.save();
        painter.scale(scale, scale);
        pages.paint(painter, page, marks);
        painter.restore();
    }
    return painter.end();
}

} // namespace

Pages::Pages(const Report& report, QSizeF area_units, const KeepGoing& keepGoing) {
    if (!report.sheets.empty()) {
        for (const FormSheet& sheet : report.sheets) {
            m_marks.push_back({sheet.title, count(), 0});
            m_pages.push_back(sheetPieces(sheet, m_structure));
        }
        return;
    }
    PageFlow flow(report, area_units, [&keepGoing](double share) {
        return !keepGoing || keepGoing(share * layoutShare);
    });
    m_pages = flow.takePages();
    m_marks = flow.takeMarks();
    m_boxes = flow.takeBoxes();
    m_structure = flow.takeStructure();
}

void Pages::paint(QPainter& painter, int page, bool marks) const {
    painter.setRenderHint(QPainter::Antialiasing);
    for (const Piece& piece : m_pages.at(static_cast<std::size_t>(page))) {
        if (marks) {
            PdfStructure::mark(painter, piece.element);
        }
        painter.save();
        piece.paint(painter);
        painter.restore();
    }
}

void setUpPaper(QPagedPaintDevice& device, const Report& report) {
    const bool isForm = !report.sheets.empty();
    QPageLayout layout(
        QPageSize(QPageSize::A4), isForm ? QPageLayout::Landscape : QPageLayout::Portrait,
        isForm ? QMarginsF() : metricsOf(report.style).margins_mm, QPageLayout::Millimeter);
    layout.setMode(isForm ? QPageLayout::FullPageMode : QPageLayout::StandardMode);
    device.setPageLayout(layout);
}

QSizeF areaOf(const QPagedPaintDevice& device) {
    return device.pageLayout().paintRect(QPageLayout::Point).size() * Pages::unitsPerInch
           / pointsPerInch;
}

bool printPages(const Pages& pages, QPrinter& printer) {
    const bool some = printer.printRange() == QPrinter::PageRange && printer.fromPage() > 0;
    const int first = some ? std::clamp(printer.fromPage() - 1, 0, pages.count() - 1) : 0;
    const int last =
        some ? std::clamp(printer.toPage() - 1, first, pages.count() - 1) : pages.count() - 1;
    return paintRange(pages, printer, first, last);
}

QByteArray pdf(const Report& report, const KeepGoing& keepGoing) {
    QByteArray bytes;
    QBuffer buffer(&bytes);
    if (!buffer.open(QIODevice::WriteOnly)) {
        return {};
    }
    PdfDetails details{fullTitle(report),
                       report.author,
                       report.subject,
                       report.program,
                       report.language,
                       report.date,
                       {}};
    if (!report.inputs.isEmpty()) { // from which the paper can be opened again
        details.attachment = projectAttachment(report.file, report.inputs);
    }
    bool painted = false;
    {
        QPdfWriter writer(&buffer);
        writer.setResolution(pdfResolution);
        setUpPaper(writer, report);
        writer.setDocumentXmpMetadata(xmp(report));
        const Pages pages(report, areaOf(writer), keepGoing);
        const QPointF corner_pt = writer.pageLayout().paintRect(QPageLayout::Point).topLeft();
        constexpr double pointsPerUnit = pointsPerInch / Pages::unitsPerInch;
        for (const Pages::Mark& mark : pages.marks()) {
            details.outline.push_back(
                {mark.text, mark.page, corner_pt.y() + mark.y * pointsPerUnit});
        }
        details.structure = pages.structure();
        details.structure.placeBoxes(pointsPerUnit, corner_pt);
        painted = paintRange(pages, writer, 0, pages.count() - 1, true, keepGoing);
    }
    return painted ? withDetails(bytes, details, [&] { return !keepGoing || keepGoing(1); })
                   : QByteArray();
}

namespace {

constexpr double textPoints = 12, documentPoints = 16, titlePoints = 14;
constexpr double betweenLines = 60, groupsApart = 240; ///< tenths of a point
constexpr double titleAt = 0.3, peopleFrom = 0.45;     ///< shares of height and width

/// Lines one below the other.
class Column {
public:
    Column(double x, double y, double width) : m_x(x), m_y(y), m_width(width) {}

    void add(const QString& text, const QFont& font, Qt::Alignment align) {
        const TextBox box(text, font, m_width, align);
        m_lines.push_back({box, m_x, m_y});
        m_y += box.height() + betweenLines;
    }
    void skip(double height) { m_y += height; }
    [[nodiscard]] double bottom() const { return m_y; }
    [[nodiscard]] std::vector<TitleSheet::Line>& lines() { return m_lines; }

private:
    double m_x, m_y, m_width;
    std::vector<TitleSheet::Line> m_lines;
};

} // namespace

std::vector<TitleSheet::Line> TitleSheet::lines(const TitlePage& title, QSizeF area) {
    const QFont plain = reportFont(textPoints), strong = reportFont(titlePoints, true);
    Column column(0, 0, area.width());
    for (const QString& line : title.above) {
        column.add(line, plain, Qt::AlignHCenter);
    }
    column.skip(std::max(groupsApart, titleAt * area.height() - column.bottom()));
    column.add(title.document.toUpper(), reportFont(documentPoints, true), Qt::AlignHCenter);
    for (const QString& line : title.title) {
        column.add(line, strong, Qt::AlignHCenter);
    }
    const double from = peopleFrom * area.width();
    Column people(from, column.bottom() + 2 * groupsApart, area.width() - from);
    for (const auto& [part, who] : title.people) {
        people.add(part, plain, Qt::AlignLeft);
        people.add(who, plain, Qt::AlignLeft);
        people.skip(betweenLines);
    }
    std::vector<Line> all = std::move(column.lines());
    all.insert(all.end(), people.lines().begin(), people.lines().end());
    const TextBox below(title.below, plain, area.width(), Qt::AlignHCenter);
    all.push_back({below, 0, area.height() - below.height()});
    return all;
}

} // namespace sparkout::report
