// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"
#include "core/phases/phase_decision.h"
#include "core/quality/constraints.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// What a robust answer under gauge control is decided to hold for: every stock of a range, for the
/// part as it stands and for each corner of the batch's other factors.
struct PhaseCases {
    StockRange stocks; ///< per side
    /// With the scenarios `corners` those of all factors but the stock; else 0.
    std::int64_t corners = 0;
};

/// Those that the project's optimisation asks for. The range is usualPhases(); where the answer
/// has to hold for a batch whose stock scatters, with as much beyond its least and greatest stock.
/// Of a project whose batch, if it counts, checkBatch() passes.
[[nodiscard]] PhaseCases phaseCases(const Project& project);

/// One of these cases for which the project's cycle fails, with a stock near where it does by most;
/// nothing: it holds for all of them. Of a project whose phases can be decided. A stop ends it with
/// nothing.
[[nodiscard]] std::optional<Project> failingCase(const Project& best,
                                                 const std::stop_token& stop = {});

/// Decides on cycles of one project, one after the other, those cases first in which others failed:
/// a cycle that fails does so mostly in one of these.
class CaseOrder {
public:
    /// Of the cases in which others failed; nothing: it holds for these.
    [[nodiscard]] std::optional<FailingPart> failingAgain(const Project& best,
                                                          const std::stop_token& stop = {});
    /// Of the others. After failingAgain() of the same cycle the answer is that of failingCase().
    [[nodiscard]] std::optional<FailingPart> failingElse(const Project& best,
                                                         const std::stop_token& stop = {});

private:
    /// Corners of ScenarioSource; −1: the part as it stands. The one that failed last first.
    std::vector<std::int64_t> m_failed;
};

/// The requirement with the least relative margin over all of these cases; nothing: the project's
/// cycle fails for one of them, or has less than `least` there, or it was stopped.
[[nodiscard]] std::optional<ConstraintResult> worstOfCases(const Project& best, double least,
                                                           const std::stop_token& stop = {});

} // namespace sparkout
