// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reference/result_schema.h"

#include "core/batch/batch_outputs.h"
#include "core/format/strict_json.h"
#include "core/quality/form_outputs.h"
#include "core/quality/requirement_outputs.h"
#include "core/quality/shop_outputs.h"
#include "core/study/search_outputs.h"

#include <nlohmann/json.hpp>

#include <span>

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

ordered_json orNull(ordered_json schema) {
    schema["type"] = {schema["type"], "null"};
    return schema;
}

ordered_json typeOf(OutputKind kind) {
    switch (kind) {
    case OutputKind::number: return {{"type", "number"}};
    case OutputKind::optionalNumber: return orNull({{"type", "number"}});
    case OutputKind::whole: return {{"type", "integer"}};
    case OutputKind::truth: return orNull({{"type", "boolean"}});
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

/// "Stepless limit [min]. What it is."
std::string descriptionOf(const OutputRow& row) {
    std::string text = row.label;
    text += *row.unit ? " [" + std::string(row.unit) + "]" : "";
    text += text.empty() ? "" : ".";
    return *row.hint ? text + (text.empty() ? "" : " ") + row.hint : text;
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

} // namespace

std::string resultSchema() {
    const ordered_json schema = {
        {"$schema", "https://json-schema.org/draft/2020-12/schema"},
        {"title", "Results of Sparkout"},
        {"description", "What the command line states with --json, table by table. Objects may "
                        "have more keys than these."},
        {"$defs",
         {{"stage",
           tableSchema("simulate: a stage of shop/stages, and the cycle", shopColumnOutputs())},
          {"shop", tableSchema("simulate: shop", shopOutputs())},
          {"requirement",
           tableSchema("simulate and remedies: a requirement", requirementOutputs())},
          {"zone_form",
           tableSchema("simulate: a zone of several sections, beside the worst of them",
                       zoneFormOutputs())},
          {"characteristic", tableSchema("batch: one of characteristics", characteristicOutputs())},
          {"search", tableSchema("optimize", searchOutputs())}}}};
    return printJson(schema);
}

} // namespace sparkout
