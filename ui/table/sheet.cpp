// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/table/sheet.h"

#include "core/project/project.h"
#include "core/quality/constraints.h"
#include "core/quality/run_summary.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <utility>

namespace sparkout {

namespace {

constexpr int shownDigits = 6;
constexpr int mostDecimals = 9;
constexpr double smallestInSheet = 1e-4; // below it decimals would be mostly zeros
constexpr double mostWhole = 1e15;

/// Units in headings of tables besides those of inputs and results.
constexpr const char* otherUnits[] = {
    QT_TRANSLATE_NOOP("Unit", "s"),     QT_TRANSLATE_NOOP("Unit", "min"),
    QT_TRANSLATE_NOOP("Unit", "mm"),    QT_TRANSLATE_NOOP("Unit", "µm"),
    QT_TRANSLATE_NOOP("Unit", "N"),     QT_TRANSLATE_NOOP("Unit", "W"),
    QT_TRANSLATE_NOOP("Unit", "kW"),    QT_TRANSLATE_NOOP("Unit", "%"),
    QT_TRANSLATE_NOOP("Unit", "°"),     QT_TRANSLATE_NOOP("Unit", "mm/N"),
    QT_TRANSLATE_NOOP("Unit", "nm/N"),  QT_TRANSLATE_NOOP("Unit", "mm/min"),
    QT_TRANSLATE_NOOP("Unit", "mm³"),   QT_TRANSLATE_NOOP("Unit", "kJ"),
    QT_TRANSLATE_NOOP("Unit", "J/mm³"), QT_TRANSLATE_NOOP("Unit", "mm³/(mm·s)"),
    QT_TRANSLATE_NOOP("Unit", "m/min"), QT_TRANSLATE_NOOP("Unit", "rev/min")};

void addUnits(const StructInfo& table, QSet<QString>& units) {
    for (const Field& field : table.fields) {
        if (*field.unit) {
            units << unitText(field.unit) << QString::fromUtf8(field.unit);
        }
        if (field.nested) {
            addUnits(*field.nested, units);
        }
    }
}

QSet<QString> knownUnits() {
    QSet<QString> units;
    addUnits(tableOf<Project>(), units);
    addUnits(tableOf<RunSummary>(), units);
    for (const Requirement& row : requirementRows) {
        units << unitText(row.unit);
    }
    for (const char* unit : otherUnits) {
        units << unitText(unit);
    }
    units.remove(QString());
    return units;
}

/// Splits "actual feed, µm: largest" into "actual feed: largest" and "µm"; a text without a known
/// unit is not split.
std::pair<QString, QString> parted(const QString& header, const QSet<QString>& units) {
    static const QRegularExpression pattern(QStringLiteral("^(.+), ([^,:]+)(: [^:]+)?$"));
    const QRegularExpressionMatch match = pattern.match(header);
    if (!match.hasMatch() || !units.contains(match.captured(2))) {
        return {header, {}};
    }
    return {match.captured(1) + match.captured(3), match.captured(2)};
}

int decimalsOf(const CsvTable& table, std::size_t column) {
    double size = 0;
    bool whole = true;
    for (const auto& row : table.rows) {
        const auto* number = column < row.size() ? std::get_if<double>(&row[column]) : nullptr;
        if (number && std::isfinite(*number)) {
            size = std::max(size, std::abs(*number));
            whole = whole && *number == std::floor(*number) && std::abs(*number) < mostWhole;
        }
    }
    if (whole) {
        return 0;
    }
    const bool extreme = size < smallestInSheet || size >= mostWhole;
    return extreme ? SheetColumn::scientific
                   : std::clamp(shownDigits - 1 - static_cast<int>(std::floor(std::log10(size))), 1,
                                mostDecimals);
}

Sheet sheetOfRows(std::shared_ptr<const CsvTable> table, std::vector<SheetColumn> columns,
                  const QString& name, std::vector<std::size_t> rows) {
    Sheet sheet;
    sheet.name = name;
    sheet.columns = std::move(columns);
    sheet.rows = rows.size();
    sheet.fill = [table = std::move(table), rows = std::move(rows)](std::size_t row,
                                                                    std::vector<CsvCell>& cells) {
        const std::vector<CsvCell>& from = table->rows[rows[row]];
        for (std::size_t i = 0; i < cells.size(); ++i) {
            cells[i] = i < from.size() ? from[i] : CsvCell();
        }
    };
    return sheet;
}

std::vector<SheetColumn> columnsOf(const CsvTable& table) {
    const QSet<QString> units = knownUnits();
    std::vector<SheetColumn> columns;
    for (qsizetype i = 0; i < table.header.size(); ++i) {
        QString header = table.header[i];
        auto [name, unit] = parted(header.replace(QChar::Nbsp, u' '), units);
        columns.push_back({name, unit,
                           table.ownUnits ? SheetColumn::general
                                          : decimalsOf(table, static_cast<std::size_t>(i))});
    }
    return columns;
}

QString firstText(const std::vector<CsvCell>& row) {
    const QString* text = row.empty() ? nullptr : std::get_if<QString>(&row.front());
    return text ? *text : QString();
}

} // namespace

bool Sheet::hasUnits() const {
    return std::ranges::any_of(columns, [](const SheetColumn& c) { return !c.unit.isEmpty(); });
}

Sheet sheetOf(const CsvTable& table, const QString& name) {
    std::vector<std::size_t> rows(table.rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        rows[i] = i;
    }
    return sheetOfRows(std::make_shared<CsvTable>(table), columnsOf(table), name, std::move(rows));
}

std::vector<Sheet> sheetsOf(const CsvTable& table, const QString& name) {
    if (!table.byPlace || table.rows.empty()) {
        return {sheetOf(table, name)};
    }
    QStringList places;
    std::vector<std::vector<std::size_t>> rows;
    for (std::size_t i = 0; i < table.rows.size(); ++i) {
        const QString place = firstText(table.rows[i]);
        auto at = places.indexOf(place);
        if (at < 0) {
            at = places.size();
            places << place;
            rows.emplace_back();
        }
        rows[static_cast<std::size_t>(at)].push_back(i);
    }
    const auto shared = std::make_shared<CsvTable>(table);
    const std::vector<SheetColumn> columns = columnsOf(table);
    std::vector<Sheet> sheets;
    for (qsizetype i = 0; i < places.size(); ++i) {
        sheets.push_back(
            sheetOfRows(shared, columns, places[i], std::move(rows[static_cast<std::size_t>(i)])));
    }
    return sheets;
}

QByteArray csvBytes(const Sheet& sheet, CsvDialect dialect, const KeepGoing& keepGoing) {
    std::vector<CsvCell> cells(sheet.columns.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        cells[i] = sheet.columns[i].nameWithUnit();
    }
    QByteArray bytes = csvBegin() + csvLine(cells, dialect);
    for (std::size_t row = 0; row < sheet.rows; ++row) {
        if (row % rowsBetweenLooks == 0 && keepGoing
            && !keepGoing(double(row) / double(sheet.rows))) {
            return {};
        }
        sheet.fill(row, cells);
        bytes += csvLine(cells, dialect);
    }
    return bytes;
}

namespace {

/// Converts a cell for the writer, reusing the memory of its last text.
void putCell(const CsvCell& cell, xlsx::Cell& to) {
    if (const auto* text = std::get_if<QString>(&cell)) {
        const QByteArray bytes = text->toUtf8();
        auto* old = std::get_if<std::string>(&to);
        (old ? *old : to.emplace<std::string>())
            .assign(bytes.constData(), std::size_t(bytes.size()));
    } else if (const auto* value = std::get_if<double>(&cell)) {
        to = *value;
    } else {
        to = std::monostate();
    }
}

/// The workbook sheet with a name; the source of its rows must outlive it.
xlsx::Sheet sheetFor(const Sheet& sheet, const QString& name) {
    xlsx::Sheet made{name.toStdString(), {}, sheet.rows};
    for (const SheetColumn& column : sheet.columns) {
        made.columns.push_back(
            {column.name.toStdString(), column.unit.toStdString(), column.decimals});
    }
    made.fill = [&sheet, cells = std::vector<CsvCell>(sheet.columns.size())](
                    std::size_t row, std::vector<xlsx::Cell>& to) mutable {
        sheet.fill(row, cells);
        for (std::size_t i = 0; i < cells.size(); ++i) {
            putCell(cells[i], to[i]);
        }
    };
    return made;
}

QString cutTo(const QString& text, qsizetype length) {
    return (text.size() > length && text[length - 1].isHighSurrogate()) ? text.left(length - 1)
                                                                        : text.left(length);
}

} // namespace

const Sheet* sheetTooLong(const std::vector<Sheet>& sheets) {
    const auto found = std::ranges::find_if(
        sheets, [](const Sheet& sheet) { return !xlsx::takesRows(sheet.rows, sheet.hasUnits()); });
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
    QStringList names;
    for (const Sheet& sheet : book.sheets) {
        names << sheet.name;
    }
    names = sheetNames(names);
    xlsx::Book made{
        book.title.toStdString(), book.author.toStdString(), book.program.toStdString(), {}};
    for (const Sheet& sheet : book.sheets) {
        made.sheets.push_back(sheetFor(sheet, names[static_cast<qsizetype>(made.sheets.size())]));
    }
    return QByteArray::fromStdString(xlsx::bytesOf(made, keepGoing));
}

} // namespace sparkout
