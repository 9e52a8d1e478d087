// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/views/optimise/optimise_text.h"

#include "core/optimisation/limit.h"
#include "core/optimisation/robust.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/units.h"
#include "ui/text/joined.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

QString OptimiseText::minutes(double time_s) {
    return Names::significant(time_s / units::secondsPerMinute, 4);
}

QString OptimiseText::percent(double share) {
    return Names::fixed(100 * share, 1);
}

QString OptimiseText::gridSize(std::int64_t size) {
    return size == std::numeric_limits<std::int64_t>::max()
               ? tr("more than 9·10¹⁸ cycles")
               : tr("%1 cycles").arg(QLocale().toString(qlonglong(size)));
}

QString OptimiseText::cycle(const Cycle& cycle) {
    QStringList stages;
    for (const Stage& stage : cycle.stages) {
        QStringList numbers;
        for (const std::optional<double>& feed :
             {stage.radial_feed_mm, stage.axial_feed_mm_min, stage.radial_feed_mm_min}) {
            if (feed) {
                numbers << printedNumber(*feed);
            }
        }
        if (const auto steps = stage.sparkOutSteps()) {
            numbers << tr("spark-out %1").arg(QLocale().toString(*steps));
        }
        numbers << printedNumber(stage.stock_mm);
        stages << numbers.join(QStringLiteral(" · "));
    }
    return stages.join(QStringLiteral(" → "));
}

QString OptimiseText::found(const FoundCycle& found, const Project& searched) {
    QStringList parts{cycle(found.cycle)};
    const MachineSettings own = machineSettings(searched);
    if (found.machine.work_speed_rpm != own.work_speed_rpm) {
        parts << tr("%1 rev/min").arg(printedNumber(found.machine.work_speed_rpm));
    }
    if (found.machine.dwell_entry_s != own.dwell_entry_s
        || found.machine.dwell_exit_s != own.dwell_exit_s) {
        parts << tr("dwells %1 and %2 s")
                     .arg(printedNumber(found.machine.dwell_entry_s),
                          printedNumber(found.machine.dwell_exit_s));
    }
    return parts.join(QStringLiteral("; "));
}

QString OptimiseText::cycleHint(Operation operation) {
    return operation->axial()
               ? tr("Of every stage: radial feed, mm per double stroke; axial feed, mm/min; stock "
                    "per side, mm")
               : tr("Of every stage: radial feed, mm/min; stock per side, mm");
}

QString OptimiseText::names(const std::vector<ConstraintKind>& kinds) {
    QStringList names;
    for (const ConstraintKind kind : kinds) {
        names << Names::inSentence(Names::constraint(kind));
    }
    return names.join(QStringLiteral(", "));
}

QString OptimiseText::state(const SearchState& state) {
    if (state.stages == 0 && state.looksFor == FoundBy::search) {
        return tr("Begins");
    }
    QStringList parts{state.looksFor == FoundBy::margin ? tr("Farther from the limits")
                      : state.looksFor == FoundBy::refinement
                          ? tr("Between the levels")
                          : tr("%n stage(s)", nullptr, state.stages)};
    if (state.round > 1 && state.looksFor == FoundBy::search) {
        parts << tr("rounds of levels: %1").arg(state.round);
    }
    if (state.best_s) {
        parts << tr("best %1 min").arg(minutes(*state.best_s));
    }
    if (state.bound_s > 0) {
        parts << tr("none below %1 min").arg(minutes(state.bound_s));
    }
    if (state.evaluations > 0) {
        parts << tr("%1 judged").arg(QLocale().toString(qlonglong(state.evaluations)));
    }
    parts << tr("%1 s").arg(QLocale().toString(state.took_s, 'f', 0));
    return parts.join(QStringLiteral(", "));
}

QString OptimiseText::fault(const SearchOutcome& outcome) {
    if (!outcome.issues.empty()) {
        return Names::refusal(outcome.issues, 2);
    }
    if (outcome.objectiveFault != ObjectiveFault::none) {
        return objectiveFault(outcome.objectiveFault);
    }
    switch (outcome.fault) {
    case GridFault::none: break;
    case GridFault::notGiven: return tr("What is to be searched is not given.");
    case GridFault::noLevels:
        return outcome.project.operation->axial()
                   ? tr("Both feeds need levels: page Search of the inputs.")
                   : tr("The plunge feed needs levels: page Search of the inputs.");
    case GridFault::tooManyLevels:
        return tr("A stage would have more than %1 settings of its feeds: take fewer levels.")
            .arg(QLocale().toString(mostSettings, 'f', 0));
    case GridFault::tooManySteps:
        return tr("The stock would have more than %1 steps: take a larger step.")
            .arg(QLocale().toString(mostStockSteps, 'f', 0));
    case GridFault::tooManyVariants:
        return tr("Work speed, dwells and spark-outs make more than %1 combinations: take fewer "
                  "levels.")
            .arg(QLocale().toString(mostVariants, 'f', 0));
    case GridFault::noDivision:
        return tr("The stock cannot be divided into these numbers of stages: take a smaller step, "
                  "or other limits of the stages' feeds and stocks.");
    }
    return tr("The batch that the cycle is to hold for cannot be run:") + u'\n'
           + Names::refusal(outcome.batchIssues, 2);
}

QString OptimiseText::objectiveFault(ObjectiveFault fault) {
    switch (fault) {
    case ObjectiveFault::none: break;
    case ObjectiveFault::noRates:
        return tr("The minimum cost needs the cost of a part: page Search of the inputs.");
    case ObjectiveFault::otherAim:
        return tr("The maximum margin within a time is searched with the objective “minimum time” "
                  "alone.");
    case ObjectiveFault::otherParts:
        return tr("Cost and wheel life are searched for the part as it stands, without the phases "
                  "of the stock and the batch.");
    }
    return {};
}

QString OptimiseText::parts(const PartsHeld& held) {
    const QString count = QLocale().toString(qlonglong(held.parts));
    return held.isEndless ? tr("any number") : held.isAll ? tr("at least %1").arg(count) : count;
}

QString OptimiseText::cost(double cost) {
    return Names::significant(cost, 5);
}

QString OptimiseText::offer(SearchObjective objective) {
    return objective == SearchObjective::cost
               ? tr(
                   "“Search” finds the cycle of the grid with the minimum cost of a part, together "
                   "with the parts between dressings: it holds for all of them.")
               : tr("“Search” finds the cycle of the grid that holds for the most parts from one "
                    "dressing to the next, the quickest of these.");
}

QString OptimiseText::cutsOf(const SearchOutcome& outcome) {
    std::vector<std::pair<long long, ConstraintKind>> cuts;
    const auto counts = outcome.cuts();
    for (const Requirement& row : requirementRows) {
        if (const long long count = counts[static_cast<std::size_t>(row.kind)]; count > 0) {
            cuts.emplace_back(count, row.kind);
        }
    }
    std::ranges::stable_sort(cuts, std::greater(), [](const auto& cut) { return cut.first; });
    constexpr std::size_t most = 4;
    cuts.resize(std::min(cuts.size(), most));
    QStringList names;
    for (const auto& [count, kind] : cuts) {
        names << tr("%1 (%2 times)")
                     .arg(Names::inSentence(Names::constraint(kind)),
                          QLocale().toString(qlonglong(count)));
    }
    return names.isEmpty() ? QString()
                           : tr("What cut most: %1.").arg(names.join(QStringLiteral(", ")));
}

QString OptimiseText::within(const SearchOutcome& outcome) {
    return printedNumber(outcome.project.optimisation->margin_within_min.value_or(0));
}

QString OptimiseText::noAnswer(const SearchOutcome& outcome) {
    if (outcome.stopped) {
        return tr("Stopped before a cycle was found that holds every requirement.");
    }
    if (outcome.marginWithin_us) {
        return tr("No cycle of the grid that takes at most %1 min holds every requirement.")
            .arg(within(outcome));
    }
    return outcome.unresolved()
               ? tr("No cycle was found that holds in every scenario, and none is quicker "
                    "than %1 min; each one tried failed in a further scenario.")
                     .arg(minutes(outcome.bound_s))
               : tr("No cycle of the grid holds every requirement.");
}

QString OptimiseText::marginAnswer(const SearchOutcome& outcome, const FoundCycle& best) {
    const QString margin = percent(best.leastRelativeMargin), taken = minutes(best.time_s);
    if (!outcome.proved()) {
        return tr("A margin of %1 % is the largest so far, in %2 min; a cycle within %3 min may "
                  "have a larger one.")
            .arg(margin, taken, within(outcome));
    }
    const QString size = gridSize(sparkout::gridSize(outcome.searched));
    return outcome.robust
               ? tr("A margin of %1 % over all that it must hold for, in %2 min: of %3 the largest "
                    "within %4 min, proved.")
                     .arg(margin, taken, size, within(outcome))
               : tr("A margin of %1 %, in %2 min: of %3 the largest within %4 min, proved.")
                     .arg(margin, taken, size, within(outcome));
}

QString OptimiseText::intervalAnswer(const SearchOutcome& outcome, const FoundCycle& best) {
    const bool isCost = outcome.objective() == SearchObjective::cost;
    const QString size = gridSize(sparkout::gridSize(outcome.searched)),
                  taken = minutes(best.time_s);
    if (!best.held) {
        return tr("%1 min: the quickest of %2. How the wheel wears is not given, so it is the "
                  "cheapest too, and the wheel's life is not searched.")
            .arg(taken, size);
    }
    QStringList lines;
    if (isCost) {
        lines << (outcome.proved() ? tr("%1 a part, in %2 min: of %3 the minimum cost, proved.")
                                         .arg(cost(best.cost.value_or(0)), taken, size)
                                   : tr("%1 a part, in %2 min, is the minimum cost so far.")
                                         .arg(cost(best.cost.value_or(0)), taken));
    } else {
        lines << (outcome.proved()
                      ? tr("%1 min: of %2 none holds for more parts between dressings, proved.")
                            .arg(taken, size)
                      : tr("%1 min: the most parts between dressings so far.").arg(taken));
    }
    lines << tr("Parts per dressing: %1; %2 min each on average.")
                 .arg(parts(*best.held), minutes(best.held->meanTime_s));
    if (best.held->end) {
        lines << tr("The next part breaks: %1.")
                     .arg(Names::inSentence(Names::constraint(*best.held->end)));
    }
    if (!isCost && best.cost) {
        lines << tr("A part costs %1.").arg(cost(*best.cost));
    }
    return lines.join(u' ');
}

QString OptimiseText::front(const SearchOutcome& outcome) {
    if (outcome.wear) {
        return tr("Margins by time are searched for the minimum time, or for the maximum margin; "
                  "this search is of parts between dressings.");
    }
    if (outcome.isFrontComing) {
        return tr("The search for margins by time continues.");
    }
    const std::vector<const FoundCycle*> points = outcome.front();
    if (points.empty() && outcome.robust && outcome.best() && !outcome.best()->decided) {
        return tr("Margins by time over all phases of the stock are searched under gauge control "
                  "alone.");
    }
    if (points.empty()) {
        return tr("No margins by time: the search was stopped before, or no cycle holds.");
    }
    const QString all =
        outcome.isFrontWhole
            ? tr("All %n cycle(s) of the grid of which none is both quicker and farther from "
                 "its limits.",
                 nullptr, static_cast<int>(points.size()))
            : tr("Up to %1 min; cycles that take longer may have larger margins.")
                  .arg(minutes(points.back()->time_s));
    return outcome.robust
               ? all + u' ' + tr("The margin is the least over all that the search must hold for.")
               : all;
}

QString OptimiseText::answer(const SearchOutcome& outcome, std::optional<double> before_s) {
    QStringList lines;
    const FoundCycle* best = outcome.best();
    if (!best) {
        lines << noAnswer(outcome) << cutsOf(outcome);
        return joined(lines, QStringLiteral(" "));
    }
    if (outcome.wear) {
        lines << intervalAnswer(outcome, *best);
    } else if (outcome.marginWithin_us) {
        lines << marginAnswer(outcome, *best);
    } else {
        lines
            << (outcome.proved()
                    ? (outcome.robust
                           ? tr("%1 min: of %2 the quickest that holds for the part and the "
                                "scenarios added; proved for these.")
                           : tr("%1 min: the quickest of %2, proved."))
                          .arg(minutes(best->time_s),
                               gridSize(sparkout::gridSize(outcome.searched)))
                    : tr("%1 min is the best so far; no cycle of the grid is quicker than %2 min.")
                          .arg(minutes(best->time_s), minutes(outcome.bound_s)));
    }
    if (const FoundCycle* refined = outcome.refined()) {
        lines
            << tr("Between the levels a cycle of %1 min holds; that none is quicker is not proved.")
                   .arg(minutes(refined->time_s));
    } else if (outcome.refines) {
        lines << tr("Between the levels nothing quicker was found.");
    }
    const double least_s = outcome.refined() ? outcome.refined()->time_s : best->time_s;
    if (before_s && *before_s > 0) {
        constexpr double noticed = 5e-4;
        const double change = least_s / *before_s - 1;
        lines << (change < -noticed
                      ? tr("That is %1 % less than your cycle takes.").arg(percent(-change))
                      : tr("Your cycle takes %1 min.").arg(minutes(*before_s)));
    }
    if (const auto gap = gapToLimit(least_s, outcome.limit_s)) {
        lines << tr("The stepless limit is %1 min, %2 % below it.")
                     .arg(minutes(outcome.limit_s), percent(*gap))
              << limitCycles(outcome);
    }
    lines << bindingOf(outcome);
    if (const QString levels = levelsOf(outcome); !levels.isEmpty()) {
        lines << levels;
    }
    if (outcome.robust) {
        lines << robustness(outcome, *best);
    }
    return joined(lines, QStringLiteral(" "));
}

QString OptimiseText::limitCycles(const SearchOutcome& outcome) {
    const LimitedCycles& cycles = outcome.limitCycles;
    QStringList lines;
    if (outcome.searched.operation->travels) {
        lines
            << (cycles.continuousFeed_mm_min > 0
                    ? tr("The limit holds for cycles with a continuous infeed of up to %1 mm/min.")
                          .arg(printedNumber(cycles.continuousFeed_mm_min))
                    : tr("The limit holds for cycles without a continuous infeed."));
    }
    if (outcome.searched.operation->mayRetract) {
        lines << (cycles.drawBack
                      ? tr("The limit also holds for cycles that draw the wheel head back.")
                      : tr("The limit holds for cycles that never draw the wheel head back."));
    }
    return lines.join(u' ');
}

QString OptimiseText::robustness(const SearchOutcome& outcome, const FoundCycle& best) {
    QStringList lines;
    if (!outcome.marginWithin_us) {
        int added = 0;
        for (const SearchedNumber& number : outcome.numbers) {
            added += number.scenariosAdded;
        }
        lines << tr("It holds in the last sample of scenarios; %n of them had to be added.",
                    nullptr, added);
    }
    const FoundCycle& answer = outcome.refined() ? *outcome.refined() : best;
    lines << (answer.decided ? decided(*answer.decided) : sampled(answer.candidate));
    if (const double nominal_s = outcome.nominal_s(); nominal_s > 0) {
        lines
            << tr("The nominal part alone, of the same levels, would take %1 min: robustness costs "
                  "%2 % of time.")
                   .arg(minutes(nominal_s), percent(best.time_s / nominal_s - 1));
    }
    return lines.join(u' ');
}

QString OptimiseText::decided(const PhaseCases& cases) {
    const QString from = Names::significant(cases.stocks.from_mm, 5),
                  to = Names::significant(cases.stocks.to_mm, 5);
    return cases.corners > 0
               ? tr("It holds for every stock of %1…%2 mm per side, with the other inputs as they "
                    "are and at each of the %3 corners of the batch's other factors: decided, not "
                    "sampled.")
                     .arg(from, to, QLocale().toString(cases.corners))
               : tr("It holds for every stock of %1…%2 mm per side, with the other inputs as they "
                    "are: decided, not sampled.")
                     .arg(from, to);
}

QString OptimiseText::sampled(int candidate) {
    const int tried = std::max(candidate, 1);
    const double most = mostFailing(freshPhaseCount, tried);
    return tr("It held in all of %1 phases of the stock drawn afresh, as cycle no. %2 that "
              "was tried so: with 95 % confidence at most %3 % of the phases fail.")
        .arg(QLocale().toString(freshPhaseCount), QLocale().toString(tried),
             Names::fixed(std::ceil(most * 1e4) / 1e2, 2));
}

QString OptimiseText::bindingOf(const SearchOutcome& outcome) {
    if (!outcome.binding) {
        return outcome.marginWithin_us
                   ? tr("What has the minimum margin is not known: the search was stopped before.")
                   : tr("What keeps it from being quicker is not known: the search was stopped "
                        "before.");
    }
    if (outcome.marginWithin_us) {
        return tr("The minimum margin is that of: %1.").arg(names(*outcome.binding));
    }
    if (!outcome.binding->empty()) {
        return tr("What keeps it from being quicker: %1.").arg(names(*outcome.binding));
    }
    return outcome.proved() && !outcome.refined()
               ? tr("No cycle of the grid that differs in one setting is quicker.")
               : QString();
}

QString OptimiseText::levelsOf(const SearchOutcome& outcome) {
    QStringList lines;
    if (outcome.rounds > 1) {
        lines << tr("Levels were added around the answer; rounds: %1.").arg(outcome.rounds);
    }
    if (outcome.areLevelsCutShort) {
        lines << tr("Stopped while further levels were searched: the answer is that of the grid "
                    "before.");
    }
    for (const LevelEdge& edge : outcome.edges) {
        const Field& field = *tableOf<Stage>().find(edge.feed->key);
        const auto value = [&field](double number) {
            return printedNumber(number) + u'\u00a0' + unitText(field.unit);
        };
        const QString where = (edge.isMost ? tr("Stage %1: “%2” has the maximum level, %3;")
                                           : tr("Stage %1: “%2” has the minimum level, %3;"))
                                  .arg(QLocale().toString(qulonglong(edge.stage + 1)),
                                       inputText(field.label), value(edge.level))
                              + u' ';
        lines << where
                     + (edge.isLimit ? tr("the machine or the stage's limits allow no other.")
                        : edge.limit ? tr("allowed is %1.").arg(value(*edge.limit))
                                     : tr("smaller ones are allowed."));
    }
    return lines.join(u' ');
}

} // namespace sparkout
