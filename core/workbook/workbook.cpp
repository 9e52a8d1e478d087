// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/workbook/workbook.h"

#include "core/tables/csv_line.h"
#include "core/workbook/xlsx_parts.h"
#include "core/workbook/zip_writer.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

// Pieces of XML: short strings put together, with quotes in them.
// NOLINTBEGIN(modernize-raw-string-literal,performance-inefficient-string-concatenation)

namespace sparkout::xlsx {

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
