// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measured/stiffness_sheet.h"

#include "core/project/machine.h"
#include "core/project/part.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QPrintDialog>
#include <QPrinter>
#include <QTextDocument>

#include <utility>

namespace sparkout {

namespace {

constexpr int readingsEach = 2;

QString sheetMarkup(const QString& text) {
    return text.toHtmlEscaped();
}

QString lineToFill(const QString& name, const QString& value) {
    return QStringLiteral("<tr><td>%1</td><td>%2</td></tr>")
        .arg(sheetMarkup(name),
             value.isEmpty() ? QStringLiteral("________________________") : sheetMarkup(value));
}

QString sheetText(const std::string& utf8) {
    return printableText(QString::fromStdString(utf8)).simplified();
}

} // namespace

StiffnessSheet::StiffnessSheet(const Project& project, std::vector<double> places_mm, double load_n)
    : m_title(sheetText(project.title))
    , m_part(sheetText(project.part->name))
    , m_machine(sheetText(project.machine->name))
    , m_hasTailstock(project.part->shaft.mounting == Mounting::centres)
    , m_places_mm(std::move(places_mm))
    , m_load_n(load_n) {}

QStringList StiffnessSheet::steps() const {
    QStringList places;
    for (const double place : m_places_mm) {
        places << Names::fixed(place, 0);
    }
    const QString half = Names::fixed(m_load_n / 2, 0), full = Names::fixed(m_load_n, 0);
    return {m_hasTailstock
                ? tr("Clamp the part between the centres as for grinding. Wheel and drives are at "
                     "rest, the wheel does not touch the part.")
                : tr("Clamp the part in the chuck as for grinding. Wheel and drives are at rest, "
                     "the wheel does not touch the part."),
            tr("Set an indicator that reads 1 µm or finer on the bed, against the part, opposite "
               "to the wheel, at the first place: %1 mm from the headstock's end of the shaft.")
                .arg(places.value(0)),
            tr("Load the part there radially, from the side of the wheel, by a dynamometer: once "
               "to %1 N and back, to take the play out. Zero the indicator without load.")
                .arg(full),
            tr("Read the deflection at %1 N and at %2 N. Unload; the indicator must come back to "
               "zero. Read both once more.")
                .arg(half, full),
            tr("Repeat this at the other places: %1 mm.").arg(places.mid(1).join(tr(" and "))),
            tr("To include the wheel head, set the indicator on the wheel head instead of the bed, "
               "apply the load between wheel head and part, and choose this below."),
            tr("Enter the deflections. Two places determine headstock and tailstock; the third "
               "shows whether the readings agree.")};
}

QString StiffnessSheet::facts() const {
    return QStringLiteral("<table cellpadding=\"2\">") + lineToFill(tr("Project:"), m_title)
           + lineToFill(tr("Part:"), m_part) + lineToFill(tr("Machine:"), m_machine)
           + lineToFill(tr("Date, name:"), {}) + QStringLiteral("</table>");
}

QString StiffnessSheet::table() const {
    QString html = QStringLiteral("<table border=\"1\" cellspacing=\"0\" cellpadding=\"5\" "
                                  "width=\"100%\"><tr><th>%1</th><th>%2</th><th>%3</th>"
                                  "<th>%4</th></tr>")
                       .arg(sheetMarkup(tr("Place, mm")), sheetMarkup(tr("Load, N")),
                            sheetMarkup(tr("Deflection, µm")), sheetMarkup(tr("Once more, µm")));
    static_assert(readingsEach == 2, "a column for each");
    for (const double place : m_places_mm) {
        for (const double load : {m_load_n / 2, m_load_n}) {
            html += QStringLiteral("<tr><td align=\"right\">%1</td><td align=\"right\">%2</td>"
                                   "<td></td><td></td></tr>")
                        .arg(Names::fixed(place, 0), Names::fixed(load, 0));
        }
    }
    return html + QStringLiteral("</table>");
}

QString StiffnessSheet::html() const {
    QString html = QStringLiteral("<h2>%1</h2>").arg(sheetMarkup(tr("Stiffness trial"))) + facts()
                   + QStringLiteral("<ol>");
    for (const QString& step : steps()) {
        html += QStringLiteral("<li>%1</li>").arg(sheetMarkup(step));
    }
    return html + QStringLiteral("</ol>") + table();
}

void StiffnessSheet::printOn(QPrinter& printer) const {
    QTextDocument document;
    constexpr double points = 11;
    QFont font = document.defaultFont();
    font.setPointSizeF(points);
    document.setDefaultFont(font);
    document.setHtml(html());
    printer.setDocName(tr("Stiffness trial"));
    document.print(&printer);
}

void StiffnessSheet::print(QWidget* window) const {
    QPrinter printer(QPrinter::HighResolution);
    QPrintDialog dialog(&printer, window);
    dialog.setWindowTitle(tr("Print the sheet"));
    if (dialog.exec() == QDialog::Accepted) {
        printOn(printer);
    }
}

} // namespace sparkout
