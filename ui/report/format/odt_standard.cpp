// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/odt_standard.h"

#include <variant>

namespace sparkout::report {

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

} // namespace sparkout::report
