// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tables/xlsx_book.h"

#include "ui/tables/xlsx_parts.h"
#include "ui/tables/zip_writer.h"

#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace sparkout {

namespace {

constexpr std::size_t sampledRows = 200; // for the widths
constexpr qsizetype chunkBytes = 64 * 1024;
constexpr int narrowest = 9, widest = 48; // characters
constexpr qsizetype headWidth = 16;       // longer names are wrapped

/// The shortest digits that read back as the same double.
QByteArray exactDigits(double value) {
    char buffer[32];
    const auto [end, error] = std::to_chars(buffer, buffer + sizeof buffer, value + 0.0);
    return {buffer, end - buffer};
}

QByteArray digitsOf(std::size_t value) {
    return QByteArray::number(static_cast<quint64>(value));
}

/// Characters of a number as it is shown; the cell of one that is not finite stays empty.
qsizetype widthOf(double value, const SheetColumn& column) {
    if (!std::isfinite(value)) {
        return 0;
    }
    const int before = 1 + static_cast<int>(std::floor(std::log10(std::max(std::abs(value), 1.0))));
    return before + 2 + (column.decimals < 0 ? 8 : column.decimals);
}

/// The sheets one after the other, as XML in the archive.
class SheetWriter {
public:
    SheetWriter(ZipWriter& zip, xlsx::SharedTexts& texts, const KeepGoing& keepGoing,
                std::size_t allRows)
        : m_zip(zip), m_texts(texts), m_keepGoing(keepGoing), m_allRows(allRows) {}

    /// False: it was given up.
    bool write(const Sheet& sheet);

private:
    void begin(const Sheet& sheet);
    [[nodiscard]] QByteArray columnsXml(const Sheet& sheet) const;
    void addText(const QString& text, int style);
    void addHead(const Sheet& sheet);
    bool addRows(const Sheet& sheet);
    void addCell(const CsvCell& cell, int style);
    void beginRow() { m_xml += "<row r=\"" + digitsOf(++m_row) + "\">"; }
    void endRow();

    ZipWriter& m_zip;
    xlsx::SharedTexts& m_texts;
    const KeepGoing& m_keepGoing;
    std::size_t m_allRows;
    std::size_t m_begun = 0; ///< sheets
    std::size_t m_doneRows = 0;
    std::size_t m_row = 0;
    std::size_t m_column = 0;
    std::vector<QByteArray> m_letters;
    QByteArray m_xml; ///< what is not yet in the archive
};

QByteArray SheetWriter::columnsXml(const Sheet& sheet) const {
    std::vector<qsizetype> widths;
    for (const SheetColumn& column : sheet.columns) {
        widths.push_back(std::max(std::min(column.name.size(), headWidth), column.unit.size()));
    }
    std::vector<CsvCell> cells(sheet.columns.size());
    for (std::size_t row = 0; row < std::min(sheet.rows, sampledRows); ++row) {
        sheet.fill(row, cells);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            const auto* text = std::get_if<QString>(&cells[i]);
            const auto* value = std::get_if<double>(&cells[i]);
            widths[i] = std::max(widths[i], text    ? text->size()
                                            : value ? widthOf(*value, sheet.columns[i])
                                                    : qsizetype(0));
        }
    }
    QByteArray xml;
    for (std::size_t i = 0; i < widths.size(); ++i) {
        const QByteArray at = digitsOf(i + 1);
        const int width = std::clamp(static_cast<int>(widths[i]) + 2, narrowest, widest);
        xml += "<col min=\"" + at + "\" max=\"" + at + "\" width=\"" + QByteArray::number(width)
               + "\" customWidth=\"1\"/>";
    }
    return xml.isEmpty() ? xml : "<cols>" + xml + "</cols>";
}

void SheetWriter::begin(const Sheet& sheet) {
    m_letters.clear();
    for (std::size_t i = 0; i < sheet.columns.size(); ++i) {
        m_letters.push_back(xlsx::columnLetters(i));
    }
    m_row = 0;
    const std::size_t headRows = sheet.hasUnits() ? 2 : 1;
    const QByteArray under = "A" + digitsOf(headRows + 1);
    m_xml = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<worksheet xmlns=\""
            "http://schemas.openxmlformats.org/spreadsheetml/2006/main\"><sheetPr><pageSetUpPr "
            "fitToPage=\"1\"/></sheetPr>"
            "<sheetViews><sheetView "
            + QByteArray(m_begun++ == 0 ? "tabSelected=\"1\" " : "")
            + "workbookViewId=\"0\"><pane ySplit=\"" + digitsOf(headRows) + "\" topLeftCell=\""
            + under
            + "\" activePane=\"bottomLeft\" state=\"frozen\"/><selection pane=\"bottomLeft\" "
              "activeCell=\""
            + under + "\" sqref=\"" + under
            + "\"/></sheetView></sheetViews><sheetFormatPr defaultRowHeight=\"15\"/>"
            + columnsXml(sheet) + "<sheetData>";
}

void SheetWriter::addText(const QString& text, int style) {
    m_xml += "<c r=\"" + m_letters[m_column] + digitsOf(m_row) + "\" s=\""
             + QByteArray::number(style) + "\" t=\"s\"><v>"
             + QByteArray::number(m_texts.numberOf(text)) + "</v></c>";
}

void SheetWriter::addCell(const CsvCell& cell, int style) {
    if (const auto* value = std::get_if<double>(&cell)) {
        if (std::isfinite(*value)) {
            const int own = style == xlsx::plain ? xlsx::styleOf(*value) : style;
            m_xml += "<c r=\"" + m_letters[m_column] + digitsOf(m_row) + "\" s=\""
                     + QByteArray::number(own) + "\"><v>" + exactDigits(*value) + "</v></c>";
        }
    } else if (const auto* text = std::get_if<QString>(&cell); text && !text->isEmpty()) {
        // The mark before a text that would become a formula when it is edited.
        const bool formula = harmlessCell(*text) != *text;
        addText(*text, formula ? xlsx::text : xlsx::plain);
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
        addText(sheet.columns[m_column].name, xlsx::head);
    }
    endRow();
    if (sheet.hasUnits()) {
        beginRow();
        for (m_column = 0; m_column < sheet.columns.size(); ++m_column) {
            addText(sheet.columns[m_column].unit, xlsx::unit);
        }
        endRow();
    }
}

bool SheetWriter::addRows(const Sheet& sheet) {
    std::vector<int> styles;
    for (const SheetColumn& column : sheet.columns) {
        styles.push_back(xlsx::styleOf(column));
    }
    std::vector<CsvCell> cells(sheet.columns.size());
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
    m_zip.add(m_xml + "</sheetData>" + xlsx::pageSetUp() + "</worksheet>");
    return whole;
}

void addFile(ZipWriter& zip, const QByteArray& name, const QByteArray& bytes) {
    zip.begin(name);
    zip.add(bytes);
    zip.end();
}

QString cutTo(const QString& text, qsizetype length) {
    return (text.size() > length && text[length - 1].isHighSurrogate()) ? text.left(length - 1)
                                                                        : text.left(length);
}

} // namespace

const Sheet* sheetTooLong(const std::vector<Sheet>& sheets) {
    const auto found = std::ranges::find_if(sheets, [](const Sheet& sheet) {
        return sheet.rows + (sheet.hasUnits() ? 2 : 1) > xlsxRows;
    });
    return found == sheets.end() ? nullptr : &*found;
}

QStringList sheetNames(const QStringList& wanted) {
    static const QRegularExpression forbidden(QStringLiteral("[\\[\\]:*?/\\\\\\x00-\\x1f]+"));
    QStringList names;
    QSet<QString> taken{QStringLiteral("history")}; // Excel's own
    for (const QString& text : wanted) {
        QString name = QString(text).replace(forbidden, QStringLiteral(" ")).simplified();
        while (name.startsWith(u'\'') || name.startsWith(u' ')) {
            name.remove(0, 1);
        }
        name = cutTo(name, xlsxNameLength);
        while (name.endsWith(u'\'') || name.endsWith(u' ')) {
            name.chop(1);
        }
        name = name.isEmpty() ? QStringLiteral("1") : name;
        const QString first = name;
        for (int again = 2; taken.contains(name.toCaseFolded()); ++again) {
            const QString tail = QStringLiteral(" (%1)").arg(again);
            name = cutTo(first, xlsxNameLength - tail.size()) + tail;
        }
        taken << name.toCaseFolded();
        names << name;
    }
    return names;
}

QByteArray xlsxBytes(const Book& book, const KeepGoing& keepGoing) {
    if (sheetTooLong(book.sheets)) {
        return {};
    }
    QStringList names;
    std::size_t rows = 0;
    for (const Sheet& sheet : book.sheets) {
        names << sheet.name;
        rows += sheet.rows;
    }
    ZipWriter zip;
    addFile(zip, "[Content_Types].xml", xlsx::contentTypes(book.sheets.size()));
    addFile(zip, "_rels/.rels", xlsx::packageLinks());
    addFile(zip, "docProps/app.xml", xlsx::programProperties(book));
    addFile(zip, "docProps/core.xml", xlsx::coreProperties(book));
    addFile(zip, "xl/workbook.xml", xlsx::workbook(sheetNames(names), book.sheets));
    addFile(zip, "xl/_rels/workbook.xml.rels", xlsx::workbookLinks(book.sheets.size()));
    addFile(zip, "xl/styles.xml", xlsx::styles());
    xlsx::SharedTexts texts;
    SheetWriter writer(zip, texts, keepGoing, rows);
    std::size_t written = 0;
    for (const Sheet& sheet : book.sheets) {
        zip.begin("xl/worksheets/sheet" + digitsOf(++written) + ".xml");
        if (!writer.write(sheet)) {
            return {};
        }
        zip.end();
    }
    addFile(zip, "xl/sharedStrings.xml", texts.xml());
    return zip.finish();
}

} // namespace sparkout
