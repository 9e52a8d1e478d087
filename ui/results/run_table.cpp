// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/results/run_table.h"

#include "ui/results/verdict_table.h"
#include "ui/text/field_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QLocale>

#include <optional>
#include <string_view>
#include <utility>
#include <variant>

namespace sparkout {

namespace {

struct RunTable {
    Q_DECLARE_TR_FUNCTIONS(RunTable)
};

const QString noValue = QStringLiteral("–");
const QString levelSign = QStringLiteral(" › ");

/// A value in words.
struct ShownValue {
    QString what;
    QString unit;
    QString shown;
    CsvCell cell;
};

QString numberShown(const Field& field, double value) {
    const ResultDigits digits = digitsOf(field);
    if (digits.decimals < 0) {
        return Names::significant(value, digits.significant);
    }
    const bool hasSign = std::string_view(field.key).starts_with("diameter_deviation");
    return hasSign ? Names::signedMicrometres(value) : Names::fixed(value, digits.decimals);
}

/// The items of a list, by number or zone; empty for other inputs.
std::vector<std::pair<QString, double>> itemsOf(const Field& field, const void* owner) {
    std::vector<double> values;
    if (field.kind == Kind::numberList) {
        values = field.as<std::vector<double>>(owner);
    } else if (field.kind == Kind::optionalNumberList) {
        values = field.as<std::optional<std::vector<double>>>(owner).value_or(values);
    } else if (field.kind == Kind::compliance) {
        const auto& given = field.as<GivenCompliance>(owner);
        if (const auto* zones = std::get_if<ZoneCompliance>(&given)) {
            return {{Names::zone(Zone::rz1), zones->rz1},
                    {Names::zone(Zone::nz), zones->nz},
                    {Names::zone(Zone::rz2), zones->rz2}};
        }
        if (const auto* sections = std::get_if<std::vector<double>>(&given)) {
            values = *sections;
        }
    }
    std::vector<std::pair<QString, double>> items;
    for (std::size_t i = 0; i < values.size(); ++i) {
        items.emplace_back(field.kind == Kind::compliance
                               ? Names::zone(Zone::section, static_cast<int>(i))
                               : QString::number(i + 1),
                           values[i]);
    }
    return items;
}

/// "Section 2 › Roundness", "Cylindricity": a value of a summary.
QString resultName(const std::string& path, const Leaf& leaf) {
    const QString label = inputText(leaf.field->label);
    const QStringList steps = QString::fromStdString(path).split(u'/', Qt::SkipEmptyParts);
    if (steps.size() != 3 || steps[0] != u"zones") {
        return label;
    }
    const std::string& zone = static_cast<const ZoneSummary*>(leaf.owner)->zone;
    return (zone == "section" ? Names::zone(Zone::section, steps[1].toInt())
                              : zoneText(zone.c_str()))
           + levelSign + label;
}

QString percentShown(double share) {
    const QString number = Names::significant(share * 100, worstDigits);
    return RunTable::tr("%1 %").arg(share > 0 ? u'+' + number : number);
}

ShownValue inputShown(const RunValue& input) {
    const auto& [path, field, owner] = std::get<Leaf>(input.value);
    const std::optional<double> number = singleNumberIn(*field, owner);
    const QString shown = number ? printedNumber(*number) : fieldText(*field, owner);
    return {locationText(path), unitText(field->unit), shown,
            number ? CsvCell(*number) : CsvCell(shown)};
}

/// The words of each kind of result.
struct ResultShown {
    const std::string& path;

    ShownValue operator()(const Leaf& leaf) const {
        const Field& field = *leaf.field;
        ShownValue of{resultName(path, leaf), unitText(field.unit), {}, {}};
        if (field.kind == Kind::integer) {
            const int count = field.as<int>(leaf.owner);
            of.shown = QString::number(count);
            of.cell = double(count);
        } else if (field.kind == Kind::number) {
            const double value = field.as<double>(leaf.owner);
            of.shown = numberShown(field, value);
            of.cell = value;
        } else {
            of.shown = fieldText(field, leaf.owner);
            of.cell = of.shown;
        }
        return of;
    }
    ShownValue operator()(const StageCount& of) const {
        return {RunTable::tr("Stage %1 › Double strokes or revolutions").arg(of.stage + 1),
                {},
                QString::number(of.count),
                of.count};
    }
    ShownValue operator()(const RequirementMargin& of) const {
        const ConstraintResult& c = of.requirement;
        const QString name = RunTable::tr("Margin › %1").arg(Names::constraint(c.kind));
        const QString margin = Names::margin(c);
        if (Names::isRange(c.kind)) { // a ratio, or whether it is in range
            const std::optional<double> ratio = ratioInRange(c);
            return {name, {}, margin, ratio ? CsvCell(*ratio) : CsvCell(margin)};
        }
        return {name, unitText(requirementOf(c.kind).unit), margin,
                marginKnown(c) == MarginKnown::exactly ? CsvCell(statedMargin(c)) : CsvCell()};
    }
    ShownValue operator()(const WorstMargin& of) const {
        const ConstraintResult& worst = of.requirement;
        const QString text =
            RunTable::tr("%1, %2: %3")
                .arg(Names::constraint(worst.kind), Names::within(Names::where(worst)),
                     Names::isRange(worst.kind) ? Names::margin(worst)
                                                : percentShown(worst.relativeMargin));
        return {RunTable::tr("Worst margin"), {}, text, text};
    }
    ShownValue operator()(Light light) const {
        const QString verdict = lightName(light);
        return {RunTable::tr("Verdict"), {}, verdict, verdict};
    }
};

ShownValue resultShown(const RunValue& result) {
    return std::visit(ResultShown{result.path}, result.value);
}

/// With all digits if the usual ones do not distinguish the two.
QString changeShown(const ChangedValue& change) {
    const Field& field = *change.kept.field;
    if (!change.now) {
        return RunTable::tr("no longer there");
    }
    if (field.kind == Kind::numberList) {
        const auto step = largestDifference(field.as<std::vector<double>>(change.kept.owner),
                                            field.as<std::vector<double>>(change.now->owner));
        return step ? RunTable::tr("by up to %1").arg(Names::significant(*step, 2))
                    : RunTable::tr("another number of values");
    }
    const std::optional<double> before = singleNumberIn(field, change.kept.owner);
    const std::optional<double> after = singleNumberIn(field, change.now->owner);
    QString from = before ? numberShown(field, *before) : fieldText(field, change.kept.owner);
    QString to = after ? numberShown(field, *after) : fieldText(field, change.now->owner);
    if (before && after && from == to) {
        from = printedNumber(*before);
        to = printedNumber(*after);
    }
    return QStringLiteral("%1 → %2").arg(from, to);
}

QString briefly(const QString& text, qsizetype longest) {
    return text.size() > longest ? text.left(longest - 1) + u'…' : text;
}

/// A unit is never broken at its slash.
QString inOneLine(QString text) {
    return text.replace(u'/', QStringLiteral("\u2060/\u2060"));
}

CsvTable sheetOf(const std::vector<RunRow>& rows, const QStringList& runs) {
    CsvTable table;
    table.ownUnits = true;
    table.header << RunTable::tr("Quantity") << RunTable::tr("Unit") << runs;
    for (const RunRow& row : rows) {
        std::vector<CsvCell> cells{row.what, row.unit};
        cells.insert(cells.end(), row.cells.begin(), row.cells.end());
        table.rows.push_back(std::move(cells));
    }
    return table;
}

QString changeName(const ChangedValue& change) {
    const QStringList steps = QString::fromStdString(change.path).split(u'/', Qt::SkipEmptyParts);
    if (steps.size() < 3 || steps[0] == u"zones") {
        return resultName(change.path, change.kept);
    }
    const auto constraint = constraintOf({steps[1].toStdString(), "part"});
    return (constraint ? Names::constraint(constraint->kind) : steps[1]) + levelSign
           + inputText(change.kept.field->label);
}

} // namespace

std::vector<RunRow> differingRows(const std::vector<ComparedRun>& runs) {
    std::vector<RunRow> rows;
    for (const ComparedRow& compared : compareRuns(runs)) {
        RunRow row;
        row.isResult = compared.isResult;
        for (const std::optional<RunValue>& value : compared.runs) {
            if (!value) {
                row.shown << noValue;
                row.cells.emplace_back();
                continue;
            }
            const ShownValue words = compared.isResult ? resultShown(*value) : inputShown(*value);
            if (row.what.isEmpty()) {
                row.what = words.what;
                row.unit = words.unit;
            }
            row.shown << words.shown;
            row.cells.push_back(words.cell);
        }
        rows.push_back(std::move(row));
    }
    return rows;
}

ValueTable runTable(const std::vector<RunRow>& rows, const QStringList& runs) {
    constexpr qsizetype longestCell = 60, longestHead = 48; // shown; the copy has all of it
    ValueTable table{.sheet = sheetOf(rows, runs), .isList = true};
    if (rows.empty()) {
        return table;
    }
    table.columns.push_back({.text = RunTable::tr("Quantity"), .isText = true});
    for (const QString& run : runs) {
        table.columns.push_back({.text = briefly(run, longestHead), .name = run});
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const RunRow& row = rows[i];
        if (i == 0 || row.isResult != rows[i - 1].isResult) {
            std::vector<ValueCell> group(table.columns.size());
            group.front().text = row.isResult ? RunTable::tr("Results") : RunTable::tr("Inputs");
            table.addRow({.isGroup = true}, std::move(group));
        }
        const QString name =
            row.unit.isEmpty() ? row.what : QStringLiteral("%1, %2").arg(row.what, row.unit);
        std::vector<ValueCell> cells{{.text = inOneLine(name)}};
        for (const QString& shown : row.shown) {
            cells.push_back({.text = briefly(shown, longestCell), .said = shown});
        }
        table.addRow({.text = name}, std::move(cells));
    }
    return table;
}

QStringList changesShown(const ReadSummary& kept, const RunSummary& now) {
    QStringList lines;
    for (const ChangedValue& change : changedSince(kept, now)) {
        const QString unit = unitText(change.kept.field->unit);
        const QString line = QStringLiteral("%1: %2").arg(changeName(change), changeShown(change));
        lines << (unit.isEmpty() || !change.now ? line : line + u'\u00a0' + unit);
    }
    return lines;
}

CsvTable inputTable(const Project& project) {
    CsvTable table;
    table.ownUnits = true;
    table.header << RunTable::tr("Input") << RunTable::tr("Symbol") << RunTable::tr("Unit")
                 << RunTable::tr("Value") << RunTable::tr("Key in the file");
    for (const RunValue& input : inputsRead(project)) {
        const auto& leaf = std::get<Leaf>(input.value);
        ShownValue words = inputShown(input);
        words.what.remove(QChar::SoftHyphen);
        const QString symbol = QString::fromUtf8(leaf.field->symbol);
        const QString path = QString::fromStdString(input.path);
        const auto list = itemsOf(*leaf.field, leaf.owner);
        if (list.size() > 1) { // numbers, not a text of numbers
            for (std::size_t i = 0; i < list.size(); ++i) {
                const auto& [name, number] = list[i];
                table.rows.push_back({words.what + levelSign + name, symbol, words.unit, number,
                                      QStringLiteral("%1/%2").arg(path).arg(i)});
            }
            continue;
        }
        table.rows.push_back({words.what, symbol, words.unit, words.cell, path});
    }
    return table;
}

CsvTable cycleTable(const RunSummary& summary, const Project& inputs) {
    CsvTable table;
    table.ownUnits = true;
    table.header << RunTable::tr("Quantity") << RunTable::tr("Unit") << RunTable::tr("Value");
    const ReadSummary whole{summary, {}};
    for (const RunValue& value : resultsStated(whole, &inputs)) {
        const bool elsewhere = value.path.starts_with("/requirements")
                               || value.path.starts_with("/zones")
                               || value.path.starts_with("/counts_by_stage");
        if (!elsewhere) {
            const ShownValue words = resultShown(value);
            table.rows.push_back({words.what, words.unit, words.cell});
        }
    }
    return table;
}

} // namespace sparkout
