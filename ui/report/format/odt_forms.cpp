// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/odt_forms.h"

#include "ui/report/format/report.h"

#include <algorithm>
#include <numeric>
#include <variant>

namespace sparkout::report {

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
