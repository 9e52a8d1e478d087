// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/project/batch.h"
#include "core/project/project.h"
#include "core/quality/constraints.h"
#include "core/result.h"
#include "core/setup/setup.h"
#include "core/simulation/result.h"

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

/// The number of parts that a wheel grinds between two dressings, and the best number.
namespace sparkout {

struct Cost;

/// The cost of a part [GILBERT1950], in the currency of the rates:
///
///     C = C_m·(T + t_h + t_d/N) + C_d/N
///
/// C_m the rate of machine and operator, T the mean time of the cycle, t_h handling, t_d the time
/// and C_d the wheel and diamond of a dressing, N the parts between dressings; without N there is
/// no dressing.
[[nodiscard]] double partCost(const Cost& cost, double time_s, std::optional<std::int64_t> parts);

/// The number given by the rates of a project, otherwise by its batch's dullness; empty: no
/// dressing.
[[nodiscard]] std::optional<std::int64_t> partsBetweenDressings(const Project& project);

/// By the rates of a project, with its partsBetweenDressings(). N then does not depend on the
/// cycle, and the quickest cycle of a grid is the cheapest. The cheapest cycle with N by the
/// wheel's wear is in interval_search.h.
///
/// Empty if the project has no rates.
[[nodiscard]] std::optional<double> costPerPart(const Project& project, double time_s);

/// Why the parts between dressings are not known.
enum class DressingFault {
    none,
    noWear,    ///< the set-up does not give the wear of the wheel
    firstFails ///< the first part after dressing does not reach size
};

/// The first part for which the worn wheel fails.
struct WornFailure {
    std::int64_t part = 0; ///< counted from 1
    std::size_t surface = 0;
    /// The part of the surface's batch, from 0; empty: the nominal part.
    std::optional<std::int64_t> scenario;
    Issues issues; ///< faults of the inputs with this wheel; empty: it was run
    RunStatus status = RunStatus::completed;
    std::optional<ConstraintResult> worst; ///< the worst violation, once completed
};

struct DressingOptions {
    /// Scenarios: every surface must also be fit for the parts of its batch, chosen in this way;
    /// their dullness follows from the wear. A surface without a batch has only its nominal part.
    std::optional<Scenarios> scenarios;
    std::int64_t most = 10000;                     ///< parts that are tried
    std::function<void(std::int64_t part)> onPart; ///< called after each tried part
    std::stop_token stop;
};

struct DressingInterval {
    DressingFault fault = DressingFault::none;
    Issues issues; ///< why a surface or its batch cannot be run
    /// Each of the parts 1 to N meets every requirement; the next one does not, see `end`.
    std::int64_t parts = 0;
    std::optional<WornFailure> end;
    /// No part ever fails, since the wheel no longer changes.
    bool isEndless = false;
    bool isStopped = false;     ///< stopped without a result
    double partVolume_mm3 = 0;  ///< removed by the cycles of the first part
    std::int64_t tried = 0;     ///< runs
    std::vector<double> time_s; ///< times of all cycles of each part 1…N, nominal

    [[nodiscard]] bool ran() const { return fault == DressingFault::none && issues.empty(); }
};

/// Runs part after part with the wheel worn by the removal of the earlier ones, each as much as the
/// first [MODEL-12], each surface by itself and in each of its scenarios, until the first failure.
/// No part is skipped: a requirement may fail for one part and be met with a duller wheel, as the
/// ends of stages jump from step to step. The set-up must have no faults.
[[nodiscard]] DressingInterval dressingInterval(const Setup& given,
                                                const DressingOptions& options = {});

/// The rates of the first surface with rates; null if there are none.
[[nodiscard]] const Cost* ratesOf(const Setup& setup);

/// A number of parts between dressings, and its value for each part.
struct BestInterval {
    std::int64_t parts = 0;
    double value = 0; ///< s, or in the currency of the rates
};

/// The quickest interval, of N parts: least (T_1 + … + T_N + t_d)/N [s], t_d the time of a
/// dressing. The first of equal ones; empty without parts.
[[nodiscard]] std::optional<BestInterval> quickestInterval(const DressingInterval& interval,
                                                           double dressing_s);
/// The cheapest interval by partCost() of the mean time.
[[nodiscard]] std::optional<BestInterval> cheapestInterval(const DressingInterval& interval,
                                                           const Cost& cost);

/// The quickest and the cheapest interval between dressings; neither without rates of cost.
struct BestIntervals {
    std::optional<BestInterval> quickest, cheapest;
};
[[nodiscard]] BestIntervals bestIntervals(const Setup& setup, const DressingInterval& interval);

/// The part that ends an interval.
struct WornFailureOf {
    const Setup& setup;
    const WornFailure& failure;
};

[[nodiscard]] std::span<const Output<DressingInterval>> dressingOutputs();
[[nodiscard]] std::span<const Output<WornFailureOf>> wornFailureOutputs();
[[nodiscard]] std::span<const Output<BestInterval>> quickestIntervalOutputs();
[[nodiscard]] std::span<const Output<BestInterval>> cheapestIntervalOutputs();

/// The object of `dressing --json`.
[[nodiscard]] std::string dressingJson(const Setup& setup, const DressingInterval& interval);

} // namespace sparkout
