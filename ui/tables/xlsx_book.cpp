// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tables/xlsx_book.h"

#include <QRegularExpression>
#include <QSet>

#include <algorithm>
#include <string>
#include <utility>

namespace sparkout {

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
