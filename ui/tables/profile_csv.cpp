// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tables/profile_csv.h"

#include "core/project/part.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QStringList>

#include <algorithm>

namespace sparkout {

namespace {

constexpr qsizetype longestQuote = 60; // of a refused text in a message

struct Line {
    int number = 0; ///< in the file, from 1
    QString text;
};

const Field& rowOf(const char* key) {
    return *tableOf<Part>().find(key);
}

std::vector<Line> linesOf(const QByteArray& bytes) {
    QString text = QString::fromUtf8(bytes);
    if (text.startsWith(QChar::ByteOrderMark)) {
        text.remove(0, 1);
    }
    text.replace(QStringLiteral("\r\n"), QStringLiteral("\n")).replace(u'\r', u'\n');
    std::vector<Line> lines;
    int number = 0;
    for (const QString& line : text.split(u'\n')) {
        ++number;
        if (!line.trimmed().isEmpty()) {
            lines.push_back({number, line});
        }
    }
    return lines;
}

/// The cells of a line; a separator between quotation marks belongs to its cell.
QStringList cellsOf(const QString& line, QChar separator) {
    QStringList cells{QString()};
    bool quoted = false;
    for (const QChar c : line) {
        if (c == u'"') {
            quoted = !quoted;
        } else if (c == separator && !quoted) {
            cells += QString();
        } else {
            cells.back() += c;
        }
    }
    return cells;
}

bool isHeader(const QString& cell) {
    const QString text = cell.trimmed();
    return !text.isEmpty() && !text.front().isDigit()
           && !QStringView(u"+-\u2212\u2013.,").contains(text.front());
}

/// Whether the numbers before the commas rise by equal steps, as a column of angles does and a
/// closed profile cannot.
bool countsBeforeTheComma(const std::vector<Line>& lines) {
    std::vector<double> counts;
    for (const Line& line : lines) {
        if (const auto value = parseNumber(line.text.section(u',', 0, 0))) {
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

/// Whether commas stand between columns: most lines that hold one are no number as a whole.
bool commaSeparates(const std::vector<Line>& lines) {
    int with = 0;
    int numbers = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].text.contains(u',') && !(i == 0 && isHeader(lines[i].text))) {
            ++with;
            numbers += parseNumber(lines[i].text) ? 1 : 0;
        }
    }
    return with > 0 && (2 * numbers < with || countsBeforeTheComma(lines));
}

QChar separatorOf(const std::vector<Line>& lines) {
    for (const QChar separator : {u';', u'\t'}) {
        if (std::any_of(lines.begin(), lines.end(),
                        [&](const Line& line) { return line.text.contains(separator); })) {
            return separator;
        }
    }
    return commaSeparates(lines) ? QChar(u',') : QChar(QChar::Null);
}

QString quoted(const QString& text) {
    const QString trimmed = text.trimmed();
    return trimmed.size() > longestQuote ? trimmed.left(longestQuote) + u'…' : trimmed;
}

} // namespace

ProfileCsv readProfileCsv(const QByteArray& text) {
    using What = ProfileCsvFault::What;
    const std::vector<Line> lines = linesOf(text);
    const QChar separator = separatorOf(lines);
    const Range allowed = rowOf("radii_um").hard;
    std::vector<double> values;
    qsizetype columns = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const QStringList cells =
            separator.isNull() ? QStringList{lines[i].text} : cellsOf(lines[i].text, separator);
        if (i == 0 && isHeader(cells.back())) {
            continue;
        }
        // A comma that separates here and belongs to a number there: better refused than guessed.
        columns = columns == 0 ? cells.size() : columns;
        const auto value = cells.size() == columns ? parseNumber(cells.back()) : std::nullopt;
        if (!value) {
            const bool whole = cells.size() != columns || cells.back().trimmed().isEmpty();
            return ProfileCsvFault{What::notANumber, lines[i].number,
                                   quoted(whole ? lines[i].text : cells.back())};
        }
        if (!allowed.contains(*value)) {
            return ProfileCsvFault{What::outOfRange, lines[i].number, quoted(cells.back())};
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
