// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/table/profile_csv.h"

#include "core/file/text_table.h"
#include "core/project/part.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

constexpr qsizetype longestQuote = 60; // characters of a refused text in a message

struct TextRow {
    int line = 0; ///< line of the file, from 1
    QStringList cells;
    QChar delimiter;
    [[nodiscard]] QString text() const { return cells.join(delimiter); }
};

const Field& rowOf(const char* key) {
    return *tableOf<Part>().find(key);
}

std::vector<TextRow> rowsOf(const TableText& table, char delimiter) {
    std::vector<TextRow> rows;
    TableReader reader(table.utf8(), delimiter);
    while (reader.next()) {
        if (reader.isBlank()) {
            continue;
        }
        TextRow row{static_cast<int>(reader.line()), {}, QLatin1Char(delimiter)};
        for (const std::string_view cell : reader.cells()) {
            row.cells << QString::fromUtf8(cell);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

bool isHeader(const QString& cell) {
    const QString text = cell.trimmed();
    return !text.isEmpty() && !text.front().isDigit()
           && !QStringView(u"+-\u2212\u2013.,").contains(text.front());
}

/// Whether the numbers before the commas rise in equal steps, like a column of angles and unlike a
/// closed profile.
bool countsBeforeTheComma(const std::vector<TextRow>& rows) {
    std::vector<double> counts;
    for (const TextRow& row : rows) {
        if (const auto value = parseNumber(row.text().section(u',', 0, 0))) {
            counts.push_back(*value);
        }
    }
    if (counts.size() < 3) {
        return false;
    }
    const double step = counts[1] - counts[0];
    for (std::size_t i = 2; i < counts.size(); ++i) {
        if (counts[i] - counts[i - 1] != step) {
            return false;
        }
    }
    return step > 0;
}

/// Whether commas separate columns: most lines with a comma are not a number as a whole.
bool commaSeparates(const std::vector<TextRow>& rows) {
    int with = 0;
    int numbers = 0;
    for (const TextRow& row : rows) {
        const QString text = row.text();
        if (text.contains(u',') && !(&row == &rows.front() && isHeader(text))) {
            ++with;
            numbers += parseNumber(text) ? 1 : 0;
        }
    }
    return with > 0 && (2 * numbers < with || countsBeforeTheComma(rows));
}

/// The rows, split by their delimiter; not split by one that is absent.
std::vector<TextRow> rowsOf(const TableText& table) {
    for (const char delimiter : {';', '\t'}) {
        std::vector<TextRow> rows = rowsOf(table, delimiter);
        if (std::ranges::any_of(rows, [](const TextRow& row) { return row.cells.size() > 1; })) {
            return rows;
        }
    }
    std::vector<TextRow> rows = rowsOf(table, ';');
    return commaSeparates(rows) ? rowsOf(table, ',') : rows;
}

QString quoted(const QString& text) {
    const QString trimmed = text.trimmed();
    return trimmed.size() > longestQuote ? trimmed.left(longestQuote) + u'…' : trimmed;
}

} // namespace

ProfileCsv readProfileCsv(const TableText& text) {
    using What = ProfileCsvFault::What;
    const std::vector<TextRow> rows = rowsOf(text);
    const Range allowed = rowOf("radii_um").hard;
    std::vector<double> values;
    qsizetype columns = 0;
    for (const TextRow& row : rows) {
        const QStringList& cells = row.cells;
        if (&row == &rows.front() && isHeader(cells.back())) {
            continue;
        }
        // A comma that separates here and belongs to a number there: better refused than guessed.
        columns = columns == 0 ? cells.size() : columns;
        const auto value = cells.size() == columns ? parseNumber(cells.back()) : std::nullopt;
        if (!value) {
            const bool whole = cells.size() != columns || cells.back().isEmpty();
            return ProfileCsvFault{What::notANumber, row.line,
                                   quoted(whole ? row.text() : cells.back())};
        }
        if (!allowed.contains(*value)) {
            return ProfileCsvFault{What::outOfRange, row.line, quoted(cells.back())};
        }
        values.push_back(*value);
    }
    if (values.size() % 2 != 0
        || !rowOf("radii_per_section").hard.contains(double(values.size()))) {
        return ProfileCsvFault{What::count, 0, {}, static_cast<int>(values.size())};
    }
    return values;
}

QString profileCsvFaultText(const ProfileCsvFault& fault) {
    using What = ProfileCsvFault::What;
    const QString line = QString::number(fault.line);
    switch (fault.what) {
    case What::notANumber:
        return QCoreApplication::translate("ProfileCsv", "line %1: “%2” cannot be read as a number")
            .arg(line, fault.text);
    case What::outOfRange: {
        const Field& row = rowOf("radii_um");
        return QCoreApplication::translate("ProfileCsv",
                                           "line %1: “%2” is out of range; allowed: %3")
            .arg(line, fault.text, rangeShown(row.hard, row.unit));
    }
    case What::count: break;
    }
    return QCoreApplication::translate(
               "ProfileCsv", "it holds %n values; needed: an even number, %1", nullptr, fault.count)
        .arg(rangeShown(rowOf("radii_per_section").hard, ""));
}

} // namespace sparkout
