// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/odt.h"

#include "core/workbook/zip_writer.h"
#include "ui/report/format/formula_writer.h"
#include "ui/report/format/odt_xml.h"

#include <QBuffer>
#include <QColor>
#include <QImage>
#include <QPainter>

#include <algorithm>
#include <numeric>
#include <utility>

namespace sparkout::report {

namespace {

/// Text widths between the margins.
constexpr double upright_mm = 180, landscape_mm = 272, standard_mm = 165;
constexpr double mostFormFigure_mm = 118; ///< greatest height below the head of a form
constexpr QColor paperColour(255, 255, 255);
constexpr int pixelsPerUnit = 2;                        ///< pixels per unit of a figure
constexpr qsizetype leastLetters = 4, mostLetters = 40; ///< limits of the width of a column
constexpr const char* mimeType = "application/vnd.oasis.opendocument.text";

using Attributes = OdtXml::Attributes;

struct Picture {
    QByteArray name, bytes;
};

/// Widths of a table's columns as shares of the page.
std::vector<double> sharesOf(const Table& table) {
    std::vector<double> shares = table.widths;
    if (shares.empty()) {
        shares.resize(static_cast<std::size_t>(table.head.size()), double(leastLetters));
        const auto raise = [&shares](const QStringList& cells, bool wholeWords) {
            for (qsizetype c = 0; c < cells.size(); ++c) {
                qsizetype longest = wholeWords ? 0 : cells[c].size();
                for (const QString& word : cells[c].split(u' ')) {
                    longest = std::max(longest, word.size());
                }
                double& share = shares.at(static_cast<std::size_t>(c));
                share = std::max(share, double(std::min(longest, mostLetters)));
            }
        };
        raise(table.head, true);
        for (const QStringList& row : table.rows) {
            raise(row, false);
        }
    }
    const double sum = std::reduce(shares.begin(), shares.end());
    for (double& share : shares) {
        share /= sum;
    }
    return shares;
}

/// Writes the blocks; the styles of columns are collected, since they precede the blocks.
class Body {
public:
    Body(OdtXml& xml, const Report& report, double width_mm, const OdtForms& forms)
        : m_xml(xml), m_report(report), m_width_mm(width_mm), m_forms(forms) {}

    void operator()(const Heading& heading) {
        OdtStandard::writeHeading(m_xml, heading, m_headings++);
    }
    void operator()(const Paragraph& paragraph) {
        const char* const style = paragraph.strong ? "Strong" : "Body";
        if (paragraph.symbols) {
            m_xml.symbols(style, paragraph.text);
        } else {
            m_xml.paragraph(style, paragraph.text);
        }
    }
    void operator()(const Facts& facts) {
        Table table;
        table.widths = {2, 3, 2, 3};
        table.texts.assign(4, true);
        for (std::size_t i = 0; i < facts.facts.size(); i += 2) {
            const auto second =
                i + 1 < facts.facts.size() ? facts.facts[i + 1] : std::pair<QString, QString>();
            table.rows.push_back(
                {facts.facts[i].first, facts.facts[i].second, second.first, second.second});
        }
        write(table, true);
    }
    void operator()(const Table& table) {
        if (!table.caption.isEmpty()) {
            m_xml.paragraph("TableCaption", captionOf(table));
        }
        write(table, false);
    }
    void operator()(const Figure& figure) {
        const QString name = keep(drawn(figure), "figure");
        if (!name.isEmpty()) {
            const double ratio = figure.size.height() / figure.size.width();
            const double width_mm =
                m_forms.isEmpty() ? m_width_mm : std::min(m_width_mm, mostFormFigure_mm / ratio);
            m_xml.begin("text:p");
            m_xml.attribute("text:style-name", QStringLiteral("Figure"));
            m_xml.begin("draw:frame");
            m_xml.attribute("draw:name", name);
            m_xml.attribute("text:anchor-type", QStringLiteral("as-char"));
            m_xml.attribute("svg:width", OdtXml::millimetres(width_mm));
            m_xml.attribute("svg:height", OdtXml::millimetres(width_mm * ratio));
            m_xml.empty("draw:image",
                        {{QStringLiteral("xlink:href"), name},
                         {QStringLiteral("xlink:type"), QStringLiteral("simple")},
                         {QStringLiteral("xlink:show"), QStringLiteral("embed")},
                         {QStringLiteral("xlink:actuate"), QStringLiteral("onLoad")}});
            m_xml.begin("svg:desc");
            m_xml.text(figure.description);
            m_xml.end();
            m_xml.end();
            m_xml.end();
        }
        m_xml.paragraph("Caption", figure.caption);
    }
    void operator()(const Formula& formula) {
        m_xml.symbols("Formula", inOneLine(formula) + QStringLiteral("    ") + formula.label);
    }
    void operator()(const FormHead&) {
        m_forms.writeHead(m_xml, m_heads++,
                          [this](const QImage& image) { return keep(image, "logo"); });
        m_xml.paragraph("Gap", {});
    }
    void operator()(const PageBreak&) { m_xml.paragraph("Break", {}); }
    void operator()(const Blank& blank) {
        for (int line = 0; line < blank.lines; ++line) {
            m_xml.paragraph("Blank", {});
        }
    }
    void operator()(const TitlePage& title) { OdtStandard::writeTitle(m_xml, title); }
    void operator()(const Contents& contents) {
        OdtStandard::writeContents(m_xml, contents, m_report);
    }

    [[nodiscard]] const std::vector<Picture>& pictures() const { return m_pictures; }

    /// The styles of the columns of a report's tables, in their order.
    static void writeStyles(OdtXml& xml, const Report& report, double width_mm);

private:
    static QImage drawn(const Figure& figure) {
        QImage image((figure.size * pixelsPerUnit).toSize(), QImage::Format_RGB32);
        image.fill(paperColour);
        QPainter painter(&image);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.scale(pixelsPerUnit, pixelsPerUnit);
        figure.paint(painter);
        return image;
    }

    /// Its name in the document; empty if it cannot be written.
    QString keep(const QImage& image, const char* kind) {
        QByteArray bytes;
        QBuffer buffer(&bytes);
        if (!buffer.open(QIODevice::WriteOnly) || !image.save(&buffer, "PNG")) {
            return {};
        }
        const QByteArray name = QByteArray("Pictures/") + kind
                                + QByteArray::number(qsizetype(m_pictures.size()) + 1) + ".png";
        m_pictures.push_back({name, bytes});
        return QString::fromLatin1(name);
    }

    /// The number of columns that a text spans.
    [[nodiscard]] std::size_t spreadOf(const QStringList& cells, const Table& table,
                                       std::size_t column) const {
        const auto [from, to] = table.spread;
        if (m_forms.isEmpty() || column != from || to <= from) {
            return 1;
        }
        const QStringList beside =
            cells.mid(static_cast<qsizetype>(from) + 1, static_cast<qsizetype>(to - from) - 1);
        return std::ranges::all_of(beside, [](const QString& cell) { return cell == u"–"; })
                   ? to - from
                   : 1;
    }

    void row(const QStringList& cells, const Table& table, bool head, bool names) {
        m_xml.begin("table:table-row");
        m_xml.attribute("table:style-name", QStringLiteral("Row"));
        for (qsizetype c = 0; c < cells.size(); ++c) {
            const auto i = static_cast<std::size_t>(c);
            const bool isText = i < table.texts.size() && table.texts[i];
            m_xml.begin("table:table-cell");
            m_xml.attribute("table:style-name", QStringLiteral("Cell"));
            m_xml.attribute("office:value-type", QStringLiteral("string"));
            const std::size_t spread = spreadOf(cells, table, i);
            if (spread > 1) {
                m_xml.attribute("table:number-columns-spanned", QString::number(spread));
            }
            m_xml.paragraph(head || (names && c % 2 == 0) ? "Head"
                            : isText || c == 0            ? "Text"
                                                          : "Number",
                            !m_forms.isEmpty() && cells[c] == u"–" ? QString() : cells[c]);
            m_xml.end();
            for (std::size_t covered = 1; covered < spread; ++covered, ++c) {
                m_xml.empty("table:covered-table-cell", {});
            }
        }
        m_xml.end();
    }
    void write(const Table& table, bool names) {
        const QString name = QStringLiteral("Table%1").arg(++m_tables);
        m_xml.begin("table:table");
        m_xml.attribute("table:name", name);
        m_xml.attribute("table:style-name", QStringLiteral("Table"));
        const std::size_t columns = names ? table.widths.size() : std::size_t(table.head.size());
        for (std::size_t c = 0; c < columns; ++c) {
            m_xml.empty("table:table-column", {{QStringLiteral("table:style-name"),
                                                name + QStringLiteral(".%1").arg(c + 1)}});
        }
        if (!names) {
            m_xml.begin("table:table-header-rows");
            row(table.head, table, true, false);
            m_xml.end();
        }
        for (const QStringList& cells : table.rows) {
            row(cells, table, false, names);
        }
        m_xml.end();
        m_xml.paragraph("Gap", {});
    }

    OdtXml& m_xml;
    const Report& m_report;
    double m_width_mm;
    const OdtForms& m_forms; ///< in a form, cells without a value are empty instead of struck out
    std::size_t m_heads = 0, m_headings = 0;
    int m_tables = 0;
    std::vector<Picture> m_pictures;
};

void Body::writeStyles(OdtXml& xml, const Report& report, double width_mm) {
    int tables = 0;
    for (const Block& block : report.blocks) {
        std::vector<double> shares;
        if (std::holds_alternative<Facts>(block)) {
            shares = {0.2, 0.3, 0.2, 0.3};
        } else if (const auto* table = std::get_if<Table>(&block)) {
            shares = sharesOf(*table);
        } else {
            continue;
        }
        ++tables;
        for (std::size_t c = 0; c < shares.size(); ++c) {
            xml.begin("style:style");
            xml.attribute("style:name", QStringLiteral("Table%1.%2").arg(tables).arg(c + 1));
            xml.attribute("style:family", QStringLiteral("table-column"));
            xml.empty("style:table-column-properties",
                      {{QStringLiteral("style:column-width"),
                        OdtXml::millimetres(shares[c] * width_mm)}});
            xml.end();
        }
    }
}

QByteArray contentOf(const Report& report, const OdtForms& forms, double width_mm,
                     std::vector<Picture>& pictures) {
    OdtXml xml("office:document-content");
    xml.attribute("office:version", QStringLiteral("1.2"));
    xml.begin("office:automatic-styles");
    xml.begin("style:style");
    xml.attribute("style:name", QStringLiteral("Table"));
    xml.attribute("style:family", QStringLiteral("table"));
    xml.empty("style:table-properties",
              {{QStringLiteral("style:width"), OdtXml::millimetres(width_mm)},
               {QStringLiteral("table:align"), QStringLiteral("margins")},
               {QStringLiteral("table:border-model"), QStringLiteral("collapsing")}});
    xml.end();
    xml.begin("style:style");
    xml.attribute("style:name", QStringLiteral("Cell"));
    xml.attribute("style:family", QStringLiteral("table-cell"));
    xml.empty("style:table-cell-properties",
              {{QStringLiteral("fo:border"), QStringLiteral("0.3mm solid #000000")},
               {QStringLiteral("fo:padding"), QStringLiteral("0.7mm")},
               {QStringLiteral("style:vertical-align"), QStringLiteral("middle")}});
    xml.end();
    xml.begin("style:style"); // no row is parted
    xml.attribute("style:name", QStringLiteral("Row"));
    xml.attribute("style:family", QStringLiteral("table-row"));
    xml.empty("style:table-row-properties",
              {{QStringLiteral("fo:keep-together"), QStringLiteral("always")}});
    xml.end();
    Body::writeStyles(xml, report, width_mm);
    forms.writeStyles(xml);
    xml.end();
    xml.begin("office:body");
    xml.begin("office:text");
    if (forms.isEmpty() && report.style == PageStyle::sheet) {
        xml.paragraph("Title", report.title);
        xml.paragraph("Body", report.subject);
    }
    Body body(xml, report, width_mm, forms);
    for (const Block& block : report.blocks) {
        std::visit(body, block);
    }
    pictures = body.pictures();
    return xml.finish();
}

/// Styles of paragraphs on the program's own sheets.
void writeSheetStyles(OdtXml& xml, const Report& report) {
    xml.begin("style:default-style");
    xml.attribute("style:family", QStringLiteral("paragraph"));
    xml.empty("style:text-properties",
              {{QStringLiteral("fo:font-family"), QStringLiteral("DejaVu Sans Condensed")},
               {QStringLiteral("fo:font-size"), QStringLiteral("9pt")},
               {QStringLiteral("fo:language"), report.language},
               {QStringLiteral("fo:country"),
                report.language == u"ru" ? QStringLiteral("RU") : QStringLiteral("GB")}});
    xml.end();
    const auto size = [](const char* points) {
        return std::pair(QStringLiteral("fo:font-size"), QString::fromLatin1(points));
    };
    const std::pair bold(QStringLiteral("fo:font-weight"), QStringLiteral("bold"));
    const std::pair above(QStringLiteral("fo:margin-top"), QStringLiteral("3mm"));
    const std::pair below(QStringLiteral("fo:margin-bottom"), QStringLiteral("1.5mm"));
    const std::pair withNext(QStringLiteral("fo:keep-with-next"), QStringLiteral("always"));
    const auto align = [](const char* where) {
        return std::pair(QStringLiteral("fo:text-align"), QString::fromLatin1(where));
    };
    xml.paragraphStyle("Title", {below}, {size("15pt"), bold});
    xml.paragraphStyle("Heading", {above, below, withNext}, {size("11pt"), bold});
    xml.paragraphStyle("Body", {below}, {});
    xml.paragraphStyle("Strong", {below}, {bold});
    xml.paragraphStyle("Head", {}, {size("7.5pt")});
    xml.paragraphStyle("Text", {align("start")}, {});
    xml.paragraphStyle("Number", {align("end")}, {});
    xml.paragraphStyle("Formula", {below}, {});
    xml.paragraphStyle("Figure", {align("center"), withNext}, {});
    xml.paragraphStyle("Caption", {align("center"), below}, {size("7.5pt")});
    xml.paragraphStyle("Gap", {}, {size("4pt")});
    xml.paragraphStyle("FormNumber", {align("end")}, {size("6pt")});
    xml.paragraphStyle("FormCaption", {align("center")}, {size("6pt")});
    xml.paragraphStyle("FormEntry", {align("center")}, {size("8pt")});
    xml.paragraphStyle("Break", {{QStringLiteral("fo:break-before"), QStringLiteral("page")}}, {});
    xml.paragraphStyle("Subheading", {above, below, withNext}, {size("10pt"), bold});
    xml.paragraphStyle("TableCaption", {above, withNext}, {});
    xml.paragraphStyle("Blank",
                       {{QStringLiteral("fo:border-bottom"), QStringLiteral("0.1mm solid #969696")},
                        {QStringLiteral("fo:padding-top"), QStringLiteral("5mm")}},
                       {});
}

QByteArray stylesOf(const Report& report, const OdtForms& forms, bool landscape) {
    OdtXml xml("office:document-styles");
    xml.attribute("office:version", QStringLiteral("1.2"));
    xml.begin("office:styles");
    const bool isStandard = report.style == PageStyle::standard;
    if (isStandard) {
        OdtStandard::writeStyles(xml, report.language);
    } else {
        writeSheetStyles(xml, report);
    }
    OdtStandard::writeIndexStyle(xml);
    xml.end();
    xml.begin("office:automatic-styles");
    if (isStandard) {
        OdtStandard::writePages(xml);
        return xml.finish();
    }
    forms.writePageStyles(xml);
    xml.begin("style:page-layout");
    xml.attribute("style:name", QStringLiteral("Paper"));
    const QString longer = QStringLiteral("297mm"), shorter = QStringLiteral("210mm");
    xml.empty("style:page-layout-properties",
              {{QStringLiteral("fo:page-width"), landscape ? longer : shorter},
               {QStringLiteral("fo:page-height"), landscape ? shorter : longer},
               {QStringLiteral("style:print-orientation"),
                landscape ? QStringLiteral("landscape") : QStringLiteral("portrait")},
               {QStringLiteral("fo:margin-left"),
                landscape ? QStringLiteral("20mm") : QStringLiteral("18mm")},
               {QStringLiteral("fo:margin-right"),
                landscape ? QStringLiteral("5mm") : QStringLiteral("12mm")},
               {QStringLiteral("fo:margin-top"), QStringLiteral("10mm")},
               {QStringLiteral("fo:margin-bottom"), QStringLiteral("10mm")}});
    // A footer has a fixed height: symbol and name of a form with the line below them.
    for (const auto& [style, height] :
         {std::pair("style:header-style", "5mm"), std::pair("style:footer-style", "9mm")}) {
        xml.begin(style);
        xml.empty("style:header-footer-properties",
                  {{QStringLiteral("fo:min-height"), QString::fromLatin1(height)}});
        xml.end();
    }
    xml.end();
    xml.end();
    xml.begin("office:master-styles");
    forms.writePages(xml, QStringLiteral("Paper"), report.origin());
    xml.begin("style:master-page");
    xml.attribute("style:name", QStringLiteral("Standard"));
    xml.attribute("style:page-layout-name", QStringLiteral("Paper"));
    xml.begin("style:footer");
    xml.begin("text:p");
    xml.attribute("text:style-name", QStringLiteral("Caption"));
    xml.text(report.origin() + QStringLiteral(" · "));
    xml.empty("text:page-number",
              {{QStringLiteral("text:select-page"), QStringLiteral("current")}});
    return xml.finish();
}

QByteArray metaOf(const Report& report) {
    OdtXml xml("office:document-meta");
    xml.attribute("office:version", QStringLiteral("1.2"));
    xml.begin("office:meta");
    const std::pair<const char*, QString> all[] = {
        {"dc:title", report.title},
        {"dc:subject", report.subject},
        {"dc:creator", report.author},
        {"dc:language", report.language},
        {"dc:date", report.date.toString(Qt::ISODate) + QStringLiteral("T00:00:00")},
        {"meta:generator", report.program}};
    for (const auto& [name, value] : all) {
        xml.begin(name);
        xml.text(value);
        xml.end();
    }
    return xml.finish();
}

QByteArray manifestOf(const std::vector<Picture>& pictures) {
    OdtXml xml("manifest:manifest");
    xml.attribute("manifest:version", QStringLiteral("1.2"));
    const auto add = [&xml](const QString& path, const char* type) {
        xml.empty("manifest:file-entry",
                  {{QStringLiteral("manifest:full-path"), path},
                   {QStringLiteral("manifest:media-type"), QString::fromLatin1(type)}});
    };
    add(QStringLiteral("/"), mimeType);
    for (const char* name : {"content.xml", "styles.xml", "meta.xml"}) {
        add(QString::fromLatin1(name), "text/xml");
    }
    for (const Picture& picture : pictures) {
        add(QString::fromLatin1(picture.name), "image/png");
    }
    return xml.finish();
}

} // namespace

QByteArray odt(const Report& report) {
    const bool landscape = !report.sheets.empty();
    std::vector<Picture> pictures;
    const OdtForms forms(report);
    const QByteArray content = contentOf(report, forms,
                                         landscape                             ? landscape_mm
                                         : report.style == PageStyle::standard ? standard_mm
                                                                               : upright_mm,
                                         pictures);
    ZipWriter zip;
    zip.addStored("mimetype", mimeType); // first and uncompressed: it identifies the file
    const auto add = [&zip](const QByteArray& name, const QByteArray& bytes) {
        zip.begin({name.constData(), std::size_t(name.size())});
        zip.add({bytes.constData(), std::size_t(bytes.size())});
        zip.end();
    };
    add("content.xml", content);
    add("styles.xml", stylesOf(report, forms, landscape));
    add("meta.xml", metaOf(report));
    for (const Picture& picture : pictures) {
        add(picture.name, picture.bytes);
    }
    add("META-INF/manifest.xml", manifestOf(pictures));
    return QByteArray::fromStdString(zip.finish());
}

} // namespace sparkout::report
