// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/search.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout {

/// What the view of the search says of grids, cycles and answers.
class OptimiseText {
    Q_DECLARE_TR_FUNCTIONS(OptimiseText)
public:
    static QString time(double time_s);   ///< "43.71 s", "5.714 min"
    static QString percent(double share); ///< "−70.2", without unit
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
    static QString method(SearchMethod method);     ///< "Pruned search"
    static QString methodHint(SearchMethod method); ///< what it proves, and when it is slow
    /// What a search between dressings would find.
    static QString offer(SearchObjective objective);
    static QString fault(const SearchOutcome& outcome); ///< why nothing could be searched
    /// What the margins by time are of, or why there are none.
    static QString front(const SearchOutcome& outcome);
    /// What of the answer stands beside answerTable(); where no cycle was found, why.
    static QString notes(const SearchOutcome& outcome);
};

} // namespace sparkout
