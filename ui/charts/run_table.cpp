// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/run_table.h"

#include "core/project/leaves.h"
#include "core/quality/finished_surface.h"
#include "ui/text/field_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string_view>

namespace sparkout {

namespace {

struct RunTable {
    Q_DECLARE_TR_FUNCTIONS(RunTable)
};

const QString noValue = QStringLiteral("–");
const QString levelSign = QStringLiteral(" › ");

/// What one run has of a row.
struct RunValue {
    std::string path;
    QString what; ///< empty: the place of the path in words
    QString unit;
    QString shown;
    CsvCell cell;
    QString symbol = {};                               ///< of an input
    std::vector<std::pair<QString, double>> list = {}; ///< of an input: its items, each with a name
};
using RunValues = std::vector<RunValue>;

// --- inputs -------------------------------------------------------------------------------------

/// The items of a list, by number or zone; nothing of another input.
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

RunValues inputValues(const Project& project) {
    RunValues values;
    for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
        const Field& field = *leaf.field;
        const bool isRead = !field.relevant || field.relevant(project, leaf.owner);
        if (leaf.path.starts_with("/runs") || leaf.path.starts_with("/sweep") || !isRead) {
            continue;
        }
        const std::optional<double> number = singleNumberIn(field, leaf.owner);
        const QString shown =
            number ? showNumber(*number, QLocale()) : fieldText(field, leaf.owner);
        values.push_back({leaf.path,
                          {},
                          unitText(field.unit),
                          shown,
                          number ? CsvCell(*number) : CsvCell(shown),
                          QString::fromUtf8(field.symbol),
                          itemsOf(field, leaf.owner)});
    }
    return values;
}

// --- results ------------------------------------------------------------------------------------

QString zoneName(const RunSummary& summary, std::size_t index) {
    const std::string& zone = summary.zones.at(index).zone;
    return zone == "section" ? Names::zone(Zone::section, static_cast<int>(index))
                             : zoneText(zone.c_str());
}

QString numberShown(const Field& field, double value) {
    const std::string_view unit(field.unit);
    const std::string_view key(field.key);
    if (unit == "µm") {
        return key.starts_with("diameter_deviation") ? Names::signedMicrometres(value)
                                                     : Names::micrometres(value);
    }
    return Names::significant(value, unit == "min" ? 4 : 3);
}

/// As the verdict has it; nothing of a requirement this version does not know.
std::optional<ConstraintResult> constraintOf(const RequirementSummary& requirement,
                                             bool strips = false) {
    const Requirement* const row = requirementNamed(requirement.name);
    if (!row) {
        return std::nullopt;
    }
    ConstraintResult constraint{row->kind};
    const QStringList where = QString::fromStdString(requirement.where).split(u' ');
    const int number = where.value(1).toInt();
    constraint.section = -1;
    if (where[0] == u"section") {
        constraint.section = number;
    } else if (where[0] == u"stage") {
        constraint.stage = number;
    } else if (where[0] == u"rz1" || where[0] == u"nz" || where[0] == u"rz2") {
        constraint.section = where[0] == u"rz1" ? 0 : where[0] == u"nz" ? 1 : 2;
        constraint.zone = static_cast<Zone>(constraint.section);
    }
    constraint.limit = requirement.limit;
    constraint.value = requirement.value;
    constraint.margin = requirement.margin;
    constraint.relativeMargin = requirement.relative_margin;
    constraint.holds = requirement.ok;
    constraint.isWhole = !strips || !row->isOfSurface();
    return constraint;
}

QString percentShown(double share) {
    const QString number = Names::significant(share * 100, 2);
    return RunTable::tr("%1 %").arg(share > 0 ? u'+' + number : number);
}

bool leftStrips(const RunSummary& summary) {
    return std::ranges::any_of(summary.requirements, [](const RequirementSummary& requirement) {
        return requirement.name == requirementOf(ConstraintKind::overlap).key && !requirement.ok;
    });
}

/// Whether a value of a summary is of the finished surface.
bool isOfSurface(std::string_view key) {
    return key.starts_with("diameter_deviation") || key == "radial_runout_um"
           || key == "roundness_um" || key == "cylindricity_um" || key == "total_runout_um"
           || key == "radii_um";
}

void addRequirements(const RunSummary& summary, RunValues& values) {
    const bool strips = leftStrips(summary);
    const RequirementSummary* worst = nullptr;
    for (const RequirementSummary& requirement : summary.requirements) {
        const std::optional<ConstraintResult> constraint = constraintOf(requirement, strips);
        if (!constraint || !constraint->isWhole) {
            continue; // of a part of the surface alone
        }
        values.push_back({"/requirements/" + requirement.name + "/margin",
                          RunTable::tr("Margin › %1").arg(Names::constraint(constraint->kind)),
                          unitText(requirementOf(constraint->kind).unit),
                          Names::amount(constraint->kind, requirement.margin, true),
                          requirement.margin});
        if (!worst || requirement.relative_margin < worst->relative_margin) {
            worst = &requirement;
        }
    }
    if (worst) {
        const ConstraintResult constraint = *constraintOf(*worst, strips);
        const QString text = RunTable::tr("%1, %2: %3")
                                 .arg(Names::constraint(constraint.kind), Names::where(constraint),
                                      percentShown(worst->relative_margin));
        values.push_back({"/worst", RunTable::tr("Worst margin"), {}, text, text});
    }
    if (const std::optional<Light> light = verdictOf(summary)) {
        const QString verdict = lightName(*light);
        values.push_back({"/verdict", RunTable::tr("Verdict"), {}, verdict, verdict});
    }
}

void addCounts(const std::vector<double>& counts, const std::string& path, RunValues& values) {
    for (std::size_t i = 0; i < counts.size(); ++i) {
        values.push_back({path + '/' + std::to_string(i),
                          RunTable::tr("Stage %1 › Double strokes or revolutions").arg(i + 1),
                          {},
                          QString::number(counts[i]),
                          counts[i]});
    }
}

/// A value of the summary that is a number or a choice.
RunValue resultValue(const RunSummary& summary, const Leaf& leaf) {
    const Field& field = *leaf.field;
    QString what = inputText(field.label);
    const QStringList steps = QString::fromStdString(leaf.path).split(u'/', Qt::SkipEmptyParts);
    if (steps.size() == 3 && steps[0] == u"zones") {
        what.prepend(zoneName(summary, steps[1].toUInt()) + levelSign);
    }
    if (field.kind == Kind::integer) {
        const int count = field.as<int>(leaf.owner);
        return {leaf.path, what, unitText(field.unit), QString::number(count), double(count)};
    }
    if (field.kind == Kind::number) {
        const double value = field.as<double>(leaf.owner);
        return {leaf.path, what, unitText(field.unit), numberShown(field, value), value};
    }
    const QString shown = fieldText(field, leaf.owner);
    return {leaf.path, what, unitText(field.unit), shown, shown};
}

RunValues resultValues(const ReadSummary& read) {
    RunValues values;
    const bool strips = leftStrips(read.summary);
    for (const Leaf& leaf : leavesOf(tableOf<RunSummary>(), &read.summary)) {
        const Field& field = *leaf.field;
        if (read.missing.contains(leaf.path) || leaf.path.starts_with("/requirements")
            || (strips && isOfSurface(field.key))) {
            continue;
        }
        if (leaf.path == "/counts_by_stage") {
            addCounts(field.as<std::vector<double>>(leaf.owner), leaf.path, values);
        } else if (field.kind == Kind::number || field.kind == Kind::integer
                   || field.kind == Kind::choice) {
            values.push_back(resultValue(read.summary, leaf));
        }
    }
    addRequirements(read.summary, values);
    return values;
}

// --- rows ---------------------------------------------------------------------------------------

/// The rows in which the runs differ; what only one of them has stands where it has it. A run of
/// which nothing is known differs in nothing.
void addDiffering(const std::vector<RunValues>& runs, bool isResult, std::vector<RunRow>& rows) {
    std::vector<std::string> order;
    std::map<std::string, RunRow> byPath;
    for (std::size_t run = 0; run < runs.size(); ++run) {
        auto at = order.begin();
        for (const RunValue& value : runs[run]) {
            const auto [row, isNew] = byPath.try_emplace(value.path);
            if (isNew) {
                at = std::next(order.insert(at, value.path));
                row->second = {value.what, value.unit, {}, {}, isResult};
                row->second.shown.fill(noValue, static_cast<qsizetype>(runs.size()));
                row->second.cells.resize(runs.size());
            } else {
                at = std::next(std::ranges::find(order, value.path));
            }
            row->second.shown[static_cast<qsizetype>(run)] = value.shown;
            row->second.cells[run] = value.cell;
        }
    }
    for (const std::string& path : order) {
        RunRow& row = byPath.at(path);
        QStringList known;
        for (std::size_t run = 0; run < runs.size(); ++run) {
            if (!runs[run].empty()) {
                known << row.shown[static_cast<qsizetype>(run)];
            }
        }
        if (known.removeDuplicates(); known.size() > 1) {
            row.what = row.what.isEmpty() ? locationText(path) : row.what;
            rows.push_back(std::move(row));
        }
    }
}

/// The largest difference of two lists that are as long; nothing of others.
std::optional<double> largestStep(const std::vector<double>& a, const std::vector<double>& b) {
    if (a.size() != b.size()) {
        return std::nullopt;
    }
    double largest = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
        largest = std::max(largest, std::abs(a[i] - b[i]));
    }
    return largest;
}

/// With all digits where the usual ones do not tell the two apart.
QString changeShown(const ChangedValue& change) {
    const Field& field = *change.kept.field;
    if (!change.now) {
        return RunTable::tr("no longer there");
    }
    if (field.kind == Kind::numberList) {
        const auto step = largestStep(field.as<std::vector<double>>(change.kept.owner),
                                      field.as<std::vector<double>>(change.now->owner));
        return step ? RunTable::tr("by up to %1").arg(Names::significant(*step, 2))
                    : RunTable::tr("another number of values");
    }
    const std::optional<double> before = singleNumberIn(field, change.kept.owner);
    const std::optional<double> after = singleNumberIn(field, change.now->owner);
    QString from = before ? numberShown(field, *before) : fieldText(field, change.kept.owner);
    QString to = after ? numberShown(field, *after) : fieldText(field, change.now->owner);
    if (before && after && from == to) {
        from = showNumber(*before, QLocale());
        to = showNumber(*after, QLocale());
    }
    return QStringLiteral("%1 → %2").arg(from, to);
}

QString changeName(const ReadSummary& kept, const ChangedValue& change) {
    const QStringList steps = QString::fromStdString(change.path).split(u'/', Qt::SkipEmptyParts);
    const QString label = inputText(change.kept.field->label);
    if (steps.size() < 3) {
        return label;
    }
    if (steps[0] == u"zones") {
        return zoneName(kept.summary, steps[1].toUInt()) + levelSign + label;
    }
    const auto constraint = constraintOf({steps[1].toStdString(), "part"});
    return (constraint ? Names::constraint(constraint->kind) : steps[1]) + levelSign + label;
}

} // namespace

std::vector<RunRow> differingRows(const std::vector<ComparedValues>& runs) {
    std::vector<RunValues> inputs, results;
    for (const ComparedValues& run : runs) {
        inputs.push_back(run.inputs ? inputValues(*run.inputs) : RunValues());
        results.push_back(run.summary ? resultValues(*run.summary) : RunValues());
    }
    std::vector<RunRow> rows;
    addDiffering(inputs, false, rows);
    addDiffering(results, true, rows);
    return rows;
}

QStringList changesShown(const ReadSummary& kept, const RunSummary& now) {
    QStringList lines;
    for (const ChangedValue& change : changedSince(kept, now)) {
        const QString unit = unitText(change.kept.field->unit);
        const QString line =
            QStringLiteral("%1: %2").arg(changeName(kept, change), changeShown(change));
        lines << (unit.isEmpty() || !change.now ? line : line + u'\u00a0' + unit);
    }
    return lines;
}

CsvTable inputTable(const Project& project) {
    CsvTable table;
    table.ownUnits = true;
    table.header << RunTable::tr("Input") << RunTable::tr("Symbol") << RunTable::tr("Unit")
                 << RunTable::tr("Value") << RunTable::tr("Key in the file");
    for (const RunValue& value : inputValues(project)) {
        const QString what = locationText(value.path).remove(QChar::SoftHyphen);
        const QString path = QString::fromStdString(value.path);
        if (value.list.size() > 1) { // numbers, not a text of numbers
            for (std::size_t i = 0; i < value.list.size(); ++i) {
                const auto& [name, number] = value.list[i];
                table.rows.push_back({what + levelSign + name, value.symbol, value.unit, number,
                                      QStringLiteral("%1/%2").arg(path).arg(i)});
            }
            continue;
        }
        table.rows.push_back({what, value.symbol, value.unit, value.cell, path});
    }
    return table;
}

CsvTable cycleTable(const RunSummary& summary) {
    CsvTable table;
    table.ownUnits = true;
    table.header << RunTable::tr("Quantity") << RunTable::tr("Unit") << RunTable::tr("Value");
    for (const RunValue& value : resultValues({summary, {}})) {
        const bool elsewhere = value.path.starts_with("/requirements")
                               || value.path.starts_with("/zones")
                               || value.path.starts_with("/counts_by_stage");
        if (!elsewhere) {
            table.rows.push_back({value.what, value.unit, value.cell});
        }
    }
    return table;
}

std::optional<Light> verdictOf(const RunSummary& summary) {
    if (summary.requirements.empty()) {
        return std::nullopt;
    }
    Light light = summary.status == RunStatus::completed ? Light::holds : Light::fails;
    for (const RequirementSummary& requirement : summary.requirements) {
        if (const auto constraint = constraintOf(requirement)) {
            light = std::max(light, lightOf(*constraint));
        }
    }
    return light;
}

} // namespace sparkout
