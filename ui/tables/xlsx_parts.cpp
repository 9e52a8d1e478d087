// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tables/xlsx_parts.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace sparkout::xlsx {

namespace {

const QByteArray start = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";
const QByteArray space = "http://schemas.openxmlformats.org/spreadsheetml/2006/main";
const QByteArray office = "http://schemas.openxmlformats.org/officeDocument/2006/";
const QByteArray package = "http://schemas.openxmlformats.org/package/2006/";
const QByteArray sheetKind = "application/vnd.openxmlformats-officedocument.spreadsheetml.";
constexpr int firstOwnFormat = 164; // below it are the program's own

QByteArray link(int number, const QByteArray& kind, const QByteArray& target) {
    return "<Relationship Id=\"rId" + QByteArray::number(number) + "\" Type=\"" + kind
           + "\" Target=\"" + target + "\"/>";
}

QByteArray links(const QByteArray& inside) {
    return start + "<Relationships xmlns=\"" + package + "relationships\">" + inside
           + "</Relationships>";
}

QByteArray part(const QByteArray& name, const QByteArray& kind) {
    return "<Override PartName=\"/" + name + "\" ContentType=\"" + kind + "\"/>";
}

QByteArray cellFormat(int numberFormat, int font, int fill, const QByteArray& more = "/>") {
    return "<xf numFmtId=\"" + QByteArray::number(numberFormat) + "\" fontId=\""
           + QByteArray::number(font) + "\" fillId=\"" + QByteArray::number(fill)
           + "\" borderId=\"0\" xfId=\"0\" applyNumberFormat=\"1\" applyFont=\"1\" applyFill=\"1\""
           + more;
}

/// A font of the default size, in black or grey.
QByteArray font(const QByteArray& look, const QByteArray& colour) {
    return "<font>" + look + "<sz val=\"11\"/><color " + colour
           + "/><name val=\"Calibri\"/><family val=\"2\"/></font>";
}

bool allowed(QChar c) {
    return c == u'\t' || c == u'\n' || (c >= u' ' && c != QChar(0xfffe) && c != QChar(0xffff));
}

} // namespace

int styleOf(const SheetColumn& column) {
    return column.decimals == SheetColumn::general ? int(plain)
           : column.decimals == SheetColumn::scientific
               ? int(scientific)
               : decimals + std::min(column.decimals, mostDecimals);
}

QByteArray escaped(const QString& text) {
    // What looks like the escape of a character would be read as that character.
    static const QRegularExpression escape(QStringLiteral("_(x[0-9A-Fa-f]{4}_)"));
    QString clean;
    for (const QChar c : text.left(xlsxTextLength)) {
        clean += allowed(c) ? c : QChar(u' ');
    }
    clean.replace(escape, QStringLiteral("_x005F_\\1"));
    return clean.toHtmlEscaped().toUtf8();
}

int SharedTexts::numberOf(const QString& text) {
    ++m_uses;
    const auto found = m_numbers.constFind(text);
    if (found != m_numbers.constEnd()) {
        return *found;
    }
    const int number = static_cast<int>(m_texts.size());
    m_numbers.insert(text, number);
    m_texts << text;
    return number;
}

QByteArray SharedTexts::xml() const {
    QByteArray xml = start + "<sst xmlns=\"" + space + "\" count=\"" + QByteArray::number(m_uses)
                     + "\" uniqueCount=\"" + QByteArray::number(m_texts.size()) + "\">";
    for (const QString& text : m_texts) {
        xml += "<si><t xml:space=\"preserve\">" + escaped(text) + "</t></si>";
    }
    return xml + "</sst>";
}

QByteArray contentTypes(std::size_t sheets) {
    QByteArray xml = start + "<Types xmlns=\"" + package
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
        xml += part("xl/worksheets/sheet" + QByteArray::number(quint64(i)) + ".xml",
                    sheetKind + "worksheet+xml");
    }
    return xml + "</Types>";
}

QByteArray packageLinks() {
    return links(link(1, office + "relationships/officeDocument", "xl/workbook.xml")
                 + link(2, package + "relationships/metadata/core-properties", "docProps/core.xml")
                 + link(3, office + "relationships/extended-properties", "docProps/app.xml"));
}

QByteArray workbook(const QStringList& names, const std::vector<Sheet>& sheets) {
    QByteArray xml = start + "<workbook xmlns=\"" + space + "\" xmlns:r=\"" + office
                     + "relationships\"><bookViews><workbookView xWindow=\"0\" yWindow=\"0\" "
                       "windowWidth=\"24000\" windowHeight=\"12000\"/></bookViews><sheets>";
    QByteArray areas, heads;
    for (qsizetype i = 0; i < names.size(); ++i) {
        const QByteArray number = QByteArray::number(i + 1);
        xml += "<sheet name=\"" + escaped(names[i]) + "\" sheetId=\"" + number + "\" r:id=\"rId"
               + number + "\"/>";
        const Sheet& sheet = sheets[static_cast<std::size_t>(i)];
        const QByteArray local = "\" localSheetId=\"" + QByteArray::number(i) + "\">";
        const QByteArray of = escaped(u'\'' + QString(names[i]).replace(u'\'', QStringLiteral("''"))
                                      + QStringLiteral("'!"));
        const QByteArray headRows = sheet.hasUnits() ? "2" : "1";
        heads += "<definedName name=\"_xlnm.Print_Titles" + local + of + "$1:$" + headRows
                 + "</definedName>";
        if (sheet.rows > printedRows && !sheet.columns.empty()) {
            areas += "<definedName name=\"_xlnm.Print_Area" + local + of + "$A$1:$"
                     + columnLetters(sheet.columns.size() - 1) + '$'
                     + QByteArray::number(quint64(printedRows + (sheet.hasUnits() ? 2 : 1)))
                     + "</definedName>";
        }
    }
    return xml + "</sheets><definedNames>" + areas + heads + "</definedNames></workbook>";
}

QByteArray columnLetters(std::size_t column) {
    QByteArray name;
    for (std::size_t rest = column + 1; rest > 0; rest = (rest - 1) / 26) {
        name.prepend(static_cast<char>('A' + (rest - 1) % 26));
    }
    return name;
}

QByteArray pageSetUp() {
    return "<pageMargins left=\"0.5\" right=\"0.5\" top=\"0.6\" bottom=\"0.6\" header=\"0.3\" "
           "footer=\"0.3\"/><pageSetup paperSize=\"9\" orientation=\"landscape\" fitToWidth=\"1\" "
           "fitToHeight=\"0\"/><headerFooter><oddHeader>&amp;L&amp;A</oddHeader><oddFooter>"
           "&amp;L&amp;F&amp;R&amp;P / &amp;N</oddFooter></headerFooter>";
}

int styleOf(double value) {
    constexpr int shownDigits = 6;
    const QByteArray shown = QByteArray::number(value, 'g', shownDigits);
    if (shown.contains('e')) {
        return std::abs(value) < 1 ? int(scientific) : int(plain);
    }
    const qsizetype point = shown.indexOf('.');
    return point < 0
               ? int(plain)
               : decimals + std::min(static_cast<int>(shown.size() - point - 1), mostDecimals);
}

QByteArray workbookLinks(std::size_t sheets) {
    QByteArray inside;
    int number = 0;
    while (static_cast<std::size_t>(number) < sheets) {
        ++number;
        inside += link(number, office + "relationships/worksheet",
                       "worksheets/sheet" + QByteArray::number(number) + ".xml");
    }
    return links(inside + link(number + 1, office + "relationships/styles", "styles.xml")
                 + link(number + 2, office + "relationships/sharedStrings", "sharedStrings.xml"));
}

QByteArray styles() {
    QByteArray formats, cells;
    const auto own = [&formats](int id, const QByteArray& code) {
        formats +=
            "<numFmt numFmtId=\"" + QByteArray::number(id) + "\" formatCode=\"" + code + "\"/>";
        return id;
    };
    const QByteArray wrapped = " applyAlignment=\"1\"><alignment vertical=\"top\" "
                               "wrapText=\"1\"/></xf>";
    cells += cellFormat(0, 0, 0) + cellFormat(0, 1, 2, wrapped) + cellFormat(0, 2, 2, wrapped);
    cells += cellFormat(0, 0, 0, " quotePrefix=\"1\"/>");
    cells += cellFormat(own(firstOwnFormat, "0.00000E+00"), 0, 0) + cellFormat(1, 0, 0);
    for (int count = 1; count <= mostDecimals; ++count) {
        cells += cellFormat(own(firstOwnFormat + count, "0." + QByteArray(count, '0')), 0, 0);
    }
    return start + "<styleSheet xmlns=\"" + space + "\"><numFmts count=\""
           + QByteArray::number(mostDecimals + 1) + "\">" + formats
           + "</numFmts><fonts count=\"3\">" + font({}, "rgb=\"FF000000\"")
           + font("<b/>", "rgb=\"FF000000\"") + font("<i/>", "rgb=\"FF505050\"")
           + "</fonts><fills count=\"3\"><fill><patternFill patternType=\"none\"/></fill><fill>"
             "<patternFill patternType=\"gray125\"/></fill><fill><patternFill "
             "patternType=\"solid\"><fgColor rgb=\"FFECEFF1\"/><bgColor indexed=\"64\"/>"
             "</patternFill></fill></fills><borders count=\"1\"><border><left/><right/><top/>"
             "<bottom/><diagonal/></border></borders><cellStyleXfs count=\"1\"><xf numFmtId=\"0\" "
             "fontId=\"0\" fillId=\"0\" borderId=\"0\"/></cellStyleXfs><cellXfs count=\""
           + QByteArray::number(decimals + mostDecimals + 1) + "\">" + cells
           + "</cellXfs><cellStyles count=\"1\"><cellStyle name=\"Normal\" xfId=\"0\" "
             "builtinId=\"0\"/></cellStyles></styleSheet>";
}

QByteArray coreProperties(const Book& book) {
    const QByteArray made = book.made.toUTC().toString(Qt::ISODate).toUtf8();
    return start + "<cp:coreProperties xmlns:cp=\"" + package
           + "metadata/core-properties\" xmlns:dc=\"http://purl.org/dc/elements/1.1/\" "
             "xmlns:dcterms=\"http://purl.org/dc/terms/\" "
             "xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\"><dc:title>"
           + escaped(book.title) + "</dc:title><dc:creator>" + escaped(book.author)
           + "</dc:creator><dc:description>" + escaped(book.program)
           + "</dc:description><dcterms:created xsi:type=\"dcterms:W3CDTF\">" + made
           + "</dcterms:created></cp:coreProperties>";
}

QByteArray programProperties(const Book& book) {
    return start + "<Properties xmlns=\"" + office + "extended-properties\"><Application>"
           + escaped(book.program) + "</Application></Properties>";
}

} // namespace sparkout::xlsx
