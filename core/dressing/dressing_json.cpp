// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dressing/dressing_json.h"

#include "core/format/output_json.h"
#include "core/project/optimisation.h"
#include "core/quality/result_names.h"

namespace sparkout {

namespace {

using nlohmann::ordered_json;

constexpr Output<DressingInterval> intervalRows[] = {
    {{.key = "parts", .hint = "parts of one dressing that meet every requirement"},
     [](const DressingInterval& d) { return d.parts; }},
    {{.key = "endless", .hint = "no part fails however many there are"},
     [](const DressingInterval& d) { return d.isEndless; }},
    {{.key = "at_least", .hint = "as many were tried, and none fails"},
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
    {{.key = "requirement", .hint = "the one that fails by most"},
     [](const WornFailureOf& f) {
         return ofWorst<std::string>(
             f, [](auto& c) { return std::string(requirementOf(c.kind).key); });
     }},
    {{.key = "where"}, [](const WornFailureOf& f) { return ofWorst<std::string>(f, whereText); }},
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
