// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/optimise.h"

/// Proof that the pruned search finds the cycle of the full search.
///
/// 1. Shared prefixes. A step depends on the state and its feed alone (CycleSteps), and a stage's
///    end on the reading after its steps. So cycles that agree up to a stage have the same state
///    after it, bit by bit, and under gauge control, where no feed depends on the stocks, a stage
///    run once to the last possible end passes through all its ends for all stocks. (Under position
///    control the last step is cut short by the stock: each stock is run separately, and the cycle
///    found is run again as the project states it, with the unrounded stocks.)
/// 2. Merged states. Ends that fall on one step leave one state. From the end with the most stock
///    left every continuation of the others is possible, with the same passes, hence the same time
///    and margins, and it comes first in grid order. So only this one is extended. Other parts end
///    their stages elsewhere: with scenarios only ends of the stage before the last are merged, and
///    where the part itself holds, each of their cycles is run on the scenarios. The same applies
///    where stages have bounds of their own stocks, which may forbid an extension of the first end.
/// 3. Bounds. A branch is dropped when TimeBound proves that its cycles take longer than the best
///    one so far; equal times are not dropped. Branches are taken in the order of their bounds, so
///    the bound of the next one holds for all that is left; those beyond the memory given newest
///    first, their bounds not below the last one taken in order. The extensions of a state are
///    found when its turn comes.
/// 4. Cuts. A branch is dropped when PassCuts finds that its passes break a requirement, and a
///    cycle before its last stage is run when three radii of the part, or of a scenario, show that
///    it takes too long or cuts too deep (LastStageBound), or that it cuts too deep for some stock
///    of a case (CaseRefuter), mostly without following a radius. On scenarios, too, the common
///    stages of cycles are run once (ScenarioRunner), as in point 1.
/// 5. Equal neighbours. Under gauge control two stages in a row with one setting make the passes of
///    one stage with the stock of both, on every part: the end of the first changes only the number
///    of the stage. The cycle with one stage less takes the same time and has the same margins,
///    except that of the gauge's commands, which is larger. So where that number of stages is
///    listed earlier, and no bound of a stage forbids the sum, the shorter cycle is better and the
///    longer one is not run.
///
/// For the greatest margin within a time the bound of point 3 is that time instead of the best
/// one's. A branch is also dropped, and a cycle cut (PassCuts), where its margin is proved to be
/// less than that of the best so far, but not where it is equal. The cycles that one represents by
/// points 2 and 5 have its margin or a smaller one.
///
/// The remaining cycles are judged as in the full search, from the same result of the same passes.
namespace sparkout {

/// Makes the pruned search; fills the whole summary except `cycle` and `gridSize`. After a stop at
/// any moment the bound holds for all cycles of the grid.
[[nodiscard]] SearchSummary prunedSearch(const Project& project, const Grid& grid,
                                         const SearchOptions& options);

} // namespace sparkout
