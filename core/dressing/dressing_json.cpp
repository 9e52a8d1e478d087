// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dressing/dressing_json.h"

#include "core/project/optimisation.h"
#include "core/quality/result_names.h"

#include <nlohmann/json.hpp>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

ordered_json bestJson(const std::optional<BestInterval>& best, const char* value) {
    return best ? ordered_json{{"parts", best->parts}, {value, best->value}}
                : ordered_json(nullptr);
}

ordered_json endJson(const Setup& setup, const DressingInterval& interval) {
    if (!interval.end) {
        return nullptr;
    }
    const WornFailure& end = *interval.end;
    ordered_json json = {{"part", end.part},
                         {"surface", setup.surfaces[end.surface].name},
                         {"scenario", end.scenario ? ordered_json(*end.scenario) : nullptr},
                         {"status", end.issues.empty() ? statusKey(end.status) : "refused"},
                         {"requirement", nullptr},
                         {"where", nullptr},
                         {"value", nullptr},
                         {"limit", nullptr}};
    if (end.worst) {
        json["requirement"] = requirementOf(end.worst->kind).key;
        json["where"] = whereText(*end.worst);
        json["value"] = end.worst->value;
        json["limit"] = end.worst->limit;
    }
    return json;
}

} // namespace

BestIntervals bestIntervals(const Setup& setup, const DressingInterval& interval) {
    const Cost* const rates = ratesOf(setup);
    if (!rates) {
        return {};
    }
    return {quickestInterval(interval, rates->dressing_s), cheapestInterval(interval, *rates)};
}

std::string dressingJson(const Setup& setup, const DressingInterval& interval) {
    const BestIntervals best = bestIntervals(setup, interval);
    const ordered_json json = {{"parts", interval.parts},
                               {"endless", interval.isEndless},
                               {"at_least", !interval.end && !interval.isEndless},
                               {"part_volume_mm3", interval.partVolume_mm3},
                               {"runs", interval.tried},
                               {"ends_by", endJson(setup, interval)},
                               {"quickest", bestJson(best.quickest, "time_s")},
                               {"cheapest", bestJson(best.cheapest, "cost")}};
    return json.dump(2) + '\n';
}

} // namespace sparkout
