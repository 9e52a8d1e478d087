// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workbook/xlsx_parts.h"

#include "core/printable.h"

#include <algorithm>
#include <charconv>
#include <cmath>

// Pieces of XML: short strings put together, with quotes in them.
// NOLINTBEGIN(modernize-raw-string-literal,performance-inefficient-string-concatenation)

namespace sparkout::xlsx {

namespace {

const std::string start = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
const std::string space = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
const std::string office = "http://schemas.openxmlformats.org/officeDocument/2006/";
const std::string package = "http://schemas.openxmlformats.org/package/2006/";
const std::string sheetKind = "application/vnd.openxmlformats-officedocument.spreadsheetml.";
constexpr int firstOwnFormat = 164; // lower ones are built in

std::string link(int number, const std::string& kind, const std::string& target) {
    return "<Relationship Id=\"rId" + std::to_string(number) + "\" Type=\"" + kind + "\" Target=\""
           + target + "\"/>";
}

std::string links(const std::string& inside) {
    return start + "<Relationships xmlns=\"" + package + "relationships\">" + inside
           + "</Relationships>";
}

std::string part(const std::string& name, const std::string& kind) {
    return "<Override PartName=\"/" + name + "\" ContentType=\"" + kind + "\"/>";
}

std::string cellFormat(int numberFormat, int font, int fill, const std::string& more = "/>") {
    return "<xf numFmtId=\"" + std::to_string(numberFormat) + "\" fontId=\"" + std::to_string(font)
           + "\" fillId=\"" + std::to_string(fill)
           + "\" borderId=\"0\" xfId=\"0\" applyNumberFormat=\"1\" applyFont=\"1\" applyFill=\"1\""
           + more;
}

/// A font of the default size, in black or grey.
std::string font(const std::string& look, const std::string& colour) {
    return "<font>" + look + "<sz val=\"11\"/><color " + colour
           + "/><name val=\"Calibri\"/><family val=\"2\"/></font>";
}

bool isHexDigit(char c) {
    return (c >= '0' && c <= '9') || (c >= 'A' && c <= 'F') || (c >= 'a' && c <= 'f');
}

/// "_x0041_": read as the character with that code.
bool beginsWithEscape(std::string_view text) {
    constexpr std::size_t length = 7;
    return text.size() >= length && text.substr(0, 2) == "_x" && text[length - 1] == '_'
           && std::all_of(text.begin() + 2, text.begin() + length - 1, isHexDigit);
}

/// Appends a character, escaped for XML.
void addEscaped(std::string& xml, std::string_view character) {
    switch (const char c = character.front()) {
    case '<': xml += "&lt;"; break;
    case '>': xml += "&gt;"; break;
    case '&': xml += "&amp;"; break;
    case '"': xml += "&quot;"; break;
    case '\t':
    case '\n': xml += c; break;
    default:
        if (static_cast<unsigned char>(c) < 0x20 || character == "\uFFFE"
            || character == "\uFFFF") {
            xml += ' ';
        } else {
            xml += character;
        }
    }
}

/// 'John''s': a name of a sheet in a formula.
std::string quoted(std::string_view name) {
    std::string text = "'";
    for (const char c : name) {
        text += c == '\'' ? "''" : std::string(1, c);
    }
    return text + '\'';
}

} // namespace

int styleOf(const Column& column) {
    return column.decimals == Column::general ? int(plain)
           : column.decimals == Column::scientific
               ? int(scientific)
               : decimals + std::min(column.decimals, mostDecimals);
}

std::string escaped(std::string_view text) {
    std::string xml;
    xml.reserve(text.size());
    for (std::size_t length = 0; !text.empty() && length < mostTextLength; ++length) {
        std::size_t bytes = characterBytes(text);
        const std::size_t units = bytes == 4 ? 2 : 1;
        // No part of a character, at a cut or in the input.
        if (bytes == 0 || length + units > mostTextLength) {
            bytes = std::max<std::size_t>(bytes, 1);
            xml += '?';
        } else {
            xml += beginsWithEscape(text) ? "_x005F" : "";
            addEscaped(xml, text.substr(0, bytes));
        }
        length += units - 1;
        text.remove_prefix(bytes);
    }
    return xml;
}

std::size_t lengthOf(std::string_view text) {
    std::size_t length = 0;
    for (const char c : text) {
        const auto byte = static_cast<unsigned char>(c);
        length += (byte & 0xC0U) != 0x80U ? 1 : 0; // it begins a character
        length += byte >= 0xF0 ? 1 : 0;
    }
    return length;
}

std::size_t SharedTexts::numberOf(const std::string& text) {
    ++m_uses;
    const auto [found, isNew] = m_numbers.try_emplace(text, m_texts.size());
    if (isNew) {
        m_texts.push_back(&found->first);
    }
    return found->second;
}

std::string SharedTexts::xml() const {
    std::string xml = start + "<sst xmlns=\"" + space + "\" count=\"" + std::to_string(m_uses)
                      + "\" uniqueCount=\"" + std::to_string(m_texts.size()) + "\">";
    for (const std::string* text : m_texts) {
        xml += "<si><t xml:space=\"preserve\">" + escaped(*text) + "</t></si>";
    }
    return xml + "</sst>";
}

std::string contentTypes(std::size_t sheets) {
    std::string xml = start + "<Types xmlns=\"" + package
                      + "content-types\"><Default Extension=\"rels\" "
                        "ContentType=\"application/vnd.openxmlformats-package.relationships+xml\"/>"
                        "<Default Extension=\"xml\" ContentType=\"application/xml\"/>";
    xml += part("docProps/app.xml",
                "application/vnd.openxmlformats-officedocument.extended-properties+xml")
           + part("docProps/core.xml", "application/vnd.openxmlformats-package.core-properties+xml")
           + part("xl/workbook.xml", sheetKind + "sheet.main+xml")
           + part("xl/styles.xml", sheetKind + "styles+xml")
           + part("xl/sharedStrings.xml", sheetKind + "sharedStrings+xml");
    for (std::size_t i = 1; i <= sheets; ++i) {
        xml +=
            part("xl/worksheets/sheet" + std::to_string(i) + ".xml", sheetKind + "worksheet+xml");
    }
    return xml + "</Types>";
}

std::string packageLinks() {
    return links(link(1, office + "relationships/officeDocument", "xl/workbook.xml")
                 + link(2, package + "relationships/metadata/core-properties", "docProps/core.xml")
                 + link(3, office + "relationships/extended-properties", "docProps/app.xml"));
}

std::string sheetList(const std::vector<Sheet>& sheets) {
    std::string xml = start + "<workbook xmlns=\"" + space + "\" xmlns:r=\"" + office
                      + "relationships\"><bookViews><workbookView xWindow=\"0\" yWindow=\"0\" "
                        "windowWidth=\"24000\" windowHeight=\"12000\"/></bookViews><sheets>";
    std::string areas, heads;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
        const Sheet& sheet = sheets[i];
        const std::string number = std::to_string(i + 1);
        xml += "<sheet name=\"" + escaped(sheet.name) + "\" sheetId=\"" + number + "\" r:id=\"rId"
               + number + "\"/>";
        const std::string local = "\" localSheetId=\"" + std::to_string(i) + "\">";
        const std::string of = escaped(quoted(sheet.name) + '!');
        const std::string headRows = sheet.hasUnits() ? "2" : "1";
        heads += "<definedName name=\"_xlnm.Print_Titles" + local + of + "$1:$" + headRows
                 + "</definedName>";
        if (sheet.rows > printedRows && !sheet.columns.empty()) {
            areas += "<definedName name=\"_xlnm.Print_Area" + local + of + "$A$1:$"
                     + columnLetters(sheet.columns.size() - 1) + '$'
                     + std::to_string(printedRows + (sheet.hasUnits() ? 2 : 1)) + "</definedName>";
        }
    }
    return xml + "</sheets><definedNames>" + areas + heads + "</definedNames></workbook>";
}

std::string columnLetters(std::size_t column) {
    std::string name;
    for (std::size_t rest = column + 1; rest > 0; rest = (rest - 1) / 26) {
        name.insert(name.begin(), static_cast<char>('A' + (rest - 1) % 26));
    }
    return name;
}

std::string pageSetUp() {
    return "<pageMargins left=\"0.5\" right=\"0.5\" top=\"0.6\" bottom=\"0.6\" header=\"0.3\" "
           "footer=\"0.3\"/><pageSetup paperSize=\"9\" orientation=\"landscape\" fitToWidth=\"1\" "
           "fitToHeight=\"0\"/><headerFooter><oddHeader>&amp;L&amp;A</oddHeader><oddFooter>"
           "&amp;L&amp;F&amp;R&amp;P / &amp;N</oddFooter></headerFooter>";
}

int styleOf(double value) {
    constexpr int shownDigits = 6;
    char buffer[32];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value,
                                            std::chars_format::general, shownDigits);
    const std::string_view shown(buffer, static_cast<std::size_t>(end - buffer));
    if (shown.find('e') != shown.npos) {
        return std::abs(value) < 1 ? int(scientific) : int(plain);
    }
    const std::size_t point = shown.find('.');
    return point == shown.npos
               ? int(plain)
               : decimals + std::min(static_cast<int>(shown.size() - point - 1), mostDecimals);
}

std::string sheetLinks(std::size_t sheets) {
    std::string inside;
    int number = 0;
    while (static_cast<std::size_t>(number) < sheets) {
        ++number;
        inside += link(number, office + "relationships/worksheet",
                       "worksheets/sheet" + std::to_string(number) + ".xml");
    }
    return links(inside + link(number + 1, office + "relationships/styles", "styles.xml")
                 + link(number + 2, office + "relationships/sharedStrings", "sharedStrings.xml"));
}

std::string styles() {
    std::string formats, cells;
    const auto own = [&formats](int id, const std::string& code) {
        formats += "<numFmt numFmtId=\"" + std::to_string(id) + "\" formatCode=\"" + code + "\"/>";
        return id;
    };
    const std::string wrapped = " applyAlignment=\"1\"><alignment vertical=\"top\" "
                                "wrapText=\"1\"/></xf>";
    cells += cellFormat(0, 0, 0) + cellFormat(0, 1, 2, wrapped) + cellFormat(0, 2, 2, wrapped);
    cells += cellFormat(0, 0, 0, " quotePrefix=\"1\"/>");
    cells += cellFormat(own(firstOwnFormat, "0.00000E+00"), 0, 0) + cellFormat(1, 0, 0);
    for (int count = 1; count <= mostDecimals; ++count) {
        cells += cellFormat(
            own(firstOwnFormat + count, "0." + std::string(static_cast<std::size_t>(count), '0')),
            0, 0);
    }
    return start + "<styleSheet xmlns=\"" + space + "\"><numFmts count=\""
           + std::to_string(mostDecimals + 1) + "\">" + formats + "</numFmts><fonts count=\"3\">"
           + font({}, "rgb=\"FF000000\"") + font("<b/>", "rgb=\"FF000000\"")
           + font("<i/>", "rgb=\"FF505050\"")
           + "</fonts><fills count=\"3\"><fill><patternFill patternType=\"none\"/></fill><fill>"
             "<patternFill patternType=\"gray125\"/></fill><fill><patternFill "
             "patternType=\"solid\"><fgColor rgb=\"FFECEFF1\"/><bgColor indexed=\"64\"/>"
             "</patternFill></fill></fills><borders count=\"1\"><border><left/><right/><top/>"
             "<bottom/><diagonal/></border></borders><cellStyleXfs count=\"1\"><xf numFmtId=\"0\" "
             "fontId=\"0\" fillId=\"0\" borderId=\"0\"/></cellStyleXfs><cellXfs count=\""
           + std::to_string(decimals + mostDecimals + 1) + "\">" + cells
           + "</cellXfs><cellStyles count=\"1\"><cellStyle name=\"Normal\" xfId=\"0\" "
             "builtinId=\"0\"/></cellStyles></styleSheet>";
}

std::string coreProperties(const Book& book) {
    return start + "<cp:coreProperties xmlns:cp=\"" + package
           + "metadata/core-properties\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\"><dc:title>"
           + escaped(book.title) + "</dc:title><dc:creator>" + escaped(book.author)
           + "</dc:creator><dc:description>" + escaped(book.program)
           + "</dc:description></cp:coreProperties>";
}

std::string programProperties(const Book& book) {
    return start + "<Properties xmlns=\"" + office + "extended-properties\"><Application>"
           + escaped(book.program) + "</Application></Properties>";
}

} // namespace sparkout::xlsx

// NOLINTEND(modernize-raw-string-literal,performance-inefficient-string-concatenation)
