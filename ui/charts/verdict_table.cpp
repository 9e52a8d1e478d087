// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/charts/verdict_table.h"

#include "core/quality/light.h"
#include "ui/charts/margin_model.h"
#include "ui/text/calibration_text.h"
#include "ui/text/limit_names.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>
#include <cstdlib>
#include <utility>

namespace sparkout {

namespace {

struct VerdictTable {
    Q_DECLARE_TR_FUNCTIONS(VerdictTable)
};

} // namespace

QString lightName(Light light) {
    switch (light) {
    case Light::holds: return VerdictTable::tr("met");
    case Light::close: return VerdictTable::tr("close to the limit");
    case Light::undecided: return VerdictTable::tr("not decided");
    case Light::fails: return VerdictTable::tr("not met");
    }
    return {};
}

QString lightName(const ConstraintResult& constraint) {
    if (!constraint.isWhole) {
        return VerdictTable::tr("not known: strips uncut");
    }
    return isLowerBound(constraint) ? VerdictTable::tr("machine not known")
                                    : lightName(lightOf(constraint));
}

namespace {

/// A name with what its group does not contain: the stage and the unit.
QString requirementName(const ConstraintResult& c, const QString& name, const QString& where) {
    QStringList parts{name};
    if (c.section < 0 && requirementOf(c.kind).scope != ConstraintScope::part) {
        if (c.stage > 0) {
            parts << where;
        }
        if (*requirementOf(c.kind).unit) {
            parts << unitText(requirementOf(c.kind).unit);
        }
    }
    return parts.join(QStringLiteral(", "));
}

int groupOf(const ConstraintResult& constraint) {
    return constraint.section >= 0 ? constraint.section
                                   : -1 - static_cast<int>(requirementOf(constraint.kind).scope);
}

QString groupName(const ConstraintResult& constraint) {
    if (constraint.section >= 0) {
        return VerdictTable::tr("%1, µm").arg(Names::zoneFull(constraint.zone, constraint.section));
    }
    switch (requirementOf(constraint.kind).scope) {
    case ConstraintScope::part: return VerdictTable::tr("Whole part, µm");
    case ConstraintScope::pass: return VerdictTable::tr("Every pass");
    case ConstraintScope::setting: return VerdictTable::tr("Machine settings");
    case ConstraintScope::section: break;
    }
    return {};
}

std::vector<ValueHead> heads() {
    return {{.text = VerdictTable::tr("Requirement"),
             .tip = VerdictTable::tr(
                 "Requirement of the drawing, the process or the machine on the cycle"),
             .isText = true},
            {.text = VerdictTable::tr("Value"), .tip = VerdictTable::tr("Worst value")},
            {.text = VerdictTable::tr("Limit"), .tip = VerdictTable::tr("Allowed value")},
            {.text = VerdictTable::tr("Margin"),
             .tip = VerdictTable::tr(
                 "Distance of the value from its limit; below 0 the limit is exceeded")}};
}

std::vector<CsvCell> copiedCells(const ConstraintResult& c) {
    return {Names::where(c),
            requirementName(c, Names::constraint(c.kind), Names::where(c)),
            Names::value(c),
            Names::limit(c),
            withoutPlus(Names::margin(c)),
            unitText(requirementOf(c.kind).unit),
            lightName(c)};
}

ValueHead headOf(const ConstraintResult& c, const Project& project) {
    const char* const by = requirementOf(c.kind).measuredBy;
    const QString guess =
        LimitNames::isGuess(c.kind, project)
            ? VerdictTable::tr("Without a measured Ra this is the range of usual wheels.")
            : QString();
    return {.text = QStringLiteral("%1, %2").arg(Names::where(c), Names::constraint(c.kind)),
            .tip = joined({Names::isRange(c.kind) ? rangeText(c) : QString(),
                           by ? requirementText(by) : QString(),
                           EstimateNames::behind(project, c.kind), guess},
                          QStringLiteral("\n"))};
}

/// The name, in words where it needs attention; else the mark is enough. The panel says above which
/// machine is not known.
ValueCell nameCell(const ConstraintResult& c, const Project& project, const LightIcons& icons) {
    const bool guessed = LimitNames::isGuess(c.kind, project);
    const QString name = requirementName(
        c, guessed ? VerdictTable::tr("Ra, estimate") : Names::constraintBrief(c.kind),
        VerdictTable::tr("stage %1").arg(c.stage));
    const Light light = lightOf(c);
    const bool isPlain = light == Light::holds || isLowerBound(c);
    return {.text = isPlain ? name : name + u'\n' + lightName(c),
            .tip = isLowerBound(c) ? lightName(c) : QString(),
            .said = lightName(c),
            .icon = icons[static_cast<std::size_t>(light)]};
}

} // namespace

std::vector<const ConstraintResult*> verdictRows(const Outcome& outcome) {
    std::vector<const ConstraintResult*> sorted, rows;
    for (const ConstraintResult& c : outcome.constraints) {
        sorted.push_back(&c);
    }
    std::ranges::stable_sort(sorted, {}, [](const ConstraintResult* c) {
        const int group = groupOf(*c);
        return std::pair(group < 0, std::abs(group)); // the zones first
    });
    for (const ConstraintResult* const c : sorted) {
        if (rows.empty() || groupOf(*rows.back()) != groupOf(*c)) {
            rows.push_back(nullptr);
        }
        rows.push_back(c);
    }
    return rows;
}

ValueTable verdictTable(const Outcome* outcome, const LightIcons& icons) {
    ValueTable table{.columns = heads(), .isList = true, .atTop = true};
    table.sheet.header << VerdictTable::tr("Zone or section");
    for (const ValueHead& column : table.columns) {
        table.sheet.header << column.text;
    }
    table.sheet.header << VerdictTable::tr("Unit") << VerdictTable::tr("Verdict");
    if (!outcome) {
        return table;
    }
    const std::vector<const ConstraintResult*> rows = verdictRows(*outcome);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (!rows[i]) {
            table.addRow({.isGroup = true}, {{.text = groupName(*rows[i + 1])}, {}, {}, {}});
            continue;
        }
        const ConstraintResult& c = *rows[i];
        table.sheet.rows.push_back(copiedCells(c));
        table.addRow(headOf(c, outcome->result.project),
                     {nameCell(c, outcome->result.project, icons),
                      {.text = Names::value(c)},
                      {.text = Names::limit(c)},
                      {.text = Names::margin(c)}});
    }
    return table;
}

} // namespace sparkout
