// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/measured_json.h"

#include "core/project/part.h"
#include "core/quality/result_names.h"
#include "words/measured_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

ordered_json limitsJson(const std::optional<Interval>& interval) {
    return interval ? ordered_json{interval->low, interval->high} : ordered_json(nullptr);
}

ordered_json rowJson(const Project& project, const AdequacyRow& row) {
    const MeasuredStatistics& parts = row.measured;
    ordered_json json = {{"quantity", keyOf(parts.quantity)},
                         {"where", placeName(project, parts.place)},
                         {"summary", parts.isSummary},
                         {"count", parts.count},
                         {"mean_um", parts.mean},
                         {"mean_95_um", limitsJson(row.mean95)},
                         {"deviation_um", nullptr},
                         {"predicted", nullptr},
                         {"bias_95_um", limitsJson(row.bias95)},
                         {"variance_ratio", nullptr},
                         {"inside", nullptr},
                         {"verdict", wordsOf(row.verdict).key}};
    if (parts.deviation) {
        json["deviation_um"] = *parts.deviation;
    }
    if (row.predicted) {
        json["predicted"] = {{"count", row.predicted->count},
                             {"mean_um", row.predicted->mean},
                             {"low_um", row.predicted->low},
                             {"high_um", row.predicted->high}};
        if (row.predicted->deviation) {
            json["predicted"]["deviation_um"] = *row.predicted->deviation;
        }
    }
    if (row.scatter) {
        json["variance_ratio"] = {{"value", row.scatter->ratio},
                                  {"low", row.scatter->low},
                                  {"high", row.scatter->high},
                                  {"probability", row.scatter->probability}};
    }
    if (row.share) {
        json["inside"] = {{"count", row.share->inside},
                          {"of", row.share->count},
                          {"interval_95", limitsJson(row.share->interval)}};
    }
    return json;
}

ordered_json fitJson(const Identification& found, const std::vector<FittedParameter>& requested) {
    ordered_json json = {
        {"status", wordsOf(found.status).key},  {"values", ordered_json::array()},
        {"correlation", found.correlation},     {"condition", nullptr},
        {"residuals", ordered_json::array()},   {"normality_probability", nullptr},
        {"in_doubt", found.isInDoubt()},        {"out_of_step", ordered_json::array()},
        {"cannot_tell", ordered_json::array()}, {"measured_values", found.count}};
    for (const FittedValue& value : found.values) {
        json["values"].push_back({{"parameter", parameterName(value.parameter)},
                                  {"value", value.value},
                                  {"unit", unitOf(value.parameter.kind)},
                                  {"interval_95", limitsJson(value.interval95)}});
    }
    if (std::isfinite(found.condition)) {
        json["condition"] = found.condition;
    }
    for (const FitResiduals& group : found.residuals) {
        json["residuals"].push_back(
            {{"source", wordsOf(group.source).key},
             {"trace", group.trace},
             {"count", group.values.size()},
             {"rms", group.rms},
             {"noise", group.noise ? ordered_json(*group.noise) : ordered_json(nullptr)},
             {"in_doubt", group.isInDoubt()},
             {"unit", unitOf(group.source)}});
    }
    if (found.normality) {
        json["normality_probability"] = found.normality->probability;
    }
    for (const OutOfStep& one : found.outOfStep) {
        json["out_of_step"].push_back({{"parameter", wordsOf(one.kind).key},
                                       {"value", one.delay_s},
                                       {"error", one.error_s},
                                       {"unit", unitOf(one.kind)},
                                       {"moves", parameterName(requested[one.parameter])},
                                       {"to", one.value}});
    }
    for (const Unidentified& one : found.unidentified) {
        ordered_json names = ordered_json::array();
        for (const std::size_t i : one.parameters) {
            names.push_back(parameterName(requested[i]));
        }
        json["cannot_tell"].push_back(
            {{"parameters", std::move(names)}, {"measure", wordsOf(one.advice).key}});
    }
    return json;
}

} // namespace

std::optional<std::vector<FittedParameter>> fittedParametersOf(const std::string& text) {
    std::vector<FittedParameter> found;
    for (std::size_t from = 0; from <= text.size();) {
        const std::size_t end = std::min(text.find(',', from), text.size());
        std::string key = text.substr(from, end - from);
        from = end + 1;
        FittedParameter parameter;
        bool isKnown = true;
        if (const std::size_t colon = key.find(':'); colon != std::string::npos) {
            int place = -1;
            const char* const last = key.data() + key.size();
            const auto [read, error] = std::from_chars(key.data() + colon + 1, last, place);
            isKnown = error == std::errc() && read == last && place >= 0;
            parameter.place = place;
            key.resize(colon);
        }
        int kind = 0;
        while (kind < static_cast<int>(FittedKind::count_)
               && key != keyOf(static_cast<FittedKind>(kind))) {
            ++kind;
        }
        parameter.kind = static_cast<FittedKind>(kind);
        if (!isKnown || parameter.kind == FittedKind::count_) {
            return std::nullopt;
        }
        found.push_back(parameter);
    }
    return found;
}

std::string parameterName(const FittedParameter& parameter) {
    const std::string key = keyOf(parameter.kind);
    return parameter.place ? key + ':' + std::to_string(*parameter.place) : key;
}

std::string knownParameters() {
    std::string known;
    for (int kind = 0; kind < static_cast<int>(FittedKind::count_); ++kind) {
        known += (known.empty() ? "" : ", ") + std::string(keyOf(static_cast<FittedKind>(kind)));
    }
    return known;
}

const char* keyOf(MeasuredQuantity quantity) {
    return choicesOf<MeasuredQuantity>()[static_cast<std::size_t>(quantity)].key;
}

std::string placeName(const Project& project, int place) {
    return sectionOrPart(project.operation->hasZones && place >= 0 ? static_cast<Zone>(place)
                                                                   : Zone::section,
                         place);
}

std::string measuredJson(const Project& project, const MeasuredAnswer& answer) {
    ordered_json json = {{"adequacy", ordered_json::array()}, {"identification", nullptr}};
    for (const AdequacyRow& row : answer.rows) {
        json["adequacy"].push_back(rowJson(project, row));
    }
    if (answer.fit) {
        json["identification"] = fitJson(*answer.fit, answer.parameters);
    }
    return json.dump(2) + '\n';
}

} // namespace sparkout
