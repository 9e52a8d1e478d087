// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workbook/workbook.h"

#include "core/file/csv_line.h"
#include "core/printable.h"
#include "core/workbook/zip_writer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

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

namespace {

constexpr std::size_t sampledRows = 200; // for the widths
constexpr std::size_t chunkBytes = std::size_t{64} * 1024;
constexpr std::size_t narrowest = 9, widest = 48; // characters
constexpr std::size_t headWidth = 16;             // longer names are wrapped

/// The shortest digits that read back as the same number.
template <typename Number>
void addDigits(std::string& to, Number value) {
    char buffer[32];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value);
    to.append(buffer, end);
}

/// The displayed length of a number; a cell that is not finite is empty.
std::size_t widthOf(double value, const Column& column) {
    if (!std::isfinite(value)) {
        return 0;
    }
    const int before = 1 + static_cast<int>(std::floor(std::log10(std::max(std::abs(value), 1.0))));
    const int after = column.decimals < 0 ? 8 : column.decimals;
    const int all = before + 2 + after;
    return static_cast<std::size_t>(all);
}

/// Writes the sheets one after the other as XML into the archive.
class SheetWriter {
public:
    SheetWriter(ZipWriter& zip, SharedTexts& texts, const KeepGoing& keepGoing, std::size_t allRows)
        : m_zip(zip), m_texts(texts), m_keepGoing(keepGoing), m_allRows(allRows) {}

    /// False after a cancellation.
    bool write(const Sheet& sheet);

private:
    void begin(const Sheet& sheet);
    [[nodiscard]] static std::string columnsXml(const Sheet& sheet);
    /// Begins <c r="B7" s="3" and appends `rest`.
    void beginCell(int style, const char* rest);
    void addText(const std::string& text, int style);
    void addHead(const Sheet& sheet);
    bool addRows(const Sheet& sheet);
    void addCell(const Cell& cell, int style);
    void beginRow();
    void endRow();

    ZipWriter& m_zip;
    SharedTexts& m_texts;
    const KeepGoing& m_keepGoing;
    std::size_t m_allRows;
    std::size_t m_begun = 0; ///< sheets
    std::size_t m_doneRows = 0;
    std::size_t m_row = 0;
    std::size_t m_column = 0;
    std::vector<std::string> m_letters;
    std::string m_xml; ///< not in the archive yet
};

std::string SheetWriter::columnsXml(const Sheet& sheet) {
    std::vector<std::size_t> widths;
    for (const Column& column : sheet.columns) {
        widths.push_back(
            std::max(std::min(lengthOf(column.name), headWidth), lengthOf(column.unit)));
    }
    std::vector<Cell> cells(sheet.columns.size());
    for (std::size_t row = 0; row < std::min(sheet.rows, sampledRows); ++row) {
        sheet.fill(row, cells);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto* text = std::get_if<std::string>(&cells[i]);
            const auto* value = std::get_if<double>(&cells[i]);
            widths[i] = std::max(widths[i], text    ? lengthOf(*text)
                                            : value ? widthOf(*value, sheet.columns[i])
                                                    : 0);
        }
    }
    std::string xml;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const std::string at = std::to_string(i + 1);
        xml += "<col min=\"" + at + "\" max=\"" + at + "\" width=\""
               + std::to_string(std::clamp(widths[i] + 2, narrowest, widest))
               + "\" customWidth=\"1\"/>";
    }
    return xml.empty() ? xml : "<cols>" + xml + "</cols>";
}

void SheetWriter::begin(const Sheet& sheet) {
    m_letters.clear();
    for (std::size_t i = 0; i < sheet.columns.size(); ++i) {
        m_letters.push_back(columnLetters(i));
    }
    m_row = 0;
    const std::size_t headRows = sheet.hasUnits() ? 2 : 1;
    const std::string under = "A" + std::to_string(headRows + 1);
    m_xml = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<worksheet xmlns=\""
            "http://schemas.openxmlformats.org/spreadsheetml/2006/main\"><sheetPr><pageSetUpPr "
            "fitToPage=\"1\"/></sheetPr>"
            "<sheetViews><sheetView "
            + std::string(m_begun++ == 0 ? "tabSelected=\"1\" " : "")
            + "workbookViewId=\"0\"><pane ySplit=\"" + std::to_string(headRows)
            + "\" topLeftCell=\"" + under
            + "\" activePane=\"bottomLeft\" state=\"frozen\"/><selection pane=\"bottomLeft\" "
              "activeCell=\""
            + under + "\" sqref=\"" + under
            + "\"/></sheetView></sheetViews><sheetFormatPr defaultRowHeight=\"15\"/>"
            + columnsXml(sheet) + "<sheetData>";
}

void SheetWriter::beginRow() {
    m_xml += "<row r=\"";
    addDigits(m_xml, ++m_row);
    m_xml += "\">";
}

void SheetWriter::beginCell(int style, const char* rest) {
    m_xml += "<c r=\"";
    m_xml += m_letters[m_column];
    addDigits(m_xml, m_row);
    m_xml += "\" s=\"";
    addDigits(m_xml, style);
    m_xml += rest;
}

void SheetWriter::addText(const std::string& text, int style) {
    beginCell(style, "\" t=\"s\"><v>");
    addDigits(m_xml, m_texts.numberOf(text));
    m_xml += "</v></c>";
}

void SheetWriter::addCell(const Cell& cell, int style) {
    if (const auto* value = std::get_if<double>(&cell)) {
        if (std::isfinite(*value)) {
            beginCell(style == plain ? styleOf(*value) : style, "\"><v>");
            addDigits(m_xml, *value + 0.0);
            m_xml += "</v></c>";
        }
    } else if (const auto* written = std::get_if<std::string>(&cell);
               written && !written->empty()) {
        // The mark of a text that would become a formula when edited.
        addText(*written, readsAsFormula(*written) ? text : plain);
    }
}

void SheetWriter::endRow() {
    m_xml += "</row>";
    if (m_xml.size() > chunkBytes) {
        m_zip.add(m_xml);
        m_xml.clear();
    }
}

void SheetWriter::addHead(const Sheet& sheet) {
    beginRow();
    for (m_column = 0; m_column < sheet.columns.size(); ++m_column) {
        addText(sheet.columns[m_column].name, head);
    }
    endRow();
    if (sheet.hasUnits()) {
        beginRow();
        for (m_column = 0; m_column < sheet.columns.size(); ++m_column) {
            addText(sheet.columns[m_column].unit, unit);
        }
        endRow();
    }
}

bool SheetWriter::addRows(const Sheet& sheet) {
    std::vector<int> styles;
    for (const Column& column : sheet.columns) {
        styles.push_back(styleOf(column));
    }
    std::vector<Cell> cells(sheet.columns.size());
    for (std::size_t row = 0; row < sheet.rows; ++row) {
        if (row % rowsBetweenLooks == 0 && m_keepGoing
            && !m_keepGoing(static_cast<double>(m_doneRows) / static_cast<double>(m_allRows))) {
            return false;
        }
        sheet.fill(row, cells);
        beginRow();
        for (m_column = 0; m_column < cells.size(); ++m_column) {
            addCell(cells[m_column], styles[m_column]);
        }
        endRow();
        ++m_doneRows;
    }
    return true;
}

bool SheetWriter::write(const Sheet& sheet) {
    begin(sheet);
    addHead(sheet);
    const bool whole = addRows(sheet);
    m_zip.add(m_xml + "</sheetData>" + pageSetUp() + "</worksheet>");
    return whole;
}

void addFile(ZipWriter& zip, std::string_view name, std::string_view bytes) {
    zip.begin(name);
    zip.add(bytes);
    zip.end();
}

} // namespace

bool Sheet::hasUnits() const {
    return std::any_of(columns.begin(), columns.end(),
                       [](const Column& column) { return !column.unit.empty(); });
}

std::string bytesOf(const Book& book, const KeepGoing& keepGoing) {
    std::size_t rows = 0;
    for (const Sheet& sheet : book.sheets) {
        if (!takesRows(sheet.rows, sheet.hasUnits())) {
            return {};
        }
        rows += sheet.rows;
    }
    ZipWriter zip;
    addFile(zip, "[Content_Types].xml", contentTypes(book.sheets.size()));
    addFile(zip, "_rels/.rels", packageLinks());
    addFile(zip, "docProps/app.xml", programProperties(book));
    addFile(zip, "docProps/core.xml", coreProperties(book));
    addFile(zip, "xl/workbook.xml", sheetList(book.sheets));
    addFile(zip, "xl/_rels/workbook.xml.rels", sheetLinks(book.sheets.size()));
    addFile(zip, "xl/styles.xml", styles());
    SharedTexts texts;
    SheetWriter writer(zip, texts, keepGoing, rows);
    std::size_t written = 0;
    for (const Sheet& sheet : book.sheets) {
        zip.begin("xl/worksheets/sheet" + std::to_string(++written) + ".xml");
        if (!writer.write(sheet)) {
            return {};
        }
        zip.end();
    }
    addFile(zip, "xl/sharedStrings.xml", texts.xml());
    return zip.finish();
}

} // namespace sparkout::xlsx

// NOLINTEND(modernize-raw-string-literal,performance-inefficient-string-concatenation)
