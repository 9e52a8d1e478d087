// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/odt_xml.h"

#include "ui/text/texts.h"

#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <numeric>
#include <variant>

namespace sparkout::report {

namespace {

const std::pair<const char*, const char*> namespaces[] = {
    {"office", "urn:oasis:names:tc:opendocument:xmlns:office:1.0"},
    {"style", "urn:oasis:names:tc:opendocument:xmlns:style:1.0"},
    {"text", "urn:oasis:names:tc:opendocument:xmlns:text:1.0"},
    {"table", "urn:oasis:names:tc:opendocument:xmlns:table:1.0"},
    {"draw", "urn:oasis:names:tc:opendocument:xmlns:drawing:1.0"},
    {"fo", "urn:oasis:names:tc:opendocument:xmlns:xsl-fo-compatible:1.0"},
    {"svg", "urn:oasis:names:tc:opendocument:xmlns:svg-compatible:1.0"},
    {"xlink", "http://www.w3.org/1999/xlink"},
    {"dc", "http://purl.org/dc/elements/1.1/"},
    {"meta", "urn:oasis:names:tc:opendocument:xmlns:meta:1.0"},
    {"manifest", "urn:oasis:names:tc:opendocument:xmlns:manifest:1.0"},
};

} // namespace

QString OdtXml::millimetres(double value) {
    return QString::number(value, 'f', 2) + QStringLiteral("mm");
}

OdtXml::OdtXml(const char* root) : m_writer(&m_bytes) {
    m_writer.writeStartDocument();
    begin(root);
    for (const auto& [prefix, uri] : namespaces) {
        m_writer.writeAttribute(QStringLiteral("xmlns:") + QString::fromLatin1(prefix),
                                QString::fromLatin1(uri));
    }
}

void OdtXml::attribute(const char* name, const QString& value) {
    m_writer.writeAttribute(QString::fromLatin1(name), value);
}

void OdtXml::begin(const char* name) {
    m_writer.writeStartElement(QString::fromLatin1(name));
}

void OdtXml::end() {
    m_writer.writeEndElement();
}

void OdtXml::text(const QString& text) {
    m_writer.writeCharacters(harmlessText(text));
}

void OdtXml::empty(const char* name, const Attributes& attributes) {
    begin(name);
    for (const auto& [key, value] : attributes) {
        m_writer.writeAttribute(key, value);
    }
    end();
}

void OdtXml::paragraph(const char* style, const QString& text, const char* element) {
    begin(element);
    attribute("text:style-name", QString::fromLatin1(style));
    if (qstrcmp(element, "text:h") == 0) {
        attribute("text:outline-level", QStringLiteral("1"));
    }
    const QStringList lines = text.split(u'\n');
    for (qsizetype i = 0; i < lines.size(); ++i) {
        if (i > 0) {
            empty("text:line-break", {});
        }
        this->text(lines[i]);
    }
    end();
}

void OdtXml::symbols(const char* style, const QString& text) {
    static const QRegularExpression index(QStringLiteral("_(\\w+)"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    begin("text:p");
    attribute("text:style-name", QString::fromLatin1(style));
    const QStringList lines = text.split(u'\n');
    for (qsizetype i = 0; i < lines.size(); ++i) {
        if (i > 0) {
            empty("text:line-break", {});
        }
        qsizetype from = 0;
        for (auto it = index.globalMatch(lines[i]); it.hasNext();) {
            const auto match = it.next();
            this->text(lines[i].mid(from, match.capturedStart() - from));
            begin("text:span");
            attribute("text:style-name", QStringLiteral("Index"));
            this->text(match.captured(1));
            end();
            from = match.capturedEnd();
        }
        this->text(lines[i].mid(from));
    }
    end();
}

void OdtXml::paragraphStyle(const char* name, const Attributes& paragraph, const Attributes& text) {
    begin("style:style");
    attribute("style:name", QString::fromLatin1(name));
    attribute("style:family", QStringLiteral("paragraph"));
    empty("style:paragraph-properties", paragraph);
    empty("style:text-properties", text);
    end();
}

QByteArray OdtXml::finish() {
    m_writer.writeEndDocument();
    return m_bytes;
}

namespace {

using Attribute = std::pair<QString, QString>;

Attribute attribute(const char* name, const char* value) {
    return {QString::fromLatin1(name), QString::fromLatin1(value)};
}

QString bookmarkOf(std::size_t heading) {
    return QStringLiteral("heading%1").arg(heading + 1);
}

void writePaper(OdtXml& xml, const char* name) {
    xml.begin("style:page-layout");
    xml.attribute("style:name", QString::fromLatin1(name));
    xml.empty("style:page-layout-properties",
              {attribute("fo:page-width", "210mm"), attribute("fo:page-height", "297mm"),
               attribute("style:print-orientation", "portrait"),
               attribute("fo:margin-left", "30mm"), attribute("fo:margin-right", "15mm"),
               attribute("fo:margin-top", "20mm"), attribute("fo:margin-bottom", "10mm")});
    xml.begin("style:footer-style");
    xml.empty("style:header-footer-properties", {attribute("fo:min-height", "10mm")});
    xml.end();
    xml.end();
}

} // namespace

void OdtStandard::writeStyles(OdtXml& xml, const QString& language) {
    xml.begin("style:default-style");
    xml.attribute("style:family", QStringLiteral("paragraph"));
    xml.empty("style:text-properties", {attribute("fo:font-family", "Times New Roman"),
                                        attribute("fo:font-size", "14pt"),
                                        {QStringLiteral("fo:language"), language},
                                        attribute("fo:country", language == u"ru" ? "RU" : "GB")});
    xml.end();
    const Attribute bold = attribute("fo:font-weight", "bold");
    const Attribute capitals = attribute("fo:text-transform", "uppercase");
    const Attribute withNext = attribute("fo:keep-with-next", "always");
    const Attribute onPage = attribute("fo:break-before", "page");
    const Attribute indent = attribute("fo:text-indent", "12.5mm");
    const Attribute spacing = attribute("fo:line-height", "150%");
    const Attribute centred = attribute("fo:text-align", "center");
    const Attribute below = attribute("fo:margin-bottom", "4mm");
    const Attribute above = attribute("fo:margin-top", "4mm");
    const Attribute small = attribute("fo:font-size", "12pt");
    xml.paragraphStyle("Heading", {onPage, indent, below, withNext}, {bold});
    xml.paragraphStyle("Subheading", {indent, above, below, withNext}, {bold});
    xml.paragraphStyle("Part", {onPage, centred, below, withNext}, {bold, capitals});
    xml.paragraphStyle("Body", {indent, spacing, attribute("fo:text-align", "justify")}, {});
    xml.paragraphStyle("Strong", {indent, spacing}, {bold});
    xml.paragraphStyle("Head", {centred}, {small});
    xml.paragraphStyle("Text", {attribute("fo:text-align", "start")}, {small});
    xml.paragraphStyle("Number", {attribute("fo:text-align", "end")}, {small});
    xml.paragraphStyle("Formula", {centred, above, below}, {});
    xml.paragraphStyle("Figure", {centred, above, withNext}, {});
    xml.paragraphStyle("Caption", {centred, below}, {small});
    xml.paragraphStyle("TableCaption", {above, withNext}, {small});
    xml.paragraphStyle("Gap", {}, {attribute("fo:font-size", "6pt")});
    xml.paragraphStyle("Break", {onPage}, {});
    xml.paragraphStyle(
        "Blank",
        {attribute("fo:border-bottom", "0.1mm solid #969696"), attribute("fo:padding-top", "4mm")},
        {});
    xml.paragraphStyle("PageNumber", {centred}, {small});
    xml.paragraphStyle("TitleAbove", {centred}, {});
    xml.paragraphStyle("TitleDocument", {centred, attribute("fo:margin-top", "50mm"), below},
                       {bold, capitals, attribute("fo:font-size", "16pt")});
    xml.paragraphStyle("TitleName", {centred}, {bold});
    xml.paragraphStyle("TitlePart", {attribute("fo:margin-left", "75mm"), above}, {small});
    xml.paragraphStyle("TitlePerson", {attribute("fo:margin-left", "75mm")}, {});
    xml.paragraphStyle("TitleBelow", {centred, attribute("fo:margin-top", "40mm")}, {});
    xml.paragraphStyle("ContentsTitle", {onPage, centred, below}, {bold, capitals});
    xml.begin("style:style");
    xml.attribute("style:name", QStringLiteral("ContentsEntry"));
    xml.attribute("style:family", QStringLiteral("paragraph"));
    xml.begin("style:paragraph-properties");
    xml.attribute("fo:margin-bottom", QStringLiteral("2mm"));
    xml.begin("style:tab-stops");
    xml.empty("style:tab-stop",
              {attribute("style:position", "165mm"), attribute("style:type", "right"),
               attribute("style:leader-style", "dotted"), attribute("style:leader-text", ".")});
    xml.end();
    xml.end();
    xml.end();
    // Its first paragraph starts the page without a number.
    xml.begin("style:style");
    xml.attribute("style:name", QStringLiteral("TitleFirst"));
    xml.attribute("style:family", QStringLiteral("paragraph"));
    xml.attribute("style:master-page-name", QStringLiteral("First"));
    xml.empty("style:paragraph-properties", {attribute("fo:text-align", "center")});
    xml.end();
}

void OdtStandard::writeIndexStyle(OdtXml& xml) {
    xml.begin("style:style");
    xml.attribute("style:name", QStringLiteral("Index"));
    xml.attribute("style:family", QStringLiteral("text"));
    xml.empty("style:text-properties", {attribute("style:text-position", "sub 70%")});
    xml.end();
}

void OdtStandard::writePages(OdtXml& xml) {
    writePaper(xml, "Paper");
    xml.end();
    xml.begin("office:master-styles");
    xml.empty("style:master-page",
              {attribute("style:name", "First"), attribute("style:page-layout-name", "Paper"),
               attribute("style:next-style-name", "Standard")});
    xml.begin("style:master-page");
    xml.attribute("style:name", QStringLiteral("Standard"));
    xml.attribute("style:page-layout-name", QStringLiteral("Paper"));
    xml.begin("style:footer");
    xml.begin("text:p");
    xml.attribute("text:style-name", QStringLiteral("PageNumber"));
    xml.empty("text:page-number", {attribute("text:select-page", "current")});
}

void OdtStandard::writeHeading(OdtXml& xml, const Heading& heading, std::size_t number) {
    const bool isBelow = heading.level == Heading::Level::subsection;
    xml.begin("text:h");
    xml.attribute("text:style-name", heading.level == Heading::Level::part ? QStringLiteral("Part")
                                     : isBelow ? QStringLiteral("Subheading")
                                               : QStringLiteral("Heading"));
    xml.attribute("text:outline-level", isBelow ? QStringLiteral("2") : QStringLiteral("1"));
    const Attribute name{QStringLiteral("text:name"), bookmarkOf(number)};
    xml.empty("text:bookmark-start", {name});
    xml.text(heading.text);
    xml.empty("text:bookmark-end", {name});
    xml.end();
}

void OdtStandard::writeTitle(OdtXml& xml, const TitlePage& title) {
    const char* style = "TitleFirst";
    for (const QString& line : title.above) {
        xml.paragraph(style, line);
        style = "TitleAbove";
    }
    if (title.above.isEmpty()) {
        xml.paragraph(style, {});
    }
    xml.paragraph("TitleDocument", title.document);
    for (const QString& line : title.title) {
        xml.paragraph("TitleName", line);
    }
    for (const auto& [part, who] : title.people) {
        xml.paragraph("TitlePart", part);
        xml.paragraph("TitlePerson", who);
    }
    xml.paragraph("TitleBelow", title.below);
}

void OdtStandard::writeContents(OdtXml& xml, const Contents& contents, const Report& report) {
    xml.paragraph("ContentsTitle", contents.title);
    std::size_t number = 0;
    for (const Block& block : report.blocks) {
        const auto* heading = std::get_if<Heading>(&block);
        if (!heading) {
            continue;
        }
        xml.begin("text:p");
        xml.attribute("text:style-name", QStringLiteral("ContentsEntry"));
        xml.text(heading->text);
        xml.empty("text:tab", {});
        xml.begin("text:bookmark-ref");
        xml.attribute("text:reference-format", QStringLiteral("page"));
        xml.attribute("text:ref-name", bookmarkOf(number++));
        xml.text(QStringLiteral("…"));
        xml.end();
        xml.end();
    }
}

namespace {

constexpr double pictureHeight_mm = 5, symbolWidth_mm = 20;

QString pageName(std::size_t form) {
    return QStringLiteral("Form%1").arg(form + 1);
}
QString followingName(std::size_t form) {
    return pageName(form) + QStringLiteral("_Next");
}
QString footName(std::size_t form) {
    return pageName(form) + QStringLiteral("Foot");
}

void writeTableStyle(OdtXml& xml, const char* name, const char* family, const char* properties,
                     const OdtXml::Attributes& attributes) {
    xml.begin("style:style");
    xml.attribute("style:name", QString::fromLatin1(name));
    xml.attribute("style:family", QString::fromLatin1(family));
    xml.empty(properties, attributes);
    xml.end();
}

/// The styles of a form's tables and cells.
void writeFormStyles(OdtXml& xml) {
    writeTableStyle(xml, "FormTable", "table", "style:table-properties",
                    {{QStringLiteral("table:align"), QStringLiteral("margins")},
                     {QStringLiteral("table:border-model"), QStringLiteral("collapsing")}});
    writeTableStyle(xml, "FormCell", "table-cell", "style:table-cell-properties",
                    {{QStringLiteral("fo:border"), QStringLiteral("0.3mm solid #000000")},
                     {QStringLiteral("fo:padding"), QStringLiteral("0.25mm")},
                     {QStringLiteral("style:vertical-align"), QStringLiteral("middle")}});
}

} // namespace

OdtForms::OdtForms(const Report& report) {
    for (const Block& block : report.blocks) {
        if (const auto* head = std::get_if<FormHead>(&block)) {
            m_heads.push_back(head);
        }
    }
}

QString OdtForms::tableName(std::size_t form, std::size_t grid) {
    return pageName(form) + QStringLiteral("Head%1").arg(grid + 1);
}

FormGrid OdtForms::foot(std::size_t form) const {
    const FormHead& head = *m_heads[form];
    const std::vector<double>& widths = head.following.widths_mm;
    const double whole = std::reduce(widths.begin(), widths.end());
    return {{symbolWidth_mm, std::max(whole - symbolWidth_mm, symbolWidth_mm)},
            {{FormCell{{}, head.symbol}, FormCell{{}, head.name}}}};
}

void OdtForms::writeColumns(OdtXml& xml, const QString& table, const FormGrid& grid) {
    for (std::size_t c = 0; c < grid.widths_mm.size(); ++c) {
        xml.begin("style:style");
        xml.attribute("style:name", table + QStringLiteral(".%1").arg(c + 1));
        xml.attribute("style:family", QStringLiteral("table-column"));
        xml.empty("style:table-column-properties",
                  {{QStringLiteral("style:column-width"), OdtXml::millimetres(grid.widths_mm[c])}});
        xml.end();
    }
}

void OdtForms::writeStyles(OdtXml& xml) const {
    if (isEmpty()) {
        return;
    }
    writeFormStyles(xml);
    for (std::size_t form = 0; form < m_heads.size(); ++form) {
        xml.begin("style:style"); // the paragraph above the head begins a sheet
        xml.attribute("style:name", pageName(form));
        xml.attribute("style:family", QStringLiteral("paragraph"));
        xml.attribute("style:parent-style-name", QStringLiteral("FormNumber"));
        xml.attribute("style:master-page-name", pageName(form));
        xml.end();
        for (std::size_t g = 0; g < m_heads[form]->grids.size(); ++g) {
            writeColumns(xml, tableName(form, g), m_heads[form]->grids[g]);
        }
    }
}

void OdtForms::writeCell(OdtXml& xml, const FormCell& cell, const KeepPicture& keep) {
    if (!cell.caption.isEmpty()) {
        xml.paragraph("FormCaption", cell.caption);
        if (cell.value.isEmpty() && cell.picture.isNull() && cell.count == FormCell::Count::none
            && cell.rows == 1 && cell.columns == 1) {
            return; // only a name, for instance of a signatory
        }
    }
    xml.begin("text:p");
    xml.attribute("text:style-name", QStringLiteral("FormEntry"));
    if (!cell.picture.isNull()) {
        const QSizeF size = cell.picture.size();
        xml.begin("draw:frame");
        xml.attribute("text:anchor-type", QStringLiteral("as-char"));
        xml.attribute("svg:height", OdtXml::millimetres(pictureHeight_mm));
        xml.attribute("svg:width",
                      OdtXml::millimetres(pictureHeight_mm * size.width() / size.height()));
        xml.empty("draw:image", {{QStringLiteral("xlink:href"), keep(cell.picture)},
                                 {QStringLiteral("xlink:type"), QStringLiteral("simple")},
                                 {QStringLiteral("xlink:show"), QStringLiteral("embed")},
                                 {QStringLiteral("xlink:actuate"), QStringLiteral("onLoad")}});
        xml.end();
        xml.text(QStringLiteral(" "));
    }
    switch (cell.count) {
    case FormCell::Count::none: xml.text(cell.value); break;
    case FormCell::Count::pages: xml.empty("text:page-count", {}); break;
    case FormCell::Count::page:
        xml.empty("text:page-number",
                  {{QStringLiteral("text:select-page"), QStringLiteral("current")}});
        break;
    }
    xml.end();
}

void OdtForms::writeGrid(OdtXml& xml, const QString& table, const FormGrid& grid,
                         const KeepPicture& keep) {
    xml.begin("table:table");
    xml.attribute("table:name", table);
    xml.attribute("table:style-name", QStringLiteral("FormTable"));
    const std::size_t columns = grid.widths_mm.size();
    for (std::size_t c = 0; c < columns; ++c) {
        xml.empty("table:table-column",
                  {{QStringLiteral("table:style-name"), table + QStringLiteral(".%1").arg(c + 1)}});
    }
    std::vector<int> taken(columns, 0); ///< remaining rows of a spanning cell above, by column
    for (const std::vector<FormCell>& row : grid.rows) {
        xml.begin("table:table-row");
        auto next = row.begin();
        for (std::size_t c = 0; c < columns;) {
            if (taken[c] > 0) {
                --taken[c];
                xml.empty("table:covered-table-cell", {});
                ++c;
                continue;
            }
            if (next == row.end()) {
                break;
            }
            const FormCell& cell = *next++;
            xml.begin("table:table-cell");
            xml.attribute("table:style-name", QStringLiteral("FormCell"));
            xml.attribute("office:value-type", QStringLiteral("string"));
            if (cell.columns > 1) {
                xml.attribute("table:number-columns-spanned", QString::number(cell.columns));
            }
            if (cell.rows > 1) {
                xml.attribute("table:number-rows-spanned", QString::number(cell.rows));
            }
            writeCell(xml, cell, keep);
            xml.end();
            const std::size_t end = std::min(columns, c + static_cast<std::size_t>(cell.columns));
            for (std::size_t i = c; i < end; ++i) {
                taken[i] = cell.rows - 1;
                if (i > c) {
                    xml.empty("table:covered-table-cell", {});
                }
            }
            c = end;
        }
        xml.end();
    }
    xml.end();
}

void OdtForms::writeHead(OdtXml& xml, std::size_t form, const KeepPicture& keep) const {
    const FormHead& head = *m_heads.at(form);
    xml.paragraph(qPrintable(pageName(form)), head.number);
    for (std::size_t g = 0; g < head.grids.size(); ++g) {
        writeGrid(xml, tableName(form, g), head.grids[g], keep);
    }
}

void OdtForms::writePageStyles(OdtXml& xml) const {
    if (isEmpty()) {
        return;
    }
    writeFormStyles(xml);
    for (std::size_t form = 0; form < m_heads.size(); ++form) {
        writeColumns(xml, followingName(form), m_heads[form]->following);
        writeColumns(xml, footName(form), foot(form));
    }
}

void OdtForms::writePage(OdtXml& xml, const QString& name, const QString& next,
                         const QString& layout, const std::function<void()>& contents) {
    xml.begin("style:master-page");
    xml.attribute("style:name", name);
    xml.attribute("style:page-layout-name", layout);
    xml.attribute("style:next-style-name", next);
    contents();
    xml.end();
}

void OdtForms::writePages(OdtXml& xml, const QString& layout, const QString& origin) const {
    const KeepPicture none = [](const QImage&) { return QString(); };
    for (std::size_t form = 0; form < m_heads.size(); ++form) {
        const auto footer = [&] {
            xml.begin("style:footer");
            writeGrid(xml, footName(form), foot(form), none);
            xml.paragraph("FormNumber", origin);
            xml.end();
        };
        writePage(xml, pageName(form), followingName(form), layout, footer);
        writePage(xml, followingName(form), followingName(form), layout, [&] {
            xml.begin("style:header");
            writeGrid(xml, followingName(form), m_heads[form]->following, none);
            xml.paragraph("Gap", {});
            xml.end();
            footer();
        });
    }
}

} // namespace sparkout::report
