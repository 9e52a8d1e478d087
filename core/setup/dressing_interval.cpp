// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/dressing_interval.h"

#include "core/batch/batch_run.h"
#include "core/batch/scenario_source.h"
#include "core/file/output_json.h"
#include "core/project/optimisation.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/result_names.h"
#include "core/setup/setup_run.h"
#include "core/setup/worn_project.h"
#include "core/simulation/simulate.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

/// The wheel of a set-up between two dressings [MODEL-12]. At part n it has removed n − 1 times the
/// removal of all cycles of the first part, as simulated, plus that of the part's earlier surfaces.
class WornParts {
public:
    /// For a set-up with the run of its first part after dressing.
    WornParts(const Setup& setup, const SetupRun& first) : m_wear(setup.wear) {
        for (const SurfaceRun& surface : first.surfaces) {
            m_before.push_back(m_part);
            m_part += surface.removed();
        }
    }

    [[nodiscard]] double partVolume_mm3() const { return m_part.volume_mm3; }
    /// Wears the dressed wheel of a project to its state at a surface of a part, from 1.
    void wear(Project& dressed, std::size_t surface, std::int64_t part) const {
        wearWheel(dressed, m_wear, m_before[surface] + static_cast<double>(part - 1) * m_part);
    }
    /// Whether the wheel no longer changes from this part on.
    [[nodiscard]] bool isWornOut(const Wheel& dressed, std::int64_t part) const {
        return sparkout::isWornOut(dressed, m_wear, static_cast<double>(part - 1) * m_part);
    }

private:
    WheelWear m_wear;
    RemovedMetal m_part;                ///< metal removed by all surfaces
    std::vector<RemovedMetal> m_before; ///< metal removed by the earlier surfaces of each
};

/// A surface, nominal or with a part of its batch.
struct Case {
    std::size_t surface;
    std::optional<std::int64_t> scenario;
    Project project;
};

/// Its batch, without the dullness, which follows from the wear.
Project batchOf(const Project& project, Scenarios scenarios) {
    Project sampled = project;
    sampled.batch->scenarios = scenarios;
    sampled.batch->factors.dullness.reset();
    return sampled;
}

/// Runs the parts of one case after the other.
class Walk {
public:
    Walk(const WornParts& worn, const DressingOptions& options, DressingInterval& found)
        : m_worn(worn), m_options(options), m_found(found) {
        m_found.parts = options.most;
    }

    /// Runs the remaining parts in one case; false after a stop.
    bool walk(const Case& dressed, bool isTimed) {
        for (std::int64_t part = 1; part <= m_found.parts; ++part) {
            Case tried = dressed;
            m_worn.wear(tried.project, tried.surface, part);
            std::optional<WornFailure> failure = failureOf(tried, part, isTimed);
            if (m_options.stop.stop_requested()) {
                m_found.isStopped = true;
                m_found.parts = 0;
                m_found.time_s.clear();
                m_found.end.reset();
                return false;
            }
            if (failure) {
                m_found.end = std::move(failure);
                m_found.parts = part - 1;
                return true;
            }
            if (m_options.onPart) {
                m_options.onPart(part);
            }
            if (m_worn.isWornOut(*dressed.project.wheel, part)) {
                m_wornOut = part;
                if (isTimed) {
                    m_alike.emplace_back(part, m_last_s);
                }
                return true;
            }
        }
        return true;
    }
    /// The first part from which the wheel no longer changes; empty if none was reached.
    [[nodiscard]] std::optional<std::int64_t> wornOut() const { return m_wornOut; }

    /// Completes the times of all good parts: parts that were not run since the wheel is unchanged
    /// have the time of the previous part.
    void completeTimes() {
        m_found.time_s.resize(static_cast<std::size_t>(m_found.parts));
        for (const auto& [part, time_s] : m_alike) {
            for (std::int64_t each = part; each < m_found.parts; ++each) {
                m_found.time_s[static_cast<std::size_t>(each)] += time_s;
            }
        }
    }

private:
    std::optional<WornFailure> failureOf(const Case& tried, std::int64_t part, bool isTimed) {
        WornFailure failure{part, tried.surface, tried.scenario, validate(tried.project), {}, {}};
        std::erase_if(failure.issues,
                      [](const Issue& issue) { return issue.severity != Severity::error; });
        if (!failure.issues.empty()) {
            return failure;
        }
        ++m_found.tried;
        const SimulationResult result = simulateUnchecked(tried.project, nullptr, m_options.stop);
        failure.status = result.status;
        if (result.status != RunStatus::completed) {
            return failure;
        }
        if (isTimed) {
            const auto at = static_cast<std::size_t>(part - 1);
            m_found.time_s.resize(std::max(m_found.time_s.size(), at + 1));
            m_found.time_s[at] += m_last_s = result.time_s;
        }
        for (ConstraintResult& each : evaluateConstraints(result)) {
            if (!each.holds
                && (!failure.worst || each.relativeMargin < failure.worst->relativeMargin)) {
                failure.worst = each;
            }
        }
        return failure.worst ? std::optional(std::move(failure)) : std::nullopt;
    }

    const WornParts& m_worn;
    const DressingOptions& m_options;
    DressingInterval& m_found;
    std::optional<std::int64_t> m_wornOut;
    std::vector<std::pair<std::int64_t, double>> m_alike; ///< first part of a time, and the time
    double m_last_s = 0;
};

/// Why the batches for which the surfaces must be fit cannot be run.
Issues batchFaults(const Setup& setup, const DressingOptions& options) {
    Issues issues;
    for (std::size_t i = 0; i < setup.surfaces.size() && options.scenarios; ++i) {
        const Project& project = setup.surfaces[i].project;
        if (project.batch && issues.empty()) {
            issues = checkBatch(batchOf(project, *options.scenarios));
        }
    }
    return issues;
}

/// Runs every scenario of every surface; false after a stop.
bool walkScenarios(const Setup& setup, const DressingOptions& options, Walk& walk) {
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        const Project& project = setup.surfaces[i].project;
        if (!project.batch) {
            continue;
        }
        const ScenarioSource source(batchOf(project, *options.scenarios));
        for (std::int64_t part = 0; part < source.parts(); ++part) {
            if (!walk.walk({i, part, source.project(part)}, false)) {
                return false;
            }
        }
    }
    return true;
}

template <typename Value>
std::optional<BestInterval> bestInterval(const DressingInterval& interval, const Value& valueOf) {
    std::optional<BestInterval> best;
    double sum_s = 0;
    for (std::size_t i = 0; i < interval.time_s.size(); ++i) {
        sum_s += interval.time_s[i];
        const auto parts = static_cast<std::int64_t>(i) + 1;
        const double value = valueOf(sum_s / static_cast<double>(parts), parts);
        if (!best || value < best->value) {
            best = {parts, value};
        }
    }
    return best;
}

constexpr Output<DressingInterval> intervalRows[] = {
    {{.key = "parts", .hint = "parts of one dressing that meet every requirement"},
     [](const DressingInterval& d) { return d.parts; }},
    {{.key = "endless", .hint = "whether no part fails, however many are ground"},
     [](const DressingInterval& d) { return d.isEndless; }},
    {{.key = "at_least", .hint = "whether all parts tried are good"},
     [](const DressingInterval& d) { return !d.end && !d.isEndless; }},
    {{.key = "part_volume_mm3", .unit = "mm³", .hint = "metal that a part loses"},
     [](const DressingInterval& d) { return d.partVolume_mm3; }},
    {{.key = "runs", .hint = "cycles that were run"},
     [](const DressingInterval& d) { return d.tried; }},
};

/// Null if the part was not judged.
template <class Value>
std::optional<Value> ofWorst(const WornFailureOf& f, Value (*value)(const ConstraintResult&)) {
    return f.failure.worst ? std::optional(value(*f.failure.worst)) : std::nullopt;
}

constexpr Output<WornFailureOf> failureRows[] = {
    {{.key = "part", .hint = "the first part that fails, from 1"},
     [](const WornFailureOf& f) { return f.failure.part; }},
    {{.key = "surface"},
     [](const WornFailureOf& f) { return f.setup.surfaces[f.failure.surface].name; }},
    {{.key = "scenario", .hint = "part of the batch of the surface, from 0; none: as it stands"},
     [](const WornFailureOf& f) { return f.failure.scenario; }},
    {{.key = "status", .hint = "refused, or how its cycle ends"},
     [](const WornFailureOf& f) {
         const WornFailure& failure = f.failure;
         return std::string(failure.issues.empty() ? statusKey(failure.status) : "refused");
     }},
    {{.key = "requirement", .hint = "requirement violated most"},
     [](const WornFailureOf& f) {
         return ofWorst<std::string>(
             f, [](auto& c) { return std::string(requirementOf(c.kind).key); });
     }},
    {{.key = "where"},
     [](const WornFailureOf& f) {
         return ofWorst<std::string>(f, [](auto& c) { return whereText(c); });
     }},
    {{.key = "value", .hint = "in the unit of the requirement"},
     [](const WornFailureOf& f) { return ofWorst<double>(f, [](auto& c) { return c.value; }); }},
    {{.key = "limit", .hint = "in the unit of the requirement"},
     [](const WornFailureOf& f) { return ofWorst<double>(f, [](auto& c) { return c.limit; }); }},
};

constexpr Output<BestInterval> partsRow = {{.key = "parts", .hint = "parts between two dressings"},
                                           [](const BestInterval& b) { return b.parts; }};

constexpr Output<BestInterval> quickestRows[] = {
    partsRow,
    {{.key = "time_s", .unit = "s", .hint = "time of a part with its share of the dressing"},
     [](const BestInterval& b) { return b.value; }},
};

constexpr Output<BestInterval> cheapestRows[] = {
    partsRow,
    {{.key = "cost", .hint = "of a part with its share of the dressing"},
     [](const BestInterval& b) { return b.value; }},
};

} // namespace

std::optional<std::int64_t> partsBetweenDressings(const Project& project) {
    if (!project.optimisation || !project.optimisation->cost) {
        return std::nullopt;
    }
    const Cost& cost = *project.optimisation->cost;
    if (cost.parts_between_dressings || !project.batch || !project.batch->factors.dullness) {
        return cost.parts_between_dressings;
    }
    return project.batch->factors.dullness->parts_between_dressings;
}

double partCost(const Cost& cost, double time_s, std::optional<std::int64_t> parts) {
    constexpr double secondsPerHour = 3600;
    double charged_s = time_s + cost.handling_s, worn = 0;
    if (parts) {
        const auto count = static_cast<double>(*parts);
        charged_s += cost.dressing_s / count;
        worn = cost.dressing_cost / count;
    }
    return cost.machine_per_h / secondsPerHour * charged_s + worn;
}

std::optional<double> costPerPart(const Project& project, double time_s) {
    if (!project.optimisation || !project.optimisation->cost) {
        return std::nullopt;
    }
    return partCost(*project.optimisation->cost, time_s, partsBetweenDressings(project));
}

DressingInterval dressingInterval(const Setup& given, const DressingOptions& options) {
    const Setup setup = dressedSetup(given);
    DressingInterval found;
    if (!setup.wear.isGiven()) {
        found.fault = DressingFault::noWear;
        return found;
    }
    const SetupRun first = runSetup(setup, options.stop);
    found.isStopped = options.stop.stop_requested();
    found.issues = first.issues.empty() ? batchFaults(setup, options) : first.issues;
    if (found.isStopped || !found.issues.empty()) {
        return found;
    }
    if (!first.isCompleted(setup)) {
        found.fault = DressingFault::firstFails;
        return found;
    }
    const WornParts worn(setup, first);
    found.partVolume_mm3 = worn.partVolume_mm3();
    Walk walk(worn, options, found);
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        Case asItStands{i, std::nullopt, setup.surfaces[i].project};
        asItStands.project.runs.clear();
        asItStands.project.measured.reset();
        if (!walk.walk(asItStands, true)) {
            return found;
        }
    }
    if (options.scenarios && !walkScenarios(setup, options, walk)) {
        return found;
    }
    found.isEndless = !found.end && walk.wornOut();
    walk.completeTimes();
    return found;
}

const Cost* ratesOf(const Setup& setup) {
    for (const GroundSurface& surface : setup.surfaces) {
        if (surface.project.optimisation && surface.project.optimisation->cost) {
            return &*surface.project.optimisation->cost;
        }
    }
    return nullptr;
}

std::optional<BestInterval> quickestInterval(const DressingInterval& interval, double dressing_s) {
    return bestInterval(interval, [dressing_s](double mean_s, std::int64_t parts) {
        return mean_s + dressing_s / static_cast<double>(parts);
    });
}

std::optional<BestInterval> cheapestInterval(const DressingInterval& interval, const Cost& cost) {
    return bestInterval(interval, [&cost](double mean_s, std::int64_t parts) {
        return partCost(cost, mean_s, parts);
    });
}

BestIntervals bestIntervals(const Setup& setup, const DressingInterval& interval) {
    const Cost* const rates = ratesOf(setup);
    if (!rates) {
        return {};
    }
    return {quickestInterval(interval, rates->dressing_s), cheapestInterval(interval, *rates)};
}

std::span<const Output<DressingInterval>> dressingOutputs() {
    return intervalRows;
}

std::span<const Output<WornFailureOf>> wornFailureOutputs() {
    return failureRows;
}

std::span<const Output<BestInterval>> quickestIntervalOutputs() {
    return quickestRows;
}

std::span<const Output<BestInterval>> cheapestIntervalOutputs() {
    return cheapestRows;
}

std::string dressingJson(const Setup& setup, const DressingInterval& interval) {
    const BestIntervals best = bestIntervals(setup, interval);
    ordered_json json = outputsJson(dressingOutputs(), interval);
    json["ends_by"] =
        interval.end ? outputsJson(wornFailureOutputs(), {setup, *interval.end}) : ordered_json();
    json["quickest"] = outputsJson(quickestIntervalOutputs(), best.quickest);
    json["cheapest"] = outputsJson(cheapestIntervalOutputs(), best.cheapest);
    return json.dump(2) + '\n';
}

} // namespace sparkout
