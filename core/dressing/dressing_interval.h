// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/batch.h"
#include "core/quality/constraints.h"
#include "core/setup/setup.h"
#include "core/simulation/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <stop_token>
#include <vector>

/// How many parts a wheel grinds from one dressing to the next, and after how many it is best
/// dressed.
namespace sparkout {

struct Cost;

/// Why nothing is known of the parts between dressings.
enum class DressingFault {
    none,
    noWear,    ///< the set-up says nothing of how the wheel wears
    firstFails ///< the first part after dressing does not reach size
};

/// The first part for which the worn wheel no longer does.
struct WornFailure {
    std::int64_t part = 0; ///< from 1
    std::size_t surface = 0;
    /// The part of the surface's batch, from 0; nothing: the part as it stands.
    std::optional<std::int64_t> scenario;
    Issues issues; ///< of the inputs with this wheel; empty: it was run
    RunStatus status = RunStatus::completed;
    std::optional<ConstraintResult> worst; ///< the requirement that fails by most, once completed
};

struct DressingOptions {
    /// Every surface must hold for the parts of its batch too, in this way of choosing them; their
    /// dullness is the wear's. A surface without a batch is tried as it stands.
    std::optional<Scenarios> scenarios;
    std::int64_t most = 10000;                     ///< parts that are tried
    std::function<void(std::int64_t part)> onPart; ///< after each that was tried
    std::stop_token stop;
};

/// The parts between dressings of a set-up as it stands.
struct DressingInterval {
    DressingFault fault = DressingFault::none;
    Issues issues; ///< why a surface cannot be run, or its batch
    /// Each of the parts 1 to N meets every requirement; the next one does not, as `end` says.
    std::int64_t parts = 0;
    std::optional<WornFailure> end;
    /// No part fails however many there are, for from one on all find the same wheel.
    bool isEndless = false;
    bool isStopped = false;     ///< nothing is known
    double partVolume_mm3 = 0;  ///< that the cycles of the first part remove
    std::int64_t tried = 0;     ///< runs
    std::vector<double> time_s; ///< of the cycles of the parts 1…N together, as they stand

    [[nodiscard]] bool ran() const { return fault == DressingFault::none && issues.empty(); }
};

/// Runs part after part with the wheel as the metal that those before have lost has left it, each
/// as much as the first [MODEL-12], each surface by itself and in each of its scenarios, until the
/// first that does not hold. No part is left out: a requirement may fail for one part and hold for
/// a duller wheel again, as the moments at which stages end go from step to step. Of a set-up
/// without faults.
[[nodiscard]] DressingInterval dressingInterval(const Setup& given,
                                                const DressingOptions& options = {});

/// The rates of the first surface that gives some; null: none does.
[[nodiscard]] const Cost* ratesOf(const Setup& setup);

/// Parts between dressings, and what they come to for each part.
struct BestInterval {
    std::int64_t parts = 0;
    double value = 0; ///< s, or in the currency of the rates
};

/// The quickest interval, of N parts: least (T_1 + … + T_N + t_d)/N [s], t_d the time of a
/// dressing. The first of several; nothing without parts.
[[nodiscard]] std::optional<BestInterval> quickestInterval(const DressingInterval& interval,
                                                           double dressing_s);
/// The cheapest interval by partCost() of the mean time.
[[nodiscard]] std::optional<BestInterval> cheapestInterval(const DressingInterval& interval,
                                                           const Cost& cost);

} // namespace sparkout
