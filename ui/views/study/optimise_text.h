// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/search.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout {

/// Texts of the search view about grids, cycles and answers.
class OptimiseText {
    Q_DECLARE_TR_FUNCTIONS(OptimiseText)
public:
    static QString time(double time_s);   ///< "43.71 s", "5.714 min"
    static QString percent(double share); ///< "−70.2", without unit
    /// "290 304 cycles".
    static QString gridSize(std::int64_t size);
    /// Radial feed, axial feed and stock of every stage: "0.004 · 1800 · 0.11 → …".
    static QString cycle(const Cycle& cycle);
    /// The cycle, and the machine settings that differ from those of the searched project.
    static QString found(const FoundCycle& found, const Project& searched);
    static QString cycleHint(Operation operation); ///< explains the numbers of cycle()

    static QString state(const SearchState& state);
    static QString parts(const PartsHeld& held); ///< "636", "at least 10 000", "any number"
    static QString cost(double cost);
    static QString method(SearchMethod method);     ///< "Pruned search"
    static QString methodHint(SearchMethod method); ///< what it proves, and when it is slow
    /// The possible result of a search between dressings.
    static QString offer(SearchObjective objective);
    static QString fault(const SearchOutcome& outcome); ///< the reason why the search could not run
    /// The parts or stocks to which the margins by time apply, or the reason why there are none.
    static QString front(const SearchOutcome& outcome);
    /// Notes on the answer that answerTable() does not contain; without a cycle the reason.
    static QString notes(const SearchOutcome& outcome);
};

} // namespace sparkout
