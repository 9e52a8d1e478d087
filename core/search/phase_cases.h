// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"
#include "core/quality/constraints.h"
#include "core/search/optimise.h"

#include <cstdint>
#include <optional>
#include <stop_token>
#include <vector>

namespace sparkout {

/// Cases for which a robust answer under gauge control is decided: every stock of a range, for the
/// nominal part and for each corner of the batch's other factors.
struct PhaseCases {
    StockRange stocks; ///< per side
    /// With the scenarios `corners` the number of corners of all factors but the stock; otherwise
    /// 0.
    std::int64_t corners = 0;
};

/// Returns the cases of the project's optimisation. The range is usualPhases(); where the answer
/// must be fit for a batch whose stock scatters, it extends as far beyond the batch's least and
/// greatest stock. The project's batch, if it counts, must pass checkBatch().
[[nodiscard]] PhaseCases phaseCases(const Project& project);

/// Returns a case for which the project's cycle fails, with a stock near the worst one; nullopt if
/// the cycle is fit for all cases, or after a stop. The project's phases must be decidable.
[[nodiscard]] std::optional<Project> failingCase(const Project& best,
                                                 const std::stop_token& stop = {});

/// Decides on successive cycles of one project, beginning with the cases in which earlier ones
/// failed: a failing cycle mostly fails in one of these.
class CaseOrder {
public:
    /// Returns a failing part among the cases in which earlier cycles failed; nullopt if the cycle
    /// is fit for these.
    [[nodiscard]] std::optional<FailingPart> failingInKnownCase(const Project& best,
                                                                const std::stop_token& stop = {});
    /// Returns a failing part among the other cases. After failingInKnownCase() of the same cycle
    /// the answer equals that of failingCase().
    [[nodiscard]] std::optional<FailingPart> failingInOtherCase(const Project& best,
                                                                const std::stop_token& stop = {});

private:
    /// Corners of ScenarioSource; −1: the nominal part. The last failing one is first.
    std::vector<std::int64_t> m_failed;
};

/// Returns the requirement with the least relative margin over all of these cases; nullopt if the
/// project's cycle fails for one of them or has less than `least` there, or after a stop.
[[nodiscard]] std::optional<ConstraintResult> worstOfCases(const Project& best, double least,
                                                           const std::stop_token& stop = {});

} // namespace sparkout
