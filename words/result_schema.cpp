// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/result_schema.h"

#include "core/batch/batch_outputs.h"
#include "core/batch/sweep_run.h"
#include "core/file/strict_json.h"
#include "core/measured/adequacy.h"
#include "core/phases/phase_decision.h"
#include "core/quality/constraints.h"
#include "core/quality/result_json.h"
#include "core/quality/shop_numbers.h"
#include "core/quality/waviness_outputs.h"
#include "core/setup/dressing_interval.h"
#include "core/setup/setup_run.h"
#include "core/study/remedies.h"
#include "core/study/search_outputs.h"
#include "words/json_schema.h"
#include "words/judgement_words.h"
#include "words/measured_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <map>
#include <span>
#include <sstream>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

ordered_json interval() {
    return {{"type", "array"}, {"items", {{"type", "number"}}}, {"minItems", 2}, {"maxItems", 2}};
}

ordered_json objectOf(ordered_json properties) {
    ordered_json required = ordered_json::array();
    for (const auto& [key, schema] : properties.items()) {
        required.push_back(key);
    }
    return {{"type", "object"},
            {"properties", std::move(properties)},
            {"required", std::move(required)}};
}

ordered_json typeOf(OutputKind kind) {
    switch (kind) {
    case OutputKind::number: return {{"type", "number"}};
    case OutputKind::optionalNumber: return orNull({{"type", "number"}});
    case OutputKind::whole: return {{"type", "integer"}};
    case OutputKind::optionalWhole: return orNull({{"type", "integer"}});
    case OutputKind::truth: return {{"type", "boolean"}};
    case OutputKind::optionalTruth: return orNull({{"type", "boolean"}});
    case OutputKind::text: return {{"type", "string"}};
    case OutputKind::optionalText: return orNull({{"type", "string"}});
    case OutputKind::interval: return orNull(interval());
    case OutputKind::estimate:
        return orNull(objectOf({{"value", {{"type", "number"}}}, {"interval_95", interval()}}));
    case OutputKind::share: break;
    }
    return orNull(objectOf({{"count", {{"type", "integer"}}},
                            {"share", {{"type", "number"}}},
                            {"interval_95", orNull(interval())}}));
}

template <class Owner>
ordered_json tableSchema(const char* title, std::span<const Output<Owner>> rows) {
    ordered_json properties = ordered_json::object(), required = ordered_json::array();
    for (const Output<Owner>& row : rows) {
        if (!*row.key) {
            continue;
        }
        ordered_json& schema = properties[row.key] = typeOf(row.kind());
        if (const std::string text = descriptionOf(row); !text.empty()) {
            schema["description"] = text;
        }
        if (!row.stated) {
            required.push_back(row.key);
        }
    }
    return {{"title", title},
            {"type", "object"},
            {"properties", std::move(properties)},
            {"required", std::move(required)}};
}

/// A schema for each table of outputs.
ordered_json tableSchemas() {
    return {
        {"stage",
         tableSchema("simulate: a stage of shop/stages, and the cycle", shopColumnOutputs())},
        {"shop", tableSchema("simulate: shop", shopOutputs())},
        {"requirement", tableSchema("simulate and remedies: a requirement", requirementOutputs())},
        {"judged", tableSchema("simulate: judged", judgementOutputs())},
        {"judged_stocks", tableSchema("simulate: stocks of judged", judgedStocksOutputs())},
        {"judged_batch", tableSchema("simulate: batch of judged", judgedBatchOutputs())},
        {"measured_bias", tableSchema("simulate: measured of judged", measuredBiasOutputs())},
        {"undecided", tableSchema("simulate and optimize: one of not_decided", undecidedOutputs())},
        {"position", tableSchema("simulate: position of a zone or section", positionOutputs())},
        {"zone", tableSchema("simulate: a zone, or one of sections", zoneOutputs())},
        {"even_lobes",
         tableSchema("simulate: a zone or section, lobes not known", evenLobesOutputs())},
        {"zone_form", tableSchema("simulate: a zone with several sections", zoneFormOutputs())},
        {"zone_section", tableSchema("simulate: one of sections of a zone", zoneSectionOutputs())},
        {"part_form", tableSchema("simulate: part", partOutputs())},
        {"burn", tableSchema("simulate: burn", burnOutputs())},
        {"waviness", tableSchema("simulate: waviness of a zone or section", wavinessOutputs())},
        {"characteristic", tableSchema("batch: one of characteristics", characteristicOutputs())},
        {"search", tableSchema("optimize", searchOutputs())},
        {"remedies", tableSchema("remedies", remedyResultOutputs())},
        {"remedy", tableSchema("remedies: one of remedies", remedyOutputs())},
        {"remedy_batch", tableSchema("remedies: batch of one of remedies", remedyBatchOutputs())},
        {"remedy_phases",
         tableSchema("remedies: phases of one of remedies", remedyPhasesOutputs())},
        {"remedy_conflict", tableSchema("remedies: conflict", remedyConflictOutputs())},
        {"adequacy", tableSchema("measured: one of adequacy", adequacyOutputs())},
        {"predicted", tableSchema("measured: predicted", predictedOutputs())},
        {"variance_ratio", tableSchema("measured: variance_ratio", varianceRatioOutputs())},
        {"inside", tableSchema("measured: inside", insideShareOutputs())},
        {"identification", tableSchema("measured: identification", identificationOutputs())},
        {"fitted_value", tableSchema("measured: one of values", fittedValueOutputs())},
        {"residuals", tableSchema("measured: one of residuals", fitResidualsOutputs())},
        {"force_law", tableSchema("measured: force_law", forceLawOutputs())},
        {"hold_out", tableSchema("measured: one of hold_out", holdOutOutputs())},
        {"out_of_step", tableSchema("measured: one of out_of_step", outOfStepOutputs())},
        {"part", tableSchema("simulate: part of a file of several surfaces", setupOutputs())},
        {"dressing", tableSchema("dressing", dressingOutputs())},
        {"worn_failure", tableSchema("dressing: ends_by", wornFailureOutputs())},
        {"quickest_interval", tableSchema("dressing: quickest", quickestIntervalOutputs())},
        {"cheapest_interval", tableSchema("dressing: cheapest", cheapestIntervalOutputs())},
        {"phases", tableSchema("phases", phasesOutputs())},
        {"phase_piece", tableSchema("phases: one of pieces", phasePieceOutputs())},
        {"failing_stocks", tableSchema("phases: one of failing", failingStocksOutputs())},
        {"phase_worst",
         tableSchema("phases: worst of a piece, or of failing", phaseWorstOutputs())},
        {"sweep", tableSchema("sweep", sweepOutputs())},
        {"swept_input", tableSchema("sweep: one of inputs", sweptInputOutputs())},
        {"sweep_point", tableSchema("sweep: one of points", sweepPointOutputs())},
        {"sweep_result", tableSchema("sweep: one of results of a point", sweepFigureOutputs())},
    };
}

/// The stub type for an output's schema: "Optional[float]".
std::string stubType(const ordered_json& schema, bool isRequired) {
    static const std::map<std::string, std::string> types{{"number", "float"},
                                                          {"integer", "int"},
                                                          {"boolean", "bool"},
                                                          {"string", "str"},
                                                          {"array", "tuple[float, float]"},
                                                          {"object", "tuple[Any, ...]"}};
    const ordered_json& type = schema["type"];
    const std::string& known = types.at(type.is_array() ? type[0] : type);
    return isRequired && !type.is_array() ? known : "Optional[" + known + ']';
}

bool isRequired(const ordered_json& table, const std::string& key) {
    const ordered_json& required = table["required"];
    return std::find(required.begin(), required.end(), key) != required.end();
}

/// The attributes of a table.
std::string attributeStubs(const ordered_json& table) {
    std::string text;
    for (const auto& [key, schema] : table["properties"].items()) {
        text += "    @property\n    def " + key + "(self) -> "
                + stubType(schema, isRequired(table, key)) + ':';
        text += schema.contains("description")
                    ? "\n        \"\"\"" + schema["description"].get<std::string>() + "\"\"\"\n"
                    : " ...\n";
    }
    return text;
}

/// The items of a dict that has a table's outputs.
std::string itemStubs(const ordered_json& table) {
    std::string text;
    for (const auto& [key, schema] : table["properties"].items()) {
        text += "    " + key + ": " + stubType(schema, isRequired(table, key)) + '\n';
    }
    return text;
}

} // namespace

std::string descriptionOf(const OutputRow& row) {
    std::string text = *row.label ? row.label : row.hint;
    if (*row.unit) {
        text += (text.empty() ? "[" : " [") + std::string(row.unit) + ']';
    }
    return *row.label ? text + '.' + (*row.hint ? " " : "") + row.hint : text;
}

std::string resultSchema() {
    return printJson({{"$schema", "https://json-schema.org/draft/2020-12/schema"},
                      {"title", "Results of Sparkout"},
                      {"description", "The output of the command line with --json, table by table. "
                                      "Objects may have more keys than these."},
                      {"$defs", tableSchemas()}});
}

std::string resultStubs(const std::string& byHand) {
    const std::string attributes = "    # outputs: ", items = "    # items: ";
    const ordered_json tables = tableSchemas();
    std::string text;
    std::istringstream lines(byHand);
    for (std::string line; std::getline(lines, line);) {
        text += line.starts_with(attributes)
                    ? attributeStubs(tables.at(line.substr(attributes.size())))
                : line.starts_with(items) ? itemStubs(tables.at(line.substr(items.size())))
                                          : line + '\n';
    }
    return text;
}

} // namespace sparkout
