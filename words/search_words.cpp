// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/search_words.h"

#include "core/digits.h"
#include "core/printable.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/validate.h"
#include "core/quality/shop_numbers.h"
#include "core/search/grid.h"
#include "core/search/optimise.h"
#include "core/text.h"
#include "core/units.h"
#include "words/issue_words.h"
#include "words/judgement_words.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace sparkout {

// --- notation ------------------------------------------------------------------------------------

std::string SearchWording::translated(const char* text) const {
    return text;
}

std::string SearchWording::number(double value) const {
    return plainNumber(value);
}

std::string SearchWording::whole(std::int64_t count) const {
    return std::to_string(count);
}

std::string SearchWording::fixed(double value, int decimals) const {
    return sparkout::fixed(value, decimals);
}

std::string SearchWording::significant(double value, int digits) const {
    return fixed(value, decimalsOf(value, digits));
}

std::string SearchWording::unit(const char* unit) const {
    return unit;
}

std::string SearchWording::feed(const StageFeed& feed) const {
    return feed.key;
}

std::string SearchWording::setting(const char* key) const {
    return key;
}

std::string SearchWording::remark(const Issue& issue) const {
    return issue.path + ": " + issueSentence(issue);
}

std::string SearchWording::requirement(ConstraintKind kind) const {
    return requirementOf(kind).key;
}

std::string SearchWording::exceptions(const std::vector<Undecided>& undecided) const {
    return JudgementWording().exceptions(undecided);
}

std::string SearchWording::method(SearchMethod method) const {
    return std::string("--method ") + searchMethodName(method);
}

std::string SearchWording::filled(const char* text,
                                  std::initializer_list<std::string> values) const {
    const std::string sentence = translated(text);
    std::string out;
    for (std::size_t i = 0; i < sentence.size(); ++i) {
        const std::size_t place = sentence[i] == '%' && i + 1 < sentence.size()
                                      ? std::size_t(sentence[i + 1] - '1')
                                      : values.size();
        if (place < values.size()) {
            out += values.begin()[place];
            ++i;
        } else {
            out += sentence[i];
        }
    }
    return out;
}

/// Seconds below two minutes.
std::string SearchWording::time(double time_s) const {
    constexpr int digits = 4;
    return time_s < shortTime_s
               ? filled(SPARKOUT_NOOP("Search", "%1 s"), {significant(time_s, digits)})
               : filled(SPARKOUT_NOOP("Search", "%1 min"),
                        {significant(time_s / units::secondsPerMinute, digits)});
}

std::string SearchWording::percent(double share) const {
    return fixed(100 * share, 1);
}

std::string SearchWording::cost(double cost) const {
    return significant(cost, 5);
}

std::string SearchWording::gridSize(std::int64_t size) const {
    return size == std::numeric_limits<std::int64_t>::max()
               ? translated(SPARKOUT_NOOP("Search", "more than 9·10¹⁸ cycles"))
               : filled(SPARKOUT_NOOP("Search", "%1 cycles"), {whole(size)});
}

std::string SearchWording::parts(const PartsHeld& held) const {
    return held.isEndless ? translated(SPARKOUT_NOOP("Search", "any number"))
           : held.isAll   ? filled(SPARKOUT_NOOP("Search", "at least %1"), {whole(held.parts)})
                          : whole(held.parts);
}

std::string SearchWording::names(const std::vector<ConstraintKind>& kinds) const {
    std::string list;
    for (const ConstraintKind kind : kinds) {
        list += (list.empty() ? "" : ", ") + requirement(kind);
    }
    return list;
}

std::string SearchWording::within(const SearchOutcome& outcome) const {
    return number(outcome.project.optimisation->margin_within_min.value_or(0));
}

std::string SearchWording::state(const SearchState& state) const {
    std::vector<std::string> said;
    if (state.looksFor != FoundBy::search) {
        said.push_back(translated(state.looksFor == FoundBy::margin
                                      ? SPARKOUT_NOOP("Search", "Farther from the limits")
                                      : SPARKOUT_NOOP("Search", "Between the levels")));
    } else if (state.stages > 0) {
        said.push_back(filled(SPARKOUT_NOOP("Search", "Stages: %1"), {whole(state.stages)}));
    }
    if (state.round > 1 && state.looksFor == FoundBy::search) {
        said.push_back(
            filled(SPARKOUT_NOOP("Search", "rounds of levels: %1"), {whole(state.round)}));
    }
    if (state.best_s) {
        said.push_back(filled(SPARKOUT_NOOP("Search", "best %1"), {time(*state.best_s)}));
    }
    if (state.bound_s > 0) {
        said.push_back(filled(SPARKOUT_NOOP("Search", "none below %1"), {time(state.bound_s)}));
    }
    if (state.share > 0) {
        said.push_back(filled(SPARKOUT_NOOP("Search", "%1 % searched"), {percent(state.share)}));
    }
    if (state.evaluations > 0) {
        said.push_back(filled(SPARKOUT_NOOP("Search", "%1 judged"), {whole(state.evaluations)}));
    }
    if (said.empty()) {
        said.push_back(translated(SPARKOUT_NOOP("Search", "Begins")));
    }
    if (state.took_s > 0) {
        said.push_back(filled(SPARKOUT_NOOP("Search", "%1 s"), {fixed(state.took_s, 0)}));
    }
    std::string line;
    for (const std::string& each : said) {
        line += (line.empty() ? "" : ", ") + each;
    }
    return line;
}

// --- refusals ------------------------------------------------------------------------------------

namespace {

/// The path of the input of fault().
std::string faultPath(const SearchOutcome& outcome) {
    if (outcome.isOtherOperation) {
        return "/operation";
    }
    if (outcome.isOtherAim) {
        return outcome.marginWithin_us ? "/optimisation/margin_within_min"
                                       : "/optimisation/objective";
    }
    switch (outcome.objectiveFault) {
    case ObjectiveFault::none: break;
    case ObjectiveFault::noRates: return "/optimisation/cost";
    case ObjectiveFault::otherAim: return "/optimisation/margin_within_min";
    case ObjectiveFault::otherParts: return "/optimisation/objective";
    }
    std::string feeds;
    if (outcome.fault == GridFault::noLevels) {
        for (const StageFeed& feed : outcome.project.operation->feeds) {
            feeds +=
                (feeds.empty() ? "/optimisation/" : ", /optimisation/") + std::string(feed.key);
        }
    }
    return !feeds.empty()                             ? feeds
           : outcome.fault == GridFault::tooManySteps ? "/optimisation/stock_step_mm"
           : outcome.fault == GridFault::wholeRatio   ? "/optimisation/least_ratio_distance"
                                                      : "/optimisation";
}

} // namespace

std::string searchRefusal(const SearchOutcome& outcome) {
    const SearchWording words;
    const std::string sentence = words.fault(outcome);
    const std::string method =
        outcome.isOtherOperation || (outcome.isOtherAim && isHeuristic(outcome.method))
            ? words.method(outcome.method) + ": "
            : std::string();
    return sentence.empty() ? sentence : faultPath(outcome) + ": " + method + sentence;
}

std::string searchStateRefusal(const ReadSearchState& read, const SearchQuestion& asked) {
    switch (read.fault) {
    case SearchStateFault::none: break;
    case SearchStateFault::otherFormat:
        return "is not the progress of a search, and stays as it is";
    case SearchStateFault::otherVersion:
        return "is the progress of a search by another version of this program";
    case SearchStateFault::changed:
        return "is damaged: its checksum is not that of its contents; delete it to start again";
    case SearchStateFault::badValue:
        return "is damaged: " + printable(read.value.path) + ": " + printable(read.value.found)
               + "; allowed: " + read.value.least + "…" + read.value.most
               + "; delete it to start again";
    case SearchStateFault::otherEngine:
        return "is the progress of a search by another build of this program, "
               + printable(read.question.engine) + "; this one is " + asked.engine;
    case SearchStateFault::otherProject: return "is the progress of a search of another project";
    case SearchStateFault::otherOptions:
        return "is the progress of a search with other options, " + printable(read.question.options)
               + "; these are " + asked.options;
    }
    return {};
}

std::string SearchWording::fault(const SearchOutcome& outcome) const {
    if (outcome.isOtherOperation) {
        return filled(SPARKOUT_NOOP("Search", "This method is for plunge grinding; the exact "
                                              "search handles traverse cycles (%1)."),
                      {method(SearchMethod::pruned)});
    }
    if (outcome.isOtherAim) {
        return translated(
            isHeuristic(outcome.method)
                ? SPARKOUT_NOOP("Search", "This method searches only for the minimum time.")
                : SPARKOUT_NOOP(
                    "Search",
                    "The refinement between the levels looks only for the minimum time."));
    }
    switch (outcome.objectiveFault) {
    case ObjectiveFault::none: break;
    case ObjectiveFault::noRates:
        return translated(SPARKOUT_NOOP("Search", "The minimum cost needs the cost of a part."));
    case ObjectiveFault::otherAim:
        return translated(SPARKOUT_NOOP("Search", "The maximum margin within a time is searched "
                                                  "only with the objective “minimum time”."));
    case ObjectiveFault::otherParts:
        return translated(
            SPARKOUT_NOOP("Search", "Cost and wheel life are searched only for the given part, not "
                                    "for other stocks within one infeed or for the batch."));
    }
    switch (outcome.fault) {
    case GridFault::none: break;
    case GridFault::notGiven:
        return translated(SPARKOUT_NOOP("Search", "The inputs of the search are missing."));
    case GridFault::noLevels:
        return translated(outcome.project.operation->axial()
                              ? SPARKOUT_NOOP("Search", "Both feeds need levels.")
                              : SPARKOUT_NOOP("Search", "The plunge feed needs levels."));
    case GridFault::tooManyLevels:
        return filled(
            SPARKOUT_NOOP(
                "Search",
                "A stage would have more than %1 settings of its feeds: use fewer levels."),
            {whole(std::llround(mostSettings))});
    case GridFault::tooManySteps:
        return filled(
            SPARKOUT_NOOP("Search", "The stock would have more than %1 steps: use a larger step."),
            {whole(std::llround(mostStockSteps))});
    case GridFault::tooManyVariants:
        return filled(SPARKOUT_NOOP("Search", "Work speed, dwells and spark-outs make more than %1 "
                                              "combinations: use fewer levels."),
                      {whole(std::llround(mostVariants))});
    case GridFault::noDivision:
        return translated(SPARKOUT_NOOP(
            "Search", "The stock cannot be divided into these numbers of stages: use a smaller "
                      "step, or other limits of the stages' feeds and stocks."));
    case GridFault::wholeRatio: return wholeRatio(outcome.project);
    }
    return {};
}

/// No work speed is allowed: with a single one, the ratio is stated.
std::string SearchWording::wholeRatio(const Project& project) const {
    const std::string asked = setting("least_ratio_distance"), levels = setting("work_speed_rpm");
    const std::string least = number(project.optimisation->least_ratio_distance.value_or(0));
    const std::vector<double> speeds = searchedSpeeds(project).leftOut;
    return speeds.size() == 1
               ? filled(
                   SPARKOUT_NOOP("Search", "The rotation ratio is %1, nearer to a whole number "
                                           "than “%2” allows (%3): change it, or search “%4”."),
                   {significant(wheelSpeed_rpm(project) / speeds.front(), 4), asked, least, levels})
               : filled(SPARKOUT_NOOP("Search", "With every work speed of the search the rotation "
                                                "ratio is nearer to a whole number than “%1” "
                                                "allows (%2): change it, or “%3”."),
                        {asked, least, levels});
}

// --- results -------------------------------------------------------------------------------------

std::string SearchWording::noAnswer(const SearchOutcome& outcome) const {
    const auto why = [&] {
        if (outcome.stopped()) {
            return translated(SPARKOUT_NOOP(
                "Search", "Stopped before a cycle that meets every requirement was found."));
        }
        if (outcome.unresolved()) {
            return filled(
                SPARKOUT_NOOP("Search",
                              "No cycle was found that is fit in every scenario, and none is "
                              "quicker than %1; each cycle tried was unfit in a further scenario."),
                {time(outcome.search.bound_s)});
        }
        if (outcome.search.status == SearchStatus::notFound) {
            return filled(SPARKOUT_NOOP("Search",
                                        "The heuristic found no cycle that meets every "
                                        "requirement; there may be one, which the exact search "
                                        "finds (%1)."),
                          {method(SearchMethod::pruned)});
        }
        return outcome.marginWithin_us
                   ? filled(SPARKOUT_NOOP("Search", "No cycle of the grid that takes at most %1 "
                                                    "min meets every requirement."),
                            {within(outcome)})
                   : translated(
                       SPARKOUT_NOOP("Search", "No cycle of the grid meets every requirement."));
    };
    constexpr std::size_t most = 4;
    std::string cut;
    const auto cuts = outcome.cuts();
    for (std::size_t i = 0; i < std::min(most, cuts.size()); ++i) {
        cut += (i > 0 ? ", " : "")
               + filled(SPARKOUT_NOOP("Search", "%1 (%2 times)"),
                        {requirement(cuts[i].first), whole(cuts[i].second)});
    }
    std::string text = why();
    if (!cut.empty()) {
        text += ' ' + filled(SPARKOUT_NOOP("Search", "Excluded most often by: %1."), {cut});
    }
    if (outcome.robust && outcome.robust->incapable > 0) {
        text += ' '
                + filled(SPARKOUT_NOOP("Search", "Of cycles whose parts are all good, the Ppk or "
                                                 "the expected share outside misses the batch's "
                                                 "limit: %1."),
                         {whole(outcome.robust->incapable)});
    }
    const std::string leftOut = speedsLeftOut(outcome.searched);
    return leftOut.empty() ? text : text + ' ' + leftOut;
}

std::string SearchWording::marginAnswer(const SearchOutcome& outcome) const {
    const FoundCycle& best = *outcome.best();
    const std::string margin = percent(best.leastRelativeMargin), taken = time(best.time_s);
    if (!outcome.proved()) {
        return filled("A margin of %1 % is the largest so far, in %2; a cycle within %3 min may "
                      "have a larger one.",
                      {margin, taken, within(outcome)});
    }
    return filled(outcome.robust
                      ? "A margin of %1 % over all required cases, in %2: of %3 the "
                        "largest within %4 min, proved."
                      : "A margin of %1 %, in %2: of %3 the largest within %4 min, proved.",
                  {margin, taken, gridSize(outcome.search.gridSize), within(outcome)});
}

std::string SearchWording::timeAnswer(const SearchOutcome& outcome) const {
    const std::string taken = time(outcome.best()->time_s);
    if (outcome.proved()) {
        return filled(
            outcome.isByPpk() ? "%1: the quickest of %2 that is fit for the part and the added "
                                "scenarios and has the required Ppk; proved for these."
            : outcome.robust  ? "%1: the quickest of %2 that is fit for the part and the added "
                                "scenarios; proved for these."
                              : "%1: the quickest of %2 for the nominal part only, proved.",
            {taken, gridSize(outcome.search.gridSize)});
    }
    if (isHeuristic(outcome.method)) {
        return filled(outcome.method == SearchMethod::published
                          ? "%1, found by dynamic programming as published, a heuristic: the "
                            "cycle is fit, but a quicker one may be fit too."
                          : "%1, found by labels of time and deflection, a heuristic: the "
                            "cycle is fit, but a quicker one may be fit too.",
                      {taken});
    }
    return filled("%1 is the best so far; no cycle of the grid is quicker than %2.",
                  {taken, time(outcome.search.bound_s)});
}

void SearchWording::addIntervalAnswer(const SearchOutcome& outcome,
                                      std::vector<std::string>& lines) const {
    const FoundCycle& best = *outcome.best();
    const bool isCost = outcome.objective() == SearchObjective::cost;
    const std::string size = gridSize(outcome.search.gridSize), taken = time(best.time_s);
    const std::string price = cost(best.cost.value_or(0));
    if (!best.held && !outcome.proved()) {
        lines.push_back(timeAnswer(outcome));
        return;
    }
    if (!best.held) {
        lines.push_back(
            filled("%1: the quickest of %2. The wear of the wheel is not given, so this "
                   "cycle is the cheapest too, and the life of the wheel is not searched.",
                   {taken, size}));
        return;
    }
    if (isCost) {
        lines.push_back(filled(outcome.proved()
                                   ? "%1 a part, in %2: of %3 the minimum cost, proved."
                                   : "%1 a part, in %2, is the minimum cost so far.",
                               {price, taken, size}));
    } else {
        lines.push_back(filled(
            outcome.proved() ? "%1: none of %2 is fit for more parts between dressings, proved."
                             : "%1: the most parts between dressings so far.",
            {taken, size}));
    }
    if (!outcome.proved() && outcome.interval->bound) {
        lines.push_back(isCost ? filled("No cycle of the grid has a lower cost of a part than %1.",
                                        {cost(*outcome.interval->bound)})
                               : filled("No cycle of the grid is fit for more than %1 parts.",
                                        {fixed(*outcome.interval->bound, 0)}));
    }
    lines.push_back(filled("Parts per dressing: %1; %2 each on average.",
                           {parts(*best.held), time(best.held->meanTime_s)}));
    if (best.held->end) {
        lines.push_back(filled("The next part does not meet: %1.", {requirement(*best.held->end)}));
    } else if (!best.held->isEndless && !best.held->isAll) {
        lines.push_back("The next part does not reach its size.");
    }
    if (!isCost && best.cost) {
        lines.push_back(filled("A part costs %1.", {price}));
    }
}

std::vector<std::string> SearchWording::answer(const SearchOutcome& outcome,
                                               std::optional<double> before_s) const {
    if (!outcome.best()) {
        return {noAnswer(outcome)};
    }
    std::vector<std::string> lines;
    if (outcome.wear) {
        addIntervalAnswer(outcome, lines);
    } else {
        lines.push_back(outcome.marginWithin_us ? marginAnswer(outcome) : timeAnswer(outcome));
    }
    if (const std::string open = exceptionsOf(outcome); !open.empty()) {
        lines.front() += ' ' + open;
    }
    addRefinement(outcome, lines);
    if (before_s && *before_s > 0) {
        constexpr double noticed = 5e-4;
        const double change = outcome.answer()->time_s / *before_s - 1;
        lines.push_back(change < -noticed ? filled("That is %1 % less than the time of your cycle.",
                                                   {percent(-change)})
                                          : filled("Your cycle takes %1.", {time(*before_s)}));
    }
    addLimit(outcome, lines);
    addBinding(outcome, lines);
    addLevels(outcome, lines);
    if (outcome.robust) {
        addRobustness(outcome, lines);
    }
    addRemarks(outcome, lines);
    return lines;
}

std::vector<std::string> SearchWording::notes(const SearchOutcome& outcome) const {
    if (!outcome.best()) {
        return {noAnswer(outcome)};
    }
    std::vector<std::string> lines;
    if (std::string open = exceptionsOf(outcome); !open.empty()) {
        lines.push_back(std::move(open));
    }
    addBinding(outcome, lines);
    addLevels(outcome, lines);
    addRemarks(outcome, lines);
    return lines;
}

std::string SearchWording::exceptionsOf(const SearchOutcome& outcome) const {
    const std::vector<Undecided>& open = outcome.remarks.notDecided;
    return open.empty() ? std::string() : exceptions(open) + '.';
}

void SearchWording::addRefinement(const SearchOutcome& outcome,
                                  std::vector<std::string>& lines) const {
    if (const FoundCycle* refined = outcome.refined()) {
        lines.push_back(
            filled("Between the levels a cycle of %1 is fit; it is not proved to be the quickest.",
                   {time(refined->time_s)}));
    } else if (outcome.refinement) {
        lines.push_back("Between the levels nothing quicker was found.");
    }
}

/// Adds the stepless limit, and the cycles to which it applies.
void SearchWording::addLimit(const SearchOutcome& outcome, std::vector<std::string>& lines) const {
    const auto gap = gapToLimit(outcome.answer()->time_s, outcome.limit.time_s);
    if (!gap) {
        return;
    }
    lines.push_back(filled("The stepless limit is %1, %2 % below it.",
                           {time(outcome.limit.time_s), percent(*gap)}));
    const LimitedCycles& cycles = outcome.limit.cycles;
    if (outcome.searched.operation->travels) {
        lines.push_back(
            cycles.continuousFeed_mm_min > 0
                ? filled(
                    "The limit is valid for cycles with a continuous infeed of up to %1 mm/min.",
                    {number(cycles.continuousFeed_mm_min)})
                : std::string("The limit is valid for cycles without a continuous infeed."));
    }
    if (!outcome.searched.operation->travels) {
        lines.push_back(cycles.drawBack
                            ? "The limit is also valid for cycles that retract the wheel head."
                            : "The limit is valid for cycles that never retract the wheel head.");
    }
    lines.push_back(
        cycles.sparkOut
            ? "The limit is valid for cycles that end at size or by a count of steps without feed."
            : "The limit is valid for cycles that end at size.");
}

void SearchWording::addBinding(const SearchOutcome& outcome,
                               std::vector<std::string>& lines) const {
    if (!outcome.binding) {
        lines.push_back(translated(
            outcome.marginWithin_us
                ? SPARKOUT_NOOP("Search", "The requirement with the minimum margin is not known: "
                                          "the search was stopped first.")
                : SPARKOUT_NOOP(
                    "Search",
                    "The limit of the time is not known: the search was stopped first.")));
    } else if (outcome.marginWithin_us) {
        lines.push_back(filled(SPARKOUT_NOOP("Search", "The minimum margin is that of: %1."),
                               {names(*outcome.binding)}));
    } else if (!outcome.binding->empty()) {
        lines.push_back(
            filled(SPARKOUT_NOOP("Search", "Limited by: %1."), {names(*outcome.binding)}));
    } else if (outcome.proved() && !outcome.refined()) {
        lines.push_back(translated(SPARKOUT_NOOP(
            "Search", "No cycle of the grid that differs in one setting is quicker.")));
    }
}

void SearchWording::addLevels(const SearchOutcome& outcome, std::vector<std::string>& lines) const {
    if (outcome.rounds > 1) {
        lines.push_back(
            filled(SPARKOUT_NOOP("Search", "Levels were added around the answer; rounds: %1."),
                   {whole(outcome.rounds)}));
    }
    if (outcome.areLevelsCutShort) {
        lines.push_back(
            translated(SPARKOUT_NOOP("Search", "Stopped while further levels were searched: the "
                                               "answer is that of the grid before.")));
    }
    for (const LevelEdge& edge : outcome.edges) {
        const char* const of = tableOf<Stage>().find(edge.feed->key)->unit;
        const auto value = [&](double level) { return number(level) + "\u00a0" + unit(of); };
        std::string line = filled(
            edge.isMost ? SPARKOUT_NOOP("Search", "Stage %1: “%2” has the maximum level, %3;")
                        : SPARKOUT_NOOP("Search", "Stage %1: “%2” has the minimum level, %3;"),
            {whole(std::int64_t(edge.stage) + 1), feed(*edge.feed), value(edge.level)});
        const std::string own = setting(("stage_" + std::string(edge.feed->key)).c_str());
        if (edge.isOfStage && edge.isLimit) {
            line += ' '
                    + filled(SPARKOUT_NOOP("Search", "the limits of the search, “%1”, end there;"),
                             {own});
        } else if (!edge.isLimit) {
            line += ' ' + translated(SPARKOUT_NOOP("Search", "no level of the search is beyond;"));
        }
        line += ' ';
        line += edge.isOfStage && !edge.isLimit
                    ? filled(SPARKOUT_NOOP("Search", "the limits of the search, “%1”, end at %2."),
                             {own, value(*edge.limit)})
                : edge.isLimit && !edge.isOfStage
                    ? translated(edge.machine
                                     ? SPARKOUT_NOOP("Search", "the machine's range ends there.")
                                     : SPARKOUT_NOOP("Search", "no other is allowed."))
                : edge.machine && edge.isMost
                    ? filled(SPARKOUT_NOOP("Search", "the machine allows up to %1."),
                             {value(*edge.machine)})
                : edge.machine ? filled(SPARKOUT_NOOP("Search", "the machine allows down to %1."),
                                        {value(*edge.machine)})
                : edge.isOfStage
                    ? translated(SPARKOUT_NOOP("Search", "the machine's range is not given."))
                : edge.limit ? filled(SPARKOUT_NOOP("Search", "allowed: %1."), {value(*edge.limit)})
                             : translated(SPARKOUT_NOOP("Search", "smaller values are allowed."));
        lines.push_back(std::move(line));
    }
    addSettingEdges(outcome, lines);
    if (std::string leftOut = speedsLeftOut(outcome.searched); !leftOut.empty()) {
        lines.push_back(std::move(leftOut));
    }
}

/// The work speeds whose rotation ratio is ruled out; empty if none is.
std::string SearchWording::speedsLeftOut(const Project& searched) const {
    if (!searched.optimisation) {
        return {};
    }
    std::string speeds;
    for (const double work_rpm : searchedSpeeds(searched).leftOut) {
        speeds += (speeds.empty() ? "" : "; ") + number(work_rpm);
    }
    if (!speeds.empty() && !searched.optimisation->least_ratio_distance) {
        return filled(SPARKOUT_NOOP("Search", "Work speeds left out because their rotation ratio "
                                              "is within %1 of a whole number, where the waves of "
                                              "the wheel, whose runout is not given, would print "
                                              "onto one another: %2."),
                      {number(nearRatio), speeds});
    }
    return speeds.empty()
               ? speeds
               : filled(SPARKOUT_NOOP("Search", "Work speeds left out because their rotation ratio "
                                                "is nearer to a whole number than “%1” allows: "
                                                "%2."),
                        {setting("least_ratio_distance"), speeds});
}

void SearchWording::addSettingEdges(const SearchOutcome& outcome,
                                    std::vector<std::string>& lines) const {
    for (const SettingEdge& edge : outcome.settingEdges) {
        const std::string of = unit(tableOf<Optimisation>().find(edge.key)->unit);
        const auto value = [&](double level) {
            return of.empty() ? number(level) : number(level) + "\u00a0" + of;
        };
        std::string line =
            filled(edge.isMost ? SPARKOUT_NOOP("Search", "“%1” has the maximum level, %2;")
                               : SPARKOUT_NOOP("Search", "“%1” has the minimum level, %2;"),
                   {setting(edge.key), value(edge.level)});
        line += ' ';
        line += edge.isLimit ? translated(SPARKOUT_NOOP("Search", "no other is allowed."))
                : edge.limit ? filled(SPARKOUT_NOOP("Search", "allowed: %1."), {value(*edge.limit)})
                             : translated(SPARKOUT_NOOP("Search", "smaller values are allowed."));
        lines.push_back(std::move(line));
    }
}

void SearchWording::addRemarks(const SearchOutcome& outcome,
                               std::vector<std::string>& lines) const {
    if (!outcome.remarks.noMargin.empty()) {
        lines.push_back(filled(
            SPARKOUT_NOOP(
                "Search",
                "No margin is left for: %1. For a cycle with a margin, set “%2” in the search."),
            {names(outcome.remarks.noMargin), setting("margin_within_min")}));
    }
    if (const std::optional<double>& ratio = outcome.remarks.ratioNearInteger) {
        lines.push_back(filled(SPARKOUT_NOOP("Search", "The rotation ratio of wheel and work is "
                                                       "near a whole number, %1: waviness. To rule "
                                                       "that out, set “%2” in the search."),
                               {significant(*ratio, 4), setting("least_ratio_distance")}));
    }
    for (const Issue& issue : outcome.remarks.issues) {
        lines.push_back(remark(issue));
    }
}

void SearchWording::addRobustness(const SearchOutcome& outcome,
                                  std::vector<std::string>& lines) const {
    const RobustSummary& robust = *outcome.robust;
    const auto most = [&](double share) { return fixed(std::ceil(share * 1e4) / 1e2, 2); };
    if (!outcome.marginWithin_us) {
        lines.push_back(filled("The cycle is fit in the last sample of scenarios; "
                               "scenarios that had to be added: %1.",
                               {whole(std::int64_t(robust.added.size()))}));
    }
    const FoundCycle& answer = *outcome.answer();
    if (outcome.project.batch && !areOfBatch(outcome.project.optimisation->scenarios)) {
        lines.push_back("The batch of the project was not part of the search.");
    }
    if (answer.decided) {
        constexpr int digits = 6; // nm
        const auto stock = [&](double stock_mm) { return fixed(stock_mm, digits); };
        lines.push_back(
            filled(answer.decided->corners > 0
                       ? "The cycle is fit for every stock of %1…%2 mm per side, with the "
                         "other inputs unchanged and at each of the %3 corners of the "
                         "batch's other factors: decided, not sampled."
                       : "The cycle is fit for every stock of %1…%2 mm per side, "
                         "with the other inputs unchanged: decided, not sampled.",
                   {stock(answer.decided->stocks.from_mm), stock(answer.decided->stocks.to_mm),
                    whole(answer.decided->corners)}));
    } else {
        lines.push_back(filled("The cycle is fit for all %1 stocks drawn at random within one "
                               "infeed (cycle no. %2 tried in this way): with 95 % confidence "
                               "it is unfit for at most %3 % of all stocks.",
                               {whole(freshPhaseCount), whole(std::max(answer.candidate, 1)),
                                most(*outcome.mostStocksFailing())}));
    }
    if (const FreshParts& parts = answer.freshParts; parts.tried > 0) {
        lines.push_back(filled(
            "None of %1 newly drawn parts of the batch is rejected (cycle no. %2 tried in this "
            "way): with 95 % confidence at most %3 % of all parts are.",
            {whole(parts.tried), whole(std::max(answer.candidate, 1)),
             most(*outcome.mostPartsBad())}));
        if (parts.ppk) {
            lines.push_back(filled(parts.isCapable
                                       ? "The lower 95 % bound of their Ppk is %1."
                                       : "The lower 95 % bound of their Ppk is %1, too low for "
                                         "the limits of the batch; no cycle found meets them.",
                                   {fixed(*parts.ppk, 2)}));
        }
    }
    if (robust.nominalTime_s > 0) {
        lines.push_back(filled("The nominal part alone, of the same levels, would take %1: "
                               "robustness costs %2 % of time.",
                               {time(robust.nominalTime_s),
                                percent(outcome.best()->time_s / robust.nominalTime_s - 1)}));
    }
}

std::string SearchWording::front(const SearchOutcome& outcome) const {
    if (outcome.wear) {
        return translated(
            SPARKOUT_NOOP("Search", "Margins by time are searched for the minimum time, or for the "
                                    "maximum margin; this search is for parts between dressings."));
    }
    if (outcome.isFrontComing) {
        return translated(SPARKOUT_NOOP("Search", "The search for margins by time continues."));
    }
    if (isHeuristic(outcome.method)) {
        return filled(
            SPARKOUT_NOOP("Search", "Margins by time are searched only by the exact search (%1)."),
            {method(SearchMethod::pruned)});
    }
    const std::vector<const FoundCycle*> points = outcome.front();
    if (points.empty() && outcome.robust && outcome.best() && !outcome.best()->decided) {
        return translated(SPARKOUT_NOOP("Search", "Margins by time for all stocks within one "
                                                  "infeed are searched only under gauge control."));
    }
    if (points.empty()) {
        return translated(SPARKOUT_NOOP(
            "Search", "No margins by time: the search was stopped first, or no cycle is fit."));
    }
    const std::string all =
        outcome.isFrontWhole
            ? filled(SPARKOUT_NOOP("Search", "Cycles of the grid that no other cycle beats in both "
                                             "time and distance from its limits: %1."),
                     {whole(std::int64_t(points.size()))})
            : filled(SPARKOUT_NOOP("Search", "Up to %1; cycles that take longer may have larger "
                                             "margins."),
                     {time(points.back()->time_s)});
    return outcome.robust
               ? all + ' '
                     + translated(SPARKOUT_NOOP("Search", "The margin is the least over all "
                                                          "cases for which the cycle must be fit."))
               : all;
}

} // namespace sparkout
