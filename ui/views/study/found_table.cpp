// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/study/found_table.h"

#include "core/project/optimisation.h"
#include "core/search/limit.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/views/study/optimise_text.h"

#include <QLocale>
#include <QStringList>

#include <algorithm>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

struct FoundTable {
    Q_DECLARE_TR_FUNCTIONS(FoundTable)
};

/// The common unit of both tables.
TimeUnit timeUnit(const SearchOutcome& outcome, const std::optional<double>& before_s) {
    double longest_s = before_s.value_or(0);
    for (const FoundCycle& found : outcome.found) {
        longest_s = std::max(longest_s, found.time_s);
    }
    return TimeUnit(longest_s);
}

ValueHead timeHead(const TimeUnit& unit) {
    return {.text = unit.titled(FoundTable::tr("Time")),
            .tip = FoundTable::tr("Machining time"),
            .key = "time"};
}

ValueHead changeHead() {
    return {.text = FoundTable::tr("Against\nyours, %"),
            .name = FoundTable::tr("Against yours, %"),
            .tip = FoundTable::tr("Compared with the time of your cycle: the current one, or the "
                                  "one that a found cycle replaced"),
            .key = "change"};
}

ValueHead marginHead() {
    return {.text = FoundTable::tr("Margin, %"),
            .tip = FoundTable::tr("The minimum margin of all requirements, relative to its limit"),
            .key = "margin"};
}

void addWearHeads(std::vector<ValueHead>& heads) {
    heads.push_back(
        {.text = FoundTable::tr("Parts"),
         .tip = FoundTable::tr("Parts from one dressing to the next for which it is fit"),
         .key = "parts"});
    heads.push_back({.text = FoundTable::tr("Cost"),
                     .tip = FoundTable::tr("Cost of a part with its share of the dressing"),
                     .key = "cost"});
}

std::vector<ValueHead> headsOf(const SearchOutcome& outcome, const TimeUnit& unit) {
    std::vector<ValueHead> heads{
        timeHead(unit),
        {.text = FoundTable::tr("Cycle"),
         .tip = OptimiseText::cycleHint(outcome.project.operation),
         .key = "cycle",
         .isText = true},
        {.text = FoundTable::tr("Stages"),
         .tip = FoundTable::tr("Number of stages"),
         .key = "stages"},
        changeHead(),
        {.text = FoundTable::tr("Excess, %"),
         .tip = FoundTable::tr("Maximum time by which a stepless cycle might be quicker"),
         .key = "gap"},
        marginHead()};
    if (outcome.wear) {
        addWearHeads(heads);
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
        return found.isBest ? FoundTable::tr("The cycle of the grid with the longest wheel life")
                            : FoundTable::tr(
                                "The cycle of its number of stages with the longest wheel life");
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

/// A share in per cent.
ValueCell shareCell(const std::optional<double>& share) {
    constexpr double perCent = 100;
    return ValueCell::of(share ? std::optional(perCent * *share) : std::nullopt,
                         [](double value) { return OptimiseText::percent(value / perCent); });
}

ValueCell timeCell(const std::optional<double>& time_s, const TimeUnit& unit) {
    constexpr int digits = 4;
    return ValueCell::of(time_s ? std::optional(unit.of(*time_s)) : std::nullopt,
                         [](double time) { return Names::significant(time, digits); });
}

ValueCell changeCell(const std::optional<double>& time_s, const std::optional<double>& before_s) {
    return shareCell(time_s && before_s && *before_s > 0 ? std::optional(*time_s / *before_s - 1)
                                                         : std::nullopt);
}

void addWearCells(const std::optional<PartsHeld>& held, const std::optional<double>& cost,
                  std::vector<ValueCell>& cells) {
    cells.push_back(ValueCell::of(held ? std::optional(double(held->parts)) : std::nullopt,
                                  [&held](double) { return OptimiseText::parts(*held); }));
    cells.push_back(ValueCell::of(cost, OptimiseText::cost));
}

std::vector<ValueCell> cellsOf(const SearchOutcome& outcome, const FoundCycle& found,
                               std::optional<double> before_s, const TimeUnit& unit) {
    const auto stages = static_cast<double>(found.cycle.stages.size());
    std::vector<ValueCell> cells{
        timeCell(found.time_s, unit),
        {.text = OptimiseText::found(found, outcome.project)},
        {.text = QLocale().toString(qulonglong(found.cycle.stages.size())), .value = stages},
        changeCell(found.time_s, before_s),
        shareCell(gapToLimit(found.time_s, outcome.limit.time_s)),
        shareCell(found.leastRelativeMargin)};
    if (outcome.wear) {
        addWearCells(found.held, found.cost, cells);
    }
    return cells;
}

// --- the answer ---------------------------------------------------------------------------------

/// What an answer rests on.
struct Basis {
    QStringList full = {};  ///< for the tip, speech and copies
    QStringList brief = {}; ///< shown; empty: all is shown in full

    void add(const QString& text, const QString& shown) {
        full << text;
        brief << shown;
    }
};

/// A row of answerTable(); missing values are shown as dashes.
struct AnswerRow {
    const char* key;
    QString name;
    std::optional<double> time_s = {}, margin = {};
    std::optional<PartsHeld> held = {};
    std::optional<double> cost = {};
    std::optional<double> stocksFailing = {}, partsBad = {}; ///< upper bounds of the shares
    Basis basis = {};
    bool isAnswer = false;
};

QString requirementText(ConstraintKind kind) {
    return Names::inSentence(Names::constraint(kind));
}

QString answerName(const SearchOutcome& outcome) {
    if (outcome.marginWithin_us) {
        return FoundTable::tr("Maximum margin");
    }
    if (outcome.wear && outcome.best()->held) {
        return outcome.objective() == SearchObjective::cost ? FoundTable::tr("Minimum cost")
                                                            : FoundTable::tr("Longest life");
    }
    return outcome.robust     ? FoundTable::tr("Robust answer")
           : outcome.proved() ? FoundTable::tr("Quickest cycle")
                              : FoundTable::tr("Cycle found");
}

QString added(const SearchOutcome& outcome) {
    return QLocale().toString(qulonglong(outcome.robust->added.size()));
}

/// The proof for the best cycle of the grid, in full.
QString proofOf(const SearchOutcome& outcome) {
    const QString size = OptimiseText::gridSize(outcome.search.gridSize);
    const bool isProved = outcome.proved();
    if (outcome.marginWithin_us) {
        const QString within =
            printedNumber(outcome.project.optimisation->margin_within_min.value_or(0));
        return isProved
                   ? FoundTable::tr("the largest within %1 min, proved: %2").arg(within, size)
                   : FoundTable::tr("the largest so far; within %1 min there may be a larger one")
                         .arg(within);
    }
    if (isHeuristic(outcome.method) && !isProved) {
        return FoundTable::tr("%1, a heuristic: a quicker cycle may be fit, too")
            .arg(OptimiseText::method(outcome.method));
    }
    if (!isProved) {
        return FoundTable::tr("the best so far");
    }
    if (outcome.wear && outcome.best()->held) {
        return outcome.objective() == SearchObjective::cost
                   ? FoundTable::tr("none is cheaper, proved: %1").arg(size)
                   : FoundTable::tr("none is fit for more parts, proved: %1").arg(size);
    }
    return outcome.isByPpk() ? FoundTable::tr("proved for the part, the scenarios added (%1) and "
                                              "the required Ppk: none of %2 is quicker")
                                   .arg(added(outcome), size)
           : outcome.robust ? FoundTable::tr("proved for the part and the scenarios added (%1): "
                                             "none of %2 is quicker")
                                  .arg(added(outcome), size)
                            : FoundTable::tr("none is quicker, proved: %1").arg(size);
}

/// What an answer is good for that was searched for the nominal part, in the words of the verdict.
QString nominalBasis() {
    Judgement nominal;
    nominal.state = JudgedState::nominal;
    return Names::inSentence(JudgementText::headline(nominal));
}

QString briefProof(const SearchOutcome& outcome) {
    return outcome.proved()              ? FoundTable::tr("proved")
           : isHeuristic(outcome.method) ? FoundTable::tr("a heuristic")
                                         : FoundTable::tr("not proved");
}

void addWearBasis(const FoundCycle& best, Basis& basis) {
    if (!best.held) {
        const QString unknown = FoundTable::tr("the wear of the wheel is not given");
        basis.add(unknown, unknown);
        return;
    }
    basis.full
        << FoundTable::tr("%1 a part on average").arg(OptimiseText::time(best.held->meanTime_s));
    if (best.held->end) {
        const QString end =
            FoundTable::tr("the next part does not meet: %1").arg(requirementText(*best.held->end));
        basis.add(end, end);
    } else if (!best.held->isEndless && !best.held->isAll) {
        const QString end = FoundTable::tr("the next part does not reach its size");
        basis.add(end, end);
    }
}

/// The stocks that the answer is fit for.
void addStocks(const FoundCycle& answer, Basis& basis) {
    if (!answer.decided) {
        basis.add(FoundTable::tr("fit for %1 random stocks, cycle no. %2 tried")
                      .arg(freshPhaseCount)
                      .arg(std::max(answer.candidate, 1)),
                  FoundTable::tr("%1 random stocks").arg(freshPhaseCount));
        return;
    }
    constexpr int digits = 6; // nm
    const PhaseCases& cases = *answer.decided;
    const QString from = Names::fixed(cases.stocks.from_mm, digits),
                  to = Names::fixed(cases.stocks.to_mm, digits);
    if (cases.corners > 0) {
        basis.add(FoundTable::tr("decided for every stock of %1…%2 mm, also at %3 corners of the "
                                 "batch")
                      .arg(from, to, QLocale().toString(qlonglong(cases.corners))),
                  FoundTable::tr("every stock and corner"));
    } else {
        basis.add(FoundTable::tr("decided for every stock of %1…%2 mm").arg(from, to),
                  FoundTable::tr("every stock"));
    }
}

void addRobustBasis(const SearchOutcome& outcome, const FoundCycle& answer, Basis& basis) {
    if (!outcome.marginWithin_us && !outcome.proved()) {
        basis.full << FoundTable::tr("scenarios added: %1").arg(added(outcome));
    }
    addStocks(answer, basis);
    const FreshParts& parts = answer.freshParts;
    if (parts.tried == 0) {
        return;
    }
    basis.add(FoundTable::tr("all %1 random parts are good, cycle no. %2 tried")
                  .arg(parts.tried)
                  .arg(std::max(answer.candidate, 1)),
              FoundTable::tr("parts good"));
    if (parts.ppk) {
        const QString ppk = Names::fixed(*parts.ppk, 2),
                      brief = QStringLiteral("Ppk\u00a0≥\u00a0%1").arg(ppk);
        parts.isCapable
            ? basis.add(FoundTable::tr("Ppk at least %1").arg(ppk), brief)
            : basis.add(FoundTable::tr("Ppk at least %1, too low for the batch: no cycle found "
                                       "meets it")
                            .arg(ppk),
                        FoundTable::tr("%1, too low", "Ppk").arg(brief));
    }
}

AnswerRow foundRow(const SearchOutcome& outcome, const FoundCycle& found, AnswerRow row) {
    row.time_s = found.time_s;
    row.margin = found.leastRelativeMargin;
    row.held = found.held;
    row.cost = found.cost;
    row.isAnswer = &found == outcome.answer();
    if (row.isAnswer && outcome.robust) {
        row.stocksFailing = outcome.mostStocksFailing();
        row.partsBad = outcome.mostPartsBad();
        addRobustBasis(outcome, found, row.basis);
    }
    return row;
}

QStringList limitBasis(const SearchOutcome& outcome) {
    const LimitedCycles& cycles = outcome.limit.cycles;
    QStringList basis{FoundTable::tr("a stepless cycle")};
    if (outcome.searched.operation->travels) {
        basis << (cycles.continuousFeed_mm_min > 0
                      ? FoundTable::tr("continuous infeed up to %1 mm/min")
                            .arg(printedNumber(cycles.continuousFeed_mm_min))
                      : FoundTable::tr("no continuous infeed"));
    }
    if (!outcome.searched.operation->travels) {
        basis << (cycles.drawBack ? FoundTable::tr("the wheel head may retract")
                                  : FoundTable::tr("the wheel head never retracts"));
    }
    basis << (cycles.sparkOut ? FoundTable::tr("ends at size or by a count of steps without feed")
                              : FoundTable::tr("ends at size"));
    return basis;
}

/// The bound of a stopped search: no cycle is better.
std::optional<AnswerRow> boundRow(const SearchOutcome& outcome) {
    if (outcome.proved() || isHeuristic(outcome.method) || outcome.marginWithin_us) {
        return std::nullopt;
    }
    AnswerRow row{.key = "bound", .name = FoundTable::tr("Bound of the grid")};
    if (!outcome.wear || !outcome.best()->held) {
        row.time_s = outcome.search.bound_s;
        row.basis.full << FoundTable::tr("none is quicker");
        return row;
    }
    if (!outcome.interval->bound) {
        return std::nullopt;
    }
    if (outcome.objective() == SearchObjective::cost) {
        row.cost = outcome.interval->bound;
        row.basis.full << FoundTable::tr("none is cheaper");
    } else {
        row.held.emplace().parts = std::llround(*outcome.interval->bound);
        row.basis.full << FoundTable::tr("none is fit for more parts");
    }
    return row;
}

std::vector<AnswerRow> answerRows(const SearchOutcome& outcome, std::optional<double> before_s,
                                  std::optional<double> beforeMargin) {
    std::vector<AnswerRow> rows;
    if (before_s) {
        rows.push_back({.key = "yours",
                        .name = FoundTable::tr("Your cycle"),
                        .time_s = before_s,
                        .margin = beforeMargin});
    }
    const FoundCycle& best = *outcome.best();
    if (outcome.robust && outcome.robust->nominalTime_s > 0) {
        const double nominal_s = outcome.robust->nominalTime_s;
        rows.push_back(
            {.key = "nominal",
             .name = FoundTable::tr("Nominal part"),
             .time_s = nominal_s,
             .basis = {.full = {FoundTable::tr("robustness costs %1 % of time")
                                    .arg(OptimiseText::percent(best.time_s / nominal_s - 1))}}});
    }
    Basis basis{{proofOf(outcome)}, {briefProof(outcome)}};
    if (!outcome.robust) {
        basis.add(nominalBasis(), nominalBasis());
    }
    if (outcome.wear) {
        addWearBasis(best, basis);
    }
    rows.push_back(foundRow(
        outcome, best, {.key = "best", .name = answerName(outcome), .basis = std::move(basis)}));
    const QString between = FoundTable::tr("Between levels");
    if (const FoundCycle* const refined = outcome.refined()) {
        rows.push_back(foundRow(outcome, *refined,
                                {.key = "refined",
                                 .name = between,
                                 .basis = {{FoundTable::tr("not proved to be the quickest")},
                                           {FoundTable::tr("not proved")}}}));
    } else if (outcome.refinement) {
        rows.push_back({.key = "refined",
                        .name = between,
                        .basis = {.full = {FoundTable::tr("nothing quicker was found")}}});
    }
    if (std::optional<AnswerRow> bound = boundRow(outcome)) {
        rows.push_back(std::move(*bound));
    }
    if (isKnownLimit(outcome.limit.time_s)) {
        rows.push_back({.key = "limit",
                        .name = FoundTable::tr("Limit"),
                        .time_s = outcome.limit.time_s,
                        .basis = {limitBasis(outcome), {FoundTable::tr("a stepless cycle")}}});
    }
    return rows;
}

/// An upper bound of a share in per cent, rounded up.
ValueCell mostCell(const std::optional<double>& share) {
    return ValueCell::of(share ? std::optional(std::ceil(*share * 1e4) / 1e2) : std::nullopt,
                         [](double percent) { return Names::fixed(percent, 2); });
}

ValueCell basisCell(const Basis& basis) {
    const QString separator = QStringLiteral("; "), full = basis.full.join(separator);
    return {.text = basis.brief.isEmpty() ? full : basis.brief.join(separator),
            .said = full,
            .value = full};
}

} // namespace

ValueTable foundTable(const SearchOutcome& outcome, std::optional<double> before_s) {
    const TimeUnit unit = timeUnit(outcome, before_s);
    ValueTable table{.columns = headsOf(outcome, unit), .isList = true};
    for (const FoundCycle& found : outcome.found) {
        const QString text = OptimiseText::found(found, outcome.project);
        table.addRow({.text = QString::number(table.rows.size() + 1),
                      .tip = kindOf(outcome, found) + u'\n' + text,
                      .isStrong = found.isBestOfItsNumber},
                     cellsOf(outcome, found, before_s, unit));
    }
    return table;
}

ValueTable answerTable(const SearchOutcome& outcome, std::optional<double> before_s,
                       std::optional<double> beforeMargin) {
    if (!outcome.best()) {
        return {};
    }
    const bool hasStocks = outcome.mostStocksFailing().has_value(),
               hasParts = outcome.mostPartsBad().has_value();
    const TimeUnit unit = timeUnit(outcome, before_s);
    ValueTable table{.columns = {{.text = FoundTable::tr("Cycle"), .key = "name", .isText = true},
                                 timeHead(unit),
                                 changeHead(),
                                 marginHead()},
                     .isList = true};
    if (outcome.wear) {
        addWearHeads(table.columns);
    }
    if (hasStocks) {
        table.columns.push_back(
            {.text = FoundTable::tr("Unfit for\nstocks, ≤ %"),
             .name = FoundTable::tr("Unfit for stocks, at most, %"),
             .tip =
                 FoundTable::tr("Share of the stocks within one infeed for which the cycle may be "
                                "unfit, with 95 % confidence: it was fit for all those tried"),
             .key = "stocks"});
    }
    if (hasParts) {
        table.columns.push_back(
            {.text = FoundTable::tr("Rejected\nparts, ≤ %"),
             .name = FoundTable::tr("Rejected parts, at most, %"),
             .tip = FoundTable::tr("Share of the batch that may be rejected, with 95 % confidence: "
                                   "all parts tried were good"),
             .key = "batch"});
    }
    table.columns.push_back({.text = FoundTable::tr("Basis"),
                             .tip = FoundTable::tr("The tool tip of a cell has the whole text"),
                             .key = "basis",
                             .isText = true,
                             .isPlain = true});
    for (const AnswerRow& row : answerRows(outcome, before_s, beforeMargin)) {
        std::vector<ValueCell> cells{{.text = row.name},
                                     timeCell(row.time_s, unit),
                                     changeCell(row.time_s, before_s),
                                     shareCell(row.margin)};
        if (outcome.wear) {
            addWearCells(row.held, row.cost, cells);
        }
        if (hasStocks) {
            cells.push_back(mostCell(row.stocksFailing));
        }
        if (hasParts) {
            cells.push_back(mostCell(row.partsBad));
        }
        cells.push_back(basisCell(row.basis));
        table.addRow({.text = row.name, .key = row.key, .isStrong = row.isAnswer},
                     std::move(cells));
    }
    return table;
}

} // namespace sparkout
