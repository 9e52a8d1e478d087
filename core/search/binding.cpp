// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/binding.h"

#include "core/project/cycle.h"
#include "core/search/cycle_runner.h"
#include "core/search/phase_cases.h"
#include "core/search/refine.h"
#include "core/search/robust.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <array>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

bool differInOneFeed(const StageSetting& a, const StageSetting& b) {
    const bool differInInfeed =
        a.radial != b.radial || a.continuousFeed_mm_min != b.continuousFeed_mm_min;
    return a.sparkOut == b.sparkOut && differInInfeed != (a.axialFeed_mm_min != b.axialFeed_mm_min);
}

/// Adds cycles with other feeds in one stage.
void addFeeds(const Grid& grid, const GridCycle& best, std::vector<GridCycle>& found) {
    for (std::size_t z = 0; z < best.size(); ++z) {
        for (std::size_t s = 0; s < grid.settings().size(); ++s) {
            GridCycle other = best;
            other[z].setting = s;
            if (differInOneFeed(grid.settings()[s], grid.settings()[best[z].setting])
                && grid.contains(other)) {
                found.push_back(std::move(other));
            }
        }
    }
}

/// Adds cycles with other shares of two neighbours' stock, the last stage having at least its lower
/// limit.
void addShares(const Grid& grid, const GridCycle& best, std::vector<GridCycle>& found) {
    int taken = 0;
    for (std::size_t z = 0; z + 1 < best.size(); ++z) {
        const bool beforeLast = z + 2 == best.size();
        const int most = beforeLast ? grid.mostTaken(best.size(), z, taken) - taken
                                    : best[z].steps + best[z + 1].steps - 1;
        for (int steps = 1; steps <= most; ++steps) {
            GridCycle other = best;
            other[z].steps = steps;
            other[z + 1].steps += beforeLast ? 0 : best[z].steps - steps;
            if (steps != best[z].steps && grid.contains(other)) {
                found.push_back(std::move(other));
            }
        }
        taken += best[z].steps;
    }
}

/// A cycle and its machine settings.
using Neighbour = std::pair<Cycle, MachineSettings>;

std::vector<Neighbour> neighbours(const Variants& variants, const FeasibleCycle& best,
                                  const std::stop_token& stop) {
    const Grid& grid = variants.grid(best.variant);
    std::vector<GridCycle> others;
    addFeeds(grid, best.cycle, others);
    addShares(grid, best.cycle, others);
    std::vector<Neighbour> found;
    for (const GridCycle& other : others) {
        if (stop.stop_requested()) {
            break;
        }
        found.emplace_back(grid.cycle(other), machineSettings(variants.project(best.variant)));
    }
    for (std::size_t v = 0; v < variants.count(); ++v) {
        const bool alike = (variants.grid(v).sparkOut() > 0) == (grid.sparkOut() > 0);
        if (alike && variants.differInOne(v, best.variant)
            && variants.grid(v).contains(best.cycle)) {
            found.emplace_back(variants.grid(v).cycle(best.cycle),
                               machineSettings(variants.project(v)));
        }
    }
    return found;
}

/// Cycles about one off the grid.
class OffGrid {
public:
    OffGrid(const Project& project, const Cycle& cycle)
        : m_machine(machineSettings(project))
        , m_space(project, cycle)
        , m_own(m_space.valuesOf(cycle)) {}

    std::vector<Neighbour> neighbours() {
        for (int stride = 1; stride <= mostStride; stride *= 2) {
            for (std::size_t i = 0; i < m_own.size(); ++i) {
                for (const int steps : {stride, -stride}) {
                    const std::vector<double> one = moved(m_own, i, steps);
                    add(one);
                    for (std::size_t j = 0; j < m_own.size(); ++j) {
                        if (j != i && m_space.settings()[j].isStock()) {
                            add(moved(one, j, stride));
                            add(moved(one, j, -stride));
                        }
                    }
                }
            }
        }
        return m_found;
    }

private:
    static constexpr int mostStride = 64;

    [[nodiscard]] std::vector<double> moved(std::vector<double> values, std::size_t i,
                                            int steps) const {
        const RefineSpace::Setting& setting = m_space.settings()[i];
        const double to = values[i] + steps * setting.stepAt(values[i]);
        values[i] = setting.rounded(std::clamp(to, setting.low, setting.high));
        return values;
    }

    void add(const std::vector<double>& values) {
        if (const auto other = m_space.cycleOf(values); other && values != m_own) {
            m_found.emplace_back(*other, m_machine);
        }
    }

    MachineSettings m_machine;
    RefineSpace m_space;
    std::vector<double> m_own;
    std::vector<Neighbour> m_found;
};

/// Removes long lists that a single part does not need, since variants and neighbours are many
/// copies.
Project withoutLists(Project project) {
    project.runs.clear();
    project.notes.clear();
    project.batch.reset();
    return project;
}

using KindMask = std::array<bool, constraintKinds>;

std::vector<ConstraintKind> kindsOf(const KindMask& mask) {
    std::vector<ConstraintKind> kinds;
    for (const Requirement& row : requirementRows) {
        if (mask[static_cast<std::size_t>(row.kind)]) {
            kinds.push_back(row.kind);
        }
    }
    return kinds;
}

/// Collects the kinds with the least relative margin.
class LeastMargins {
public:
    void add(const ConstraintResult& each) {
        if (each.relativeMargin < m_least) {
            m_least = each.relativeMargin;
            m_least_of.fill(false);
        }
        m_least_of[static_cast<std::size_t>(each.kind)] |= each.relativeMargin == m_least;
    }

    [[nodiscard]] std::vector<ConstraintKind> kinds() const { return kindsOf(m_least_of); }

private:
    double m_least = std::numeric_limits<double>::infinity();
    KindMask m_least_of{};
};

/// Runs the cycle on the part, on those drawn for it in a robust search, and in the scenarios, and
/// gives `take` each requirement. Returns false when stopped.
template <typename Take>
bool runCases(const Project& best, bool isRobust, const std::vector<Project>& scenarios,
              const std::stop_token& stop, Take take) {
    std::vector<Project> parts{best};
    if (isRobust) {
        for (Project& drawn : scenariosAskedFor(best, stop)(best, 0)) {
            parts.push_back(std::move(drawn));
        }
    }
    parts.insert(parts.end(), scenarios.begin(), scenarios.end());
    for (Project& part : parts) {
        part.runs.clear();
        setMachine(part, machineSettings(best));
        *part.cycle = *best.cycle;
        const SimulationResult result = simulateUnchecked(part, nullptr, stop);
        if (result.status == RunStatus::stopped || stop.stop_requested()) {
            return false;
        }
        for (const ConstraintResult& each : evaluateConstraints(result)) {
            take(each);
        }
    }
    return true;
}

/// The requirements violated by the cycles that are quicker than `time_us`; nullopt if stopped
/// before all were run.
std::optional<std::vector<ConstraintKind>> brokenIn(const std::vector<Neighbour>& others,
                                                    std::int64_t time_us, const Project& project,
                                                    const std::vector<Project>& scenarios,
                                                    const std::stop_token& stop) {
    if (stop.stop_requested()) {
        return std::nullopt; // possibly incomplete
    }
    std::vector<Project> parts{project};
    for (const Project& scenario : scenarios) {
        if (stop.stop_requested()) {
            return std::nullopt;
        }
        parts.push_back(scenario);
    }
    KindMask binds{};
    for (const auto& [cycle, machine] : others) {
        for (Project& part : parts) {
            setMachine(part, machine);
            *part.cycle = cycle;
            const SimulationResult result = simulateUnchecked(part, nullptr, stop);
            if (result.status == RunStatus::stopped || stop.stop_requested()) {
                return std::nullopt;
            }
            if (&part == &parts.front() && comparedTime_us(result.time_s) >= time_us) {
                break;
            }
            for (const ConstraintResult& each : evaluateConstraints(result)) {
                binds[static_cast<std::size_t>(each.kind)] |= !each.holds;
            }
        }
    }
    return kindsOf(binds);
}

} // namespace

std::optional<std::vector<ConstraintKind>>
bindingRequirements(const Project& project, const FeasibleCycle& best,
                    const std::vector<Project>& scenarios, const std::stop_token& stop) {
    const Project plain = withoutLists(project);
    const Variants variants(plain, stop);
    if (variants.isCutShort()) {
        return std::nullopt;
    }
    return brokenIn(neighbours(variants, best, stop), best.time_us, plain, scenarios, stop);
}

std::optional<std::vector<ConstraintKind>>
bindingRequirements(const Project& project, const Cycle& cycle, std::int64_t time_us,
                    const std::vector<Project>& scenarios, const std::stop_token& stop) {
    const Project plain = withoutLists(project);
    return brokenIn(OffGrid(plain, cycle).neighbours(), time_us, plain, scenarios, stop);
}

std::optional<std::vector<ConstraintKind>>
leastMarginRequirements(const Project& best, bool isRobust, const std::stop_token& stop) {
    LeastMargins margins;
    const auto add = [&margins](const ConstraintResult& each) { margins.add(each); };
    if (!runCases(best, isRobust, {}, stop, add)) {
        return std::nullopt;
    }
    if (isRobust && canDecidePhases(best)) {
        constexpr double any = -std::numeric_limits<double>::infinity();
        const std::optional<ConstraintResult> worst = worstOfCases(best, any, stop);
        if (!worst) {
            return std::nullopt;
        }
        margins.add(*worst);
    }
    return margins.kinds();
}

std::optional<std::vector<ConstraintKind>>
requirementsBelowMargin(const Project& best, double margin, bool isRobust,
                        const std::vector<Project>& scenarios, const std::stop_token& stop) {
    KindMask below{};
    const auto take = [&](const ConstraintResult& each) {
        below[static_cast<std::size_t>(each.kind)] |=
            each.relativeMargin < margin
            && requirementOf(each.kind).scope != ConstraintScope::setting;
    };
    if (!runCases(best, isRobust, scenarios, stop, take)) {
        return std::nullopt;
    }
    return kindsOf(below);
}

} // namespace sparkout
