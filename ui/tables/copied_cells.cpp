// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tables/copied_cells.h"

#include "ui/text/number_text.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QLocale>
#include <QRegularExpression>

#include <utility>

namespace sparkout {

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
