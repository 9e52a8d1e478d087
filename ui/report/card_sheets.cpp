// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/card_sheets.h"

#include "ui/report/logo.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <optional>
#include <span>

namespace sparkout::report::form {

const std::array<const char*, 3> inventory{QT_TRANSLATE_NOOP("CardForm", "Copy"),
                                           QT_TRANSLATE_NOOP("CardForm", "Repl."),
                                           QT_TRANSLATE_NOOP("CardForm", "Orig.")};
const std::array<Cell, 5> changes{{{QT_TRANSLATE_NOOP("CardForm", "Rev."), 10},
                                   {QT_TRANSLATE_NOOP("CardForm", "Sheet"), 10},
                                   {QT_TRANSLATE_NOOP("CardForm", "Doc. no."), 22},
                                   {QT_TRANSLATE_NOOP("CardForm", "Sign."), 14},
                                   {QT_TRANSLATE_NOOP("CardForm", "Date"), 12}}};
const std::array<const char*, 5> signers{
    QT_TRANSLATE_NOOP("CardForm", "Prepared"), QT_TRANSLATE_NOOP("CardForm", "Checked"),
    QT_TRANSLATE_NOOP("CardForm", "Agreed"), QT_TRANSLATE_NOOP("CardForm", "Standards"),
    QT_TRANSLATE_NOOP("CardForm", "Approved")};
const std::array<Cell, 3> designations{{{QT_TRANSLATE_NOOP("CardForm", "Company, department"), 72},
                                        {QT_TRANSLATE_NOOP("CardForm", "Part designation"), 60},
                                        {QT_TRANSLATE_NOOP("CardForm", "Document number"), 60}}};
const std::array<Cell, 6> names{{{QT_TRANSLATE_NOOP("CardForm", "Name of the part"), 120},
                                 {QT_TRANSLATE_NOOP("CardForm", "Letter"), 12},
                                 {QT_TRANSLATE_NOOP("CardForm", "Shop"), 15},
                                 {QT_TRANSLATE_NOOP("CardForm", "Area"), 15},
                                 {QT_TRANSLATE_NOOP("CardForm", "Workpl."), 15},
                                 {QT_TRANSLATE_NOOP("CardForm", "Oper."), 15}}};
const std::array<Cell, 4> continued{{{QT_TRANSLATE_NOOP("CardForm", "Name of the part"), 120},
                                     {QT_TRANSLATE_NOOP("CardForm", "Part designation"), 68},
                                     {QT_TRANSLATE_NOOP("CardForm", "Document number"), 69},
                                     {QT_TRANSLATE_NOOP("CardForm", "Oper."), 15}}};
const std::array<Cell, 8> operationRow{
    {{QT_TRANSLATE_NOOP("CardForm", "Name of the operation"), 72},
     {QT_TRANSLATE_NOOP("CardForm", "Material"), 46},
     {QT_TRANSLATE_NOOP("CardForm", "Hardness"), 24},
     {QT_TRANSLATE_NOOP("CardForm", "Unit"), 13},
     {QT_TRANSLATE_NOOP("CardForm", "Part mass"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "Profile and sizes"), 60},
     {QT_TRANSLATE_NOOP("CardForm", "Raw mass"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "At once"), 17}}};
const std::array<Cell, 7> equipmentRow{
    {{QT_TRANSLATE_NOOP("CardForm", "Equipment, NC control"), 82},
     {QT_TRANSLATE_NOOP("CardForm", "NC program number"), 50},
     {QT_TRANSLATE_NOOP("CardForm", "Main, min"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "Auxil., min"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "Setting, min"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "Piece, min"), 20},
     {QT_TRANSLATE_NOOP("CardForm", "Coolant"), 60}}};
const std::array<Cell, 12> columns{{{QT_TRANSLATE_NOOP("CardForm", "R"), 12},
                                    {QT_TRANSLATE_NOOP("CardForm", "Step, settings"), 88},
                                    {QT_TRANSLATE_NOOP("CardForm", "Pos."), 10},
                                    {QT_TRANSLATE_NOOP("CardForm", "D or B, mm"), 20},
                                    {QT_TRANSLATE_NOOP("CardForm", "L, mm"), 18},
                                    {QT_TRANSLATE_NOOP("CardForm", "t, mm"), 18},
                                    {QT_TRANSLATE_NOOP("CardForm", "i"), 14},
                                    {QT_TRANSLATE_NOOP("CardForm", "S"), 28},
                                    {QT_TRANSLATE_NOOP("CardForm", "n, rev/min"), 18},
                                    {QT_TRANSLATE_NOOP("CardForm", "V, m/min"), 16},
                                    {QT_TRANSLATE_NOOP("CardForm", "Main, min"), 15},
                                    {QT_TRANSLATE_NOOP("CardForm", "Auxil., min"), 15}}};

const char* const dateFormat = QT_TRANSLATE_NOOP("CardForm", "d MMM yy");

const Kind card{
    QT_TRANSLATE_NOOP("CardForm", "OC"), QT_TRANSLATE_NOOP("CardForm", "Operation card, machining"),
    QT_TRANSLATE_NOOP("CardForm", "after GOST 3.1404-86, form 2"),
    QT_TRANSLATE_NOOP("CardForm", "after GOST 3.1404-86, form 2a"),
    QT_TRANSLATE_NOOP(
        "CardForm",
        "The form is modelled on GOST 3.1404-86 and 3.1103: check it against the current edition. "
        "The numbers are predictions of a model, to be confirmed at the machine.")};
const Kind sketch{
    QT_TRANSLATE_NOOP("CardForm", "SK"), QT_TRANSLATE_NOOP("CardForm", "Sketch sheet"),
    QT_TRANSLATE_NOOP("CardForm", "after GOST 3.1105-84, form 7"),
    QT_TRANSLATE_NOOP("CardForm", "after GOST 3.1105-84, form 7a"),
    QT_TRANSLATE_NOOP("CardForm", "The form is modelled on GOST 3.1105-84 and 3.1103: check it "
                                  "against the current edition. Not to scale.")};

QString text(const char* caption) {
    return QCoreApplication::translate("CardForm", caption);
}

} // namespace sparkout::report::form

namespace sparkout::report {

namespace {

constexpr double signersTop = form::top + 3 * form::halfPitch;
constexpr double operationTop = signersTop + 5 * form::halfPitch;
constexpr double captioned =
    form::halfPitch + form::pitch; ///< height of a cell with its caption above
constexpr double columnsFirst = operationTop + 2 * captioned;
constexpr double columnsFollowing = signersTop + captioned;
constexpr double widestNumber = 35; ///< width of a cell whose value is centred
constexpr double signersWidth = 80, changesFrom = form::left + 67, sheetsFrom = changesFrom + 136;

void caption(FormSheet& sheet, const QRectF& cell, const char* text,
             const std::optional<TablePlace>& place = {}) {
    sheet.texts.push_back(fitted(cell.adjusted(form::pad / 2, 0, -form::pad / 2, 0),
                                 form::text(text), form::captionPoints, Qt::AlignHCenter));
    sheet.texts.back().place = place;
}

void value(FormSheet& sheet, const QRectF& cell, const QString& text,
           Qt::Alignment align = Qt::AlignLeft, double points = form::valuePoints,
           const std::optional<TablePlace>& place = {}) {
    if (!text.isEmpty()) {
        sheet.texts.push_back(
            fitted(cell.adjusted(form::pad, 0, -form::pad, 0), text, points, align));
        sheet.texts.back().place = place;
    }
}

/// Cells side by side, with captions above and values below.
void captionedRow(FormSheet& sheet, std::span<const form::Cell> cells, const QStringList& values,
                  double x, double y, double height = captioned) {
    const double captionHeight = height == captioned ? form::halfPitch : height - 5.2;
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const QRectF cell(x, y, cells[i].width_mm, height);
        sheet.frame(cell, form::thin);
        caption(sheet, {cell.topLeft(), QSizeF(cell.width(), captionHeight)}, cells[i].caption);
        value(sheet, cell.adjusted(0, captionHeight, 0, 0), values.value(static_cast<qsizetype>(i)),
              cell.width() > widestNumber ? Qt::AlignLeft : Qt::AlignHCenter);
        x += cells[i].width_mm;
    }
}

void columnHead(FormSheet& sheet, double y) {
    double x = form::left;
    for (const form::Cell& column : form::columns) {
        const QRectF cell(x, y, column.width_mm, form::pitch);
        sheet.frame(cell, form::thin);
        caption(sheet, cell, column.caption, TablePlace{0, sheet.columns});
        x += column.width_mm;
        ++sheet.columns;
    }
    sheet.lines.push_back(
        {QLineF(form::left, y + form::pitch, form::right, y + form::pitch), form::thick});
}

double columnsTop(bool first) {
    return first ? columnsFirst : columnsFollowing;
}

std::size_t roomOf(bool first) {
    return static_cast<std::size_t>((form::footTop - columnsTop(first) - form::pitch) / form::pitch
                                    + 1e-9);
}

double contentWidth(bool hasCells) {
    double wide = 0;
    for (std::size_t i = form::contentColumn; i < (hasCells ? form::firstValue : form::mainColumn);
         ++i) {
        wide += form::columns.at(i).width_mm;
    }
    return wide;
}

QString shown(const std::string& text) {
    return QString::fromStdString(text);
}

} // namespace

QString CardHead::maker() const {
    QStringList all{shown(company.name), shown(company.department)};
    all.removeAll(QString());
    return all.join(QStringLiteral(", "));
}

QStringList CardHead::people() const {
    return {company.developed.empty() ? author : shown(company.developed), shown(company.checked),
            shown(company.agreed), shown(company.standards), shown(company.approved)};
}

QStringList CardHead::designations() const {
    return {maker(), shown(company.part), shown(company.designation)};
}

QStringList CardHead::names() const {
    return {part,
            letter,
            shown(company.shop),
            shown(company.area),
            shown(company.place),
            shown(company.operation)};
}

QStringList CardHead::following() const {
    return {part, shown(company.part), shown(company.designation), shown(company.operation)};
}

std::vector<CardSheets::Line> CardSheets::wrapped(const std::vector<CardRow>& rows) {
    std::vector<Line> lines;
    for (const CardRow& row : rows) {
        const QRectF cell(0, 0, contentWidth(!row.cells.isEmpty()) - 2 * form::pad, form::pitch);
        const QStringList texts = SheetText{cell, row.text, form::valuePoints}.box().texts();
        for (qsizetype i = 0; i < texts.size(); ++i) {
            const bool last = i + 1 == texts.size();
            CardRow part = i == 0 ? row : CardRow{{}, {}, {}, {}, {}, row.keeps};
            part.text = texts[i];
            lines.push_back({part, last ? row.keeps : true});
        }
    }
    return lines;
}

std::size_t CardSheets::taken(const std::vector<Line>& lines, std::size_t from, std::size_t room) {
    const std::size_t most = std::min(room, lines.size() - from);
    if (from + most == lines.size()) {
        return most;
    }
    std::size_t count = most;
    while (count > 0 && lines[from + count - 1].keeps) {
        --count;
    }
    return count > 0 ? count : most; // it is longer than a sheet
}

std::vector<FormSheet> CardSheets::card(const std::vector<CardRow>& rows,
                                        std::size_t following) const {
    const std::vector<Line> lines = wrapped(rows);
    std::vector<std::size_t> counts;
    for (std::size_t from = 0; from < lines.size() || counts.empty();) {
        counts.push_back(taken(lines, from, roomOf(counts.empty())));
        from += counts.back();
    }
    std::vector<FormSheet> sheets;
    std::size_t next = 0;
    for (std::size_t s = 0; s < counts.size(); ++s) {
        const bool first = s == 0;
        FormSheet sheet = begun(form::card, first, static_cast<int>(s) + 1,
                                static_cast<int>(counts.size() + following));
        if (first) {
            captionedRow(sheet, form::operationRow, m_head.operation, form::left, operationTop);
            captionedRow(sheet, form::equipmentRow, m_head.equipment, form::left,
                         operationTop + captioned);
            sheet.lines.push_back(
                {QLineF(form::left, operationTop, form::right, operationTop), form::thick});
        }
        columnHead(sheet, columnsTop(first));
        double y = columnsTop(first) + form::pitch;
        for (std::size_t i = 0; i < roomOf(first); ++i, y += form::pitch) {
            const bool filled = i < counts[s];
            addLine(sheet, filled ? lines[next + i] : Line{{}, false}, y, filled ? next + i + 1 : 0,
                    static_cast<int>(i) + 1);
        }
        next += counts[s];
        sheets.push_back(std::move(sheet));
    }
    return sheets;
}

QRectF CardSheets::sketchRoom(bool first) {
    const double from = first ? operationTop : columnsFollowing;
    return {form::left, from, form::width, form::footTop - from};
}

FormSheet CardSheets::sketch(int number, int count) const {
    return begun(form::sketch, true, number, count);
}

FormSheet CardSheets::begun(const form::Kind& kind, bool isFirst, int number, int count) const {
    FormSheet sheet;
    sheet.title = form::text(kind.name) + QStringLiteral(", ") + QString::number(number);
    addInventory(sheet, number, count);
    if (isFirst) {
        addSigners(sheet);
        addDesignations(sheet);
    } else {
        captionedRow(sheet, form::continued, m_head.following(), form::left, signersTop);
    }
    addFoot(sheet, kind);
    sheet.texts.push_back(fitted({form::right - 120, form::top - 3.6, 120, 3.4},
                                 form::text(isFirst ? kind.first : kind.following),
                                 form::captionPoints, Qt::AlignRight));
    sheet.frame({form::left, form::top, form::width, form::bottom - form::top}, form::thick);
    const double from = isFirst ? operationTop : columnsFollowing;
    sheet.lines.push_back({QLineF(form::left, from, form::right, from), form::thick});
    return sheet;
}

void CardSheets::addInventory(FormSheet& sheet, int number, int count) const {
    for (std::size_t row = 0; row < form::inventory.size(); ++row) {
        double x = form::left;
        const double y = form::top + static_cast<double>(row) * form::halfPitch;
        for (std::size_t i = 0; i < form::inventoryWidths.size(); ++i) {
            const QRectF cell(x, y, form::inventoryWidths.at(i), form::halfPitch);
            sheet.frame(cell, form::thin);
            if (i == 0) {
                caption(sheet, cell, form::inventory.at(row));
            }
            x += form::inventoryWidths.at(i);
        }
        x = changesFrom;
        for (std::size_t i = 0; i < 2 * form::changes.size(); ++i) {
            const form::Cell& column = form::changes.at(i % form::changes.size());
            const QRectF cell(x, y, column.width_mm, form::halfPitch);
            sheet.frame(cell, form::thin);
            if (row + 1 == form::inventory.size()) { // below cells to be filled in by hand
                caption(sheet, cell, column.caption);
            }
            x += column.width_mm;
        }
    }
    const double half = (form::right - sheetsFrom) / 2;
    const std::array<form::Cell, 2> cells{{{QT_TRANSLATE_NOOP("CardForm", "Sheets"), half},
                                           {QT_TRANSLATE_NOOP("CardForm", "Sheet"), half}}};
    captionedRow(sheet, cells, {QString::number(count), QString::number(number)}, sheetsFrom,
                 form::top);
}

void CardSheets::addSigners(FormSheet& sheet) const {
    const QStringList all = m_head.people();
    for (std::size_t row = 0; row < form::signers.size(); ++row) {
        double x = form::left;
        const double y = signersTop + static_cast<double>(row) * form::halfPitch;
        for (std::size_t i = 0; i < form::signerWidths.size(); ++i) {
            const QRectF cell(x, y, form::signerWidths.at(i), form::halfPitch);
            sheet.frame(cell, form::thin);
            if (i == 0) {
                sheet.texts.push_back(fitted(cell.adjusted(form::pad, 0, 0, 0),
                                             form::text(form::signers.at(row)), form::smallPoints));
            } else if (i == 1) {
                value(sheet, cell, all.value(static_cast<qsizetype>(row)), Qt::AlignLeft,
                      form::smallPoints);
            } else if (i + 1 == form::signerWidths.size() && row == 0) {
                value(sheet, cell, QLocale().toString(m_head.date, form::text(form::dateFormat)),
                      Qt::AlignHCenter, form::smallPoints);
            }
            x += form::signerWidths.at(i);
        }
    }
}

void CardSheets::addDesignations(FormSheet& sheet) const {
    const double x = form::left + signersWidth;
    QStringList designations = m_head.designations();
    designations.front().clear(); // the maker stands beside the logo
    captionedRow(sheet, form::designations, designations, x, signersTop, form::pitch);
    addCompany(sheet,
               {x, signersTop + form::pitch - 5.2, form::designations.front().width_mm, 5.2});
    captionedRow(sheet, form::names, m_head.names(), x, signersTop + form::pitch);
}

void CardSheets::addCompany(FormSheet& sheet, const QRectF& cell) const {
    QRectF rest = cell;
    const QImage logo = Logo::image(m_head.company.logo);
    if (!logo.isNull()) {
        constexpr double most_mm = 24;
        const double wide = std::min(most_mm, (cell.height() - 0.8) * logo.width() / logo.height());
        sheet.pictures.push_back(
            {{cell.left() + form::pad, cell.top() + 0.2, wide, cell.height() - 0.8},
             logo,
             m_head.maker()});
        rest.setLeft(cell.left() + wide + form::pad);
    }
    value(sheet, rest, m_head.maker());
}

void CardSheets::addFoot(FormSheet& sheet, const form::Kind& kind) {
    constexpr double symbolWidth = 20;
    sheet.lines.push_back(
        {QLineF(form::left, form::footTop, form::right, form::footTop), form::thick});
    const double height = form::footBottom - form::footTop;
    const QRectF symbol(form::left, form::footTop, symbolWidth, height);
    sheet.frame(symbol, form::thin);
    sheet.texts.push_back(fitted(symbol, form::text(kind.symbol), 12, Qt::AlignHCenter));
    const QRectF name(form::left + symbolWidth, form::footTop, form::width - symbolWidth, height);
    sheet.frame(name, form::thin);
    value(sheet, name, form::text(kind.name), Qt::AlignLeft, 10);
    sheet.texts.back().isHeading = true;
    value(sheet, {form::left, form::footBottom, form::width, form::bottom - form::footBottom},
          form::text(kind.note), Qt::AlignLeft, form::captionPoints);
}

void CardSheets::addLine(FormSheet& sheet, const Line& line, double y, std::size_t number,
                         int tableRow) {
    const CardRow& row = line.row;
    sheet.lines.push_back(
        {QLineF(form::left, y + form::pitch, form::right, y + form::pitch), form::thin});
    double x = form::left;
    for (std::size_t i = 0; i < form::columns.size(); ++i) {
        const QRectF cell(x, y, form::columns.at(i).width_mm, form::pitch);
        const TablePlace place{tableRow, static_cast<int>(i)};
        const bool joined =
            row.cells.isEmpty() && number > 0 && i > form::firstValue - 1 && i < form::mainColumn;
        if (!joined) { // the cells of a text are merged
            sheet.lines.push_back({QLineF(x, y, x, y + form::pitch), form::thin});
        }
        if (i == 0 && number > 0) {
            const QString count = QStringLiteral("%1").arg(number, 2, 10, QChar(u'0'));
            value(sheet, {cell.topLeft(), QSizeF(cell.width() / 2, form::pitch)}, row.symbol,
                  Qt::AlignLeft, form::valuePoints, place);
            value(sheet, cell.adjusted(cell.width() / 2 - form::pad, 0, 0, 0), count,
                  Qt::AlignRight, form::smallPoints, place);
        } else if (i == form::contentColumn && !row.text.isEmpty()) {
            sheet.texts.push_back(
                {{x + form::pad, y, contentWidth(!row.cells.isEmpty()) - 2 * form::pad,
                  form::pitch},
                 row.text,
                 form::valuePoints,
                 Qt::AlignLeft,
                 TablePlace{
                     tableRow, place.column,
                     static_cast<int>((row.cells.isEmpty() ? form::mainColumn : form::firstValue)
                                      - form::contentColumn)}});
        } else if (i >= form::firstValue && i < form::mainColumn) {
            value(sheet, cell, row.cells.value(static_cast<qsizetype>(i - form::firstValue)),
                  Qt::AlignHCenter, form::valuePoints, place);
        } else if (i >= form::mainColumn) {
            value(sheet, cell, i == form::mainColumn ? row.main : row.auxiliary, Qt::AlignHCenter,
                  form::valuePoints, place);
        }
        x += form::columns.at(i).width_mm;
    }
}

} // namespace sparkout::report
