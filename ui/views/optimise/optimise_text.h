// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/whole_search.h"
#include "ui/session/search_runner.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout {

/// What the view of the search says of grids, cycles and answers.
class OptimiseText {
    Q_DECLARE_TR_FUNCTIONS(OptimiseText)
public:
    static QString minutes(double time_s); ///< "5.71", without unit
    static QString percent(double share);  ///< "−70.2", without unit
    /// "290 304 cycles".
    static QString gridSize(std::int64_t size);
    /// Radial feed, axial feed and stock of every stage: "0.004 · 1800 · 0.11 → …".
    static QString cycle(const Cycle& cycle);
    /// The cycle, and what of the machine is not as it was when it was searched.
    static QString found(const FoundCycle& found, const Project& searched);
    static QString cycleHint(Operation operation); ///< what the numbers of cycle() are

    static QString state(const SearchState& state);
    static QString parts(const PartsHeld& held); ///< "636", "at least 10 000", "any number"
    static QString cost(double cost);
    /// What a search between dressings would find.
    static QString offer(SearchObjective objective);
    static QString fault(const SearchOutcome& outcome);  ///< why nothing could be searched
    static QString within(const SearchOutcome& outcome); ///< the time given, "0.92"
    /// What the margins by time are of, or why there are none.
    static QString front(const SearchOutcome& outcome);
    /// What came out, against the time of the cycle before if that ends by itself.
    static QString answer(const SearchOutcome& outcome, std::optional<double> before_s);

private:
    static QString names(const std::vector<ConstraintKind>& kinds);
    static QString cutsOf(const SearchOutcome& outcome);
    /// Of a search for the greatest margin: what came out, and the margins by time.
    static QString marginAnswer(const SearchOutcome& outcome, const FoundCycle& best);
    /// Of a search between dressings.
    static QString intervalAnswer(const SearchOutcome& outcome, const FoundCycle& best);
    static QString objectiveFault(ObjectiveFault fault);
    static QString noAnswer(const SearchOutcome& outcome);
    static QString limitCycles(const SearchOutcome& outcome); ///< of which the stepless limit is
    static QString robustness(const SearchOutcome& outcome, const FoundCycle& best);
    static QString decided(const PhaseCases& cases);
    static QString sampled(int candidate); ///< of fresh phases
    static QString bindingOf(const SearchOutcome& outcome);
    /// Where the best of the grid stands at its edge, and whether the levels followed it.
    static QString levelsOf(const SearchOutcome& outcome);
};

} // namespace sparkout
