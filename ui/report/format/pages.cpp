// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/pages.h"

#include "ui/pdf/pdf_details.h"
#include "ui/report/format/page_flow.h"
#include "ui/report/format/page_metrics.h"
#include "ui/report/format/sheet_pieces.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QMarginsF>
#include <QPageLayout>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QPrinter>

#include <algorithm>
#include <optional>

namespace sparkout::report {

namespace {
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

namespace {

/// The project, from which the paper can be opened again.
std::optional<PdfAttachment> attachmentOf(const Report& report) {
    const QString ending = QStringLiteral(".sparkout");
    if (report.inputs.isEmpty()) {
        return std::nullopt;
    }
    const QString base = report.file.isEmpty() ? QStringLiteral("project") : report.file;
    return PdfAttachment{base.endsWith(ending) ? base : base + ending, report.inputs,
                         QCoreApplication::translate("Pages", "Inputs of this document")};
}

} // namespace

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
                       {},
                       {},
                       attachmentOf(report)};
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

} // namespace sparkout::report
