// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/table/pasted_cells.h"

#include "ui/text/number_text.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextDocumentFragment>
#include <QTextFrame>
#include <QTextTable>
#include <QUrl>
#include <QVariant>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

/// The end of the quotes with which a cell begins; −1 if it is plain text.
qsizetype closingQuote(const QString& text, qsizetype from) {
    for (qsizetype i = from + 1; i < text.size(); ++i) {
        if (text[i] == u'"') {
            if (i + 1 < text.size() && text[i + 1] == u'"') {
                ++i; // an escaped quote of the cell
            } else {
                return i;
            }
        }
    }
    return -1;
}

/// The rows of a text; a null separator separates nothing.
std::vector<QStringList> rowsOf(const QString& text, QChar separator) {
    std::vector<QStringList> rows(1);
    QString cell;
    const auto endCell = [&] { rows.back() << std::exchange(cell, QString()); };
    bool begins = true; // a cell
    for (qsizetype i = 0; i < text.size(); ++i) {
        const QChar c = text[i];
        const qsizetype close = begins && c == u'"' ? closingQuote(text, i) : -1;
        begins = false;
        if (close >= 0) {
            cell += text.mid(i + 1, close - i - 1)
                        .replace(QStringLiteral("\"\""), QStringLiteral("\""));
            i = close;
        } else if (c == u'\n') {
            endCell();
            rows.emplace_back();
            begins = true;
        } else if (!separator.isNull() && c == separator) {
            endCell();
            begins = true;
        } else {
            cell += c;
        }
    }
    endCell();
    return rows;
}

bool isNumberOrEmpty(const QString& cell) {
    return cell.trimmed().isEmpty() || pastedNumber(cell);
}

/// Whether a comma separates cells: all rows have the same number of commas, only numbers between
/// them, and some row is not a decimal number.
bool commaPartsCells(const QString& text) {
    const std::vector<QStringList> rows = rowsOf(text, u',');
    bool sure = false;
    for (const QStringList& row : rows) {
        const bool blank = row.size() == 1 && row.front().trimmed().isEmpty();
        if (blank) {
            continue;
        }
        if (row.size() != rows.front().size() || row.size() < 2
            || !std::all_of(row.begin(), row.end(), isNumberOrEmpty)) {
            return false;
        }
        sure = sure || !pastedNumber(row.join(u','));
    }
    return sure;
}

/// Whether a character occurs outside quotes.
bool partsCells(const QString& text, QChar separator) {
    const std::vector<QStringList> rows = rowsOf(text, separator);
    return std::any_of(rows.begin(), rows.end(),
                       [](const QStringList& row) { return row.size() > 1; });
}

QChar cellSeparator(const QString& text) {
    for (const QChar separator : {u'\t', u';'}) {
        if (text.contains(separator) && partsCells(text, separator)) {
            return separator;
        }
    }
    return commaPartsCells(text) ? QChar(u',') : QChar();
}

/// A document that opens no file, whatever style or picture a text refers to.
class PastedDocument : public QTextDocument {
protected:
    QVariant loadResource(int /*type*/, const QUrl& /*name*/) override { return QString(); }
};

/// The cells of the first table; without a table each paragraph is a row of one cell.
std::vector<QStringList> rowsOfHtml(const QString& html) {
    PastedDocument document;
    document.setHtml(html);
    const QTextTable* table = nullptr;
    for (QTextFrame* const frame : document.rootFrame()->childFrames()) {
        table = table ? table : qobject_cast<QTextTable*>(frame);
    }
    if (!table) {
        return rowsOf(document.toPlainText(), {});
    }
    std::vector<QStringList> rows;
    for (int row = 0; row < table->rows(); ++row) {
        QStringList& cells = rows.emplace_back();
        for (int column = 0; column < table->columns(); ++column) {
            const QTextTableCell cell = table->cellAt(row, column);
            const bool own = cell.row() == row && cell.column() == column; // or a span
            QTextCursor content = cell.firstCursorPosition();
            content.setPosition(cell.lastPosition(), QTextCursor::KeepAnchor);
            cells << (own ? content.selection().toPlainText().trimmed() : QString());
        }
    }
    return rows;
}

void dropEmptyEnd(std::vector<QStringList>& rows) {
    const auto empty = [](const QStringList& row) {
        return std::all_of(row.begin(), row.end(),
                           [](const QString& cell) { return cell.trimmed().isEmpty(); });
    };
    while (!rows.empty() && empty(rows.back())) {
        rows.pop_back();
    }
}

} // namespace

PastedCells PastedCells::of(const QString& text) {
    QString lines = text;
    lines.replace(QStringLiteral("\r\n"), QStringLiteral("\n"))
        .replace(u'\r', u'\n')
        .remove(QChar());
    PastedCells cells{rowsOf(lines, cellSeparator(lines))};
    dropEmptyEnd(cells.rows);
    return cells;
}

PastedCells PastedCells::of(const QMimeData* data) {
    if (!data) {
        return {};
    }
    if (data->hasText() || !data->hasHtml()) {
        return of(data->text());
    }
    PastedCells cells{rowsOfHtml(data->html())};
    dropEmptyEnd(cells.rows);
    return cells;
}

QString PastedCells::text() const {
    static const QRegularExpression special(QStringLiteral("[\t\n\r\";]"));
    QString text;
    for (const QStringList& row : rows) {
        for (qsizetype i = 0; i < row.size(); ++i) {
            QString cell = row[i];
            if (cell.contains(special) || (cell.contains(u',') && !pastedNumber(cell))) {
                cell = u'"' + cell.replace(QStringLiteral("\""), QStringLiteral("\"\"")) + u'"';
            }
            text += (i > 0 ? QStringLiteral("\t") : QString()) + cell;
        }
        text += u'\n';
    }
    return text;
}

std::vector<QString> PastedCells::inOrder() const {
    std::vector<QString> cells;
    for (const QStringList& row : rows) {
        cells.insert(cells.end(), row.begin(), row.end());
    }
    return cells;
}

std::optional<double> pastedNumber(const QString& cell) {
    static const QRegularExpression grouped(QStringLiteral(
        "^[+\\-\u2212\u2013]?\\d{1,3}(?:[\u00a0\u202f\u2009\u2007]\\d{3})+(?:[.,]\\d*)?$"));
    static const QRegularExpression gaps(QStringLiteral("[\u00a0\u202f\u2009\u2007]"));
    QString text = cell.trimmed();
    if (grouped.match(text).hasMatch()) {
        text.remove(gaps);
    }
    return parseNumber(text);
}

namespace {

const QString& plainType() {
    static const QString type = QStringLiteral("text/plain");
    return type;
}

const QString& htmlType() {
    static const QString type = QStringLiteral("text/html");
    return type;
}

/// LibreOffice reads sdval and sdnum, Excel x:num and mso-number-format; 1033 is the language of a
/// decimal point, @ the format of a text, so that "1/2" does not become a date.
QString htmlCell(const QString& cell) {
    const QString shown = cell.toHtmlEscaped().replace(u'\n', QStringLiteral("<br>"));
    if (const std::optional<double> number = pastedNumber(cell)) {
        const QString value = showNumber(*number, QLocale::c());
        return QStringLiteral("<td align=\"right\" sdval=\"%1\" sdnum=\"1033;\" x:num=\"%1\">%2"
                              "</td>")
            .arg(value, shown);
    }
    if (shown.isEmpty()) {
        return QStringLiteral("<td></td>");
    }
    return QStringLiteral("<td sdnum=\"1033;0;@\" style=\"mso-number-format:'\\@'\">") + shown
           + QStringLiteral("</td>");
}

} // namespace

CopiedCells::CopiedCells(QString text) : m_text(std::move(text)) {
    static const QRegularExpression minus(QStringLiteral("−(?=\\d)"));
    m_text.replace(minus, QStringLiteral("-"));
}

void CopiedCells::toClipboard(const QString& text) {
    QGuiApplication::clipboard()->setMimeData(new CopiedCells(text)); // takes ownership
}

QStringList CopiedCells::formats() const {
    return {plainType(), htmlType()};
}

bool CopiedCells::hasFormat(const QString& type) const {
    return formats().contains(type);
}

QVariant CopiedCells::retrieveData(const QString& type, QMetaType as) const {
    if (type == plainType()) {
        return m_text;
    }
    return type == htmlType() ? htmlTable(PastedCells::of(m_text))
                              : QMimeData::retrieveData(type, as);
}

QString htmlTable(const PastedCells& cells) {
    QString html = QStringLiteral(
        "<html xmlns:x=\"urn:schemas-microsoft-com:office:excel\"><head><meta "
        "http-equiv=\"content-type\" content=\"text/html; charset=utf-8\"></head><body><table>\n");
    for (const QStringList& row : cells.rows) {
        html += QStringLiteral("<tr>");
        for (const QString& cell : row) {
            html += htmlCell(cell);
        }
        html += QStringLiteral("</tr>\n");
    }
    return html + QStringLiteral("</table></body></html>\n");
}

} // namespace sparkout
