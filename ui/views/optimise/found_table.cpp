// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/optimise/found_table.h"

#include "core/optimisation/limit.h"
#include "core/units.h"
#include "ui/views/optimise/optimise_text.h"

#include <QLocale>

#include <utility>

namespace sparkout {

namespace {

struct FoundTable {
    Q_DECLARE_TR_FUNCTIONS(FoundTable)
};

std::vector<ValueHead> headsOf(const SearchOutcome& outcome) {
    std::vector<ValueHead> heads{
        {.text = FoundTable::tr("Time"),
         .name = FoundTable::tr("Time, min"),
         .tip = FoundTable::tr("Machining time"),
         .key = "time"},
        {.text = FoundTable::tr("Cycle"),
         .tip = OptimiseText::cycleHint(outcome.project.operation),
         .key = "cycle",
         .isText = true},
        {.text = FoundTable::tr("Stages"),
         .tip = FoundTable::tr("Number of stages"),
         .key = "stages"},
        {.text = FoundTable::tr("Against yours, %"),
         .tip = FoundTable::tr("Against the time of your cycle: the present one, or the one that a "
                               "cycle found took the place of"),
         .key = "change"},
        {.text = FoundTable::tr("Gap, %"),
         .tip = FoundTable::tr("By how much a stepless cycle might at most be quicker"),
         .key = "gap"},
        {.text = FoundTable::tr("Margin, %"),
         .tip = FoundTable::tr("The minimum margin of all requirements, of its limit"),
         .key = "margin"}};
    if (outcome.wear) {
        heads.push_back(
            {.text = FoundTable::tr("Parts"),
             .tip = FoundTable::tr("Parts from one dressing to the next that it holds for"),
             .key = "parts"});
        heads.push_back({.text = FoundTable::tr("Cost"),
                         .tip = FoundTable::tr("Cost of a part with its share of the dressing"),
                         .key = "cost"});
    }
    return heads;
}

QString kindOf(const SearchOutcome& outcome, const FoundCycle& found) {
    if (outcome.marginWithin_us && (found.isBest || found.isBestOfItsNumber)) {
        return found.isBest
                   ? FoundTable::tr(
                       "The farthest of the grid from its limits within the time given")
                   : FoundTable::tr(
                       "The farthest of its number of stages from its limits, within the time");
    }
    if (outcome.wear && outcome.objective() == SearchObjective::cost) {
        return found.isBest ? FoundTable::tr("The cheapest of the grid")
                            : FoundTable::tr("The cheapest of its number of stages");
    }
    if (outcome.wear) {
        return found.isBest
                   ? FoundTable::tr("The one of the grid that keeps the wheel longest")
                   : FoundTable::tr("The one of its number of stages that keeps the wheel longest");
    }
    if (found.isBest) {
        return FoundTable::tr("The quickest of the grid");
    }
    if (found.isBestOfItsNumber) {
        return FoundTable::tr("The quickest of its number of stages");
    }
    switch (found.by) {
    case FoundBy::search: break;
    case FoundBy::margin: return FoundTable::tr("None is both quicker and farther from its limits");
    case FoundBy::refinement: return FoundTable::tr("Between the levels of the grid, not proved");
    }
    return FoundTable::tr("The best so far when it was found");
}

/// In per cent.
ValueCell shareCell(const std::optional<double>& share) {
    constexpr double perCent = 100;
    return ValueCell::of(share ? std::optional(perCent * *share) : std::nullopt,
                         [](double value) { return OptimiseText::percent(value / perCent); });
}

std::vector<ValueCell> cellsOf(const SearchOutcome& outcome, const FoundCycle& found,
                               std::optional<double> before_s) {
    const auto stages = static_cast<double>(found.cycle.stages.size());
    std::vector<ValueCell> cells{
        {.text = OptimiseText::time(found.time_s), .value = found.time_s / units::secondsPerMinute},
        {.text = OptimiseText::found(found, outcome.project)},
        {.text = QLocale().toString(qulonglong(found.cycle.stages.size())), .value = stages},
        shareCell(before_s && *before_s > 0 ? std::optional(found.time_s / *before_s - 1)
                                            : std::nullopt),
        shareCell(gapToLimit(found.time_s, outcome.limit.time_s)),
        shareCell(found.leastRelativeMargin)};
    if (outcome.wear) {
        cells.push_back(
            ValueCell::of(found.held ? std::optional(double(found.held->parts)) : std::nullopt,
                          [&found](double) { return OptimiseText::parts(*found.held); }));
        cells.push_back(ValueCell::of(found.cost, OptimiseText::cost));
    }
    return cells;
}

} // namespace

ValueTable foundTable(const SearchOutcome& outcome, std::optional<double> before_s) {
    ValueTable table{.columns = headsOf(outcome), .isList = true};
    for (const FoundCycle& found : outcome.found) {
        const QString text = OptimiseText::found(found, outcome.project);
        table.addRow({.text = QString::number(table.rows.size() + 1),
                      .tip = kindOf(outcome, found) + u'\n' + text,
                      .isStrong = found.isBestOfItsNumber},
                     cellsOf(outcome, found, before_s));
    }
    return table;
}

} // namespace sparkout
