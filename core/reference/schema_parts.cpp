// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reference/schema_parts.h"

#include "core/format/table_writer.h"
#include "core/project/conditions.h"

#include <cmath>
#include <initializer_list>
#include <utility>

namespace sparkout {

using nlohmann::ordered_json;

namespace {

ordered_json withRange(ordered_json schema, const Range& range) {
    if (std::isfinite(range.low)) {
        schema[range.lowOpen ? "exclusiveMinimum" : "minimum"] = range.low;
    }
    if (std::isfinite(range.high)) {
        schema["maximum"] = range.high;
    }
    return schema;
}

ordered_json numberSchema(const Field& field) {
    return withRange({{"type", "number"}}, field.hard);
}
ordered_json integerSchema(const Field& field) {
    return withRange({{"type", "integer"}}, field.hard);
}

ordered_json numbersSchema(const Field& field) {
    ordered_json schema = {{"type", "array"}, {"items", numberSchema(field)}};
    if (field.count != 0) {
        schema["minItems"] = field.count;
        schema["maxItems"] = field.count;
    }
    return schema;
}

/// An object whose keys all have numbers in the field's range.
ordered_json numbersByName(const Field& field, std::initializer_list<const char*> keys) {
    ordered_json properties = ordered_json::object();
    ordered_json required = ordered_json::array();
    for (const char* key : keys) {
        properties[key] = numberSchema(field);
        required.push_back(key);
    }
    return closedObject(std::move(properties), std::move(required));
}

ordered_json anyOf(std::initializer_list<ordered_json> schemas) {
    ordered_json list = ordered_json::array();
    for (const ordered_json& schema : schemas) {
        list.push_back(schema);
    }
    return {{"anyOf", std::move(list)}};
}

ordered_json orNull(ordered_json schema) {
    schema["type"] = {schema["type"], "null"};
    return schema;
}

ordered_json listSchema(const Field& field) {
    ordered_json schema = {{"type", "array"}, {"items", objectSchema(*field.nested)}};
    if (!field.hard.unbounded()) {
        schema["minItems"] = static_cast<int>(field.hard.low);
        schema["maxItems"] = static_cast<int>(field.hard.high);
    }
    return schema;
}

ordered_json choiceKeys(const Field& field) {
    ordered_json keys = ordered_json::array();
    for (const Choice& choice : field.choices) {
        keys.push_back(choice.key);
    }
    return keys;
}

ordered_json choiceSchema(const Field& field) {
    return {{"type", "string"}, {"enum", choiceKeys(field)}};
}

ordered_json kindSchema(const Field& field) {
    const ordered_json null = {{"type", "null"}};
    switch (field.kind) {
    case Kind::number: return numberSchema(field);
    case Kind::optionalNumber: return orNull(numberSchema(field));
    case Kind::integer: return integerSchema(field);
    case Kind::optionalInteger: return orNull(integerSchema(field));
    case Kind::boolean: return {{"type", "boolean"}};
    case Kind::text: return {{"type", "string"}};
    case Kind::choice: return choiceSchema(field);
    case Kind::numberList:
    case Kind::samples: return numbersSchema(field);
    case Kind::optionalNumberList: return orNull(numbersSchema(field));
    case Kind::object: return objectSchema(*field.nested);
    case Kind::optionalObject: return orNull(objectSchema(*field.nested));
    case Kind::objectList: return listSchema(field);
    case Kind::countOrWord:
        return anyOf({integerSchema(field), {{"enum", choiceKeys(field)}}, null});
    case Kind::compliance:
        return anyOf({numbersByName(field, {"rz1", "nz", "rz2"}), numbersSchema(field), null});
    case Kind::levels:
        return anyOf({numbersSchema(field), numbersByName(field, {"from", "to", "step"}), null});
    case Kind::numberRows: return orNull({{"type", "array"}, {"items", numbersSchema(field)}});
    case Kind::jsonText: return {{"type", "object"}};
    }
    return {};
}

std::string description(const Field& field) {
    std::string text = field.hint;
    const auto append = [&](const std::string& sentence) {
        text += (text.empty() ? "" : " ") + sentence;
    };
    if (*field.unit) {
        append("[" + std::string(field.unit) + "]");
    }
    if (*field.nullMeaning) {
        append("null: " + std::string(field.nullMeaning) + ".");
    }
    return text;
}

ordered_json fieldSchema(const Field& field, const ordered_json& defaults) {
    ordered_json schema = {{"title", field.label}};
    if (const std::string text = description(field); !text.empty()) {
        schema["description"] = text;
    }
    schema.update(kindSchema(field));
    if (!field.nested && !alwaysRequired(field)) {
        const auto found = defaults.find(field.key);
        schema["default"] = found == defaults.end() ? ordered_json(nullptr) : *found;
    }
    return schema;
}

} // namespace

bool alwaysRequired(const Field& field) {
    return field.required == conditions::always;
}

ordered_json closedObject(ordered_json properties, ordered_json required) {
    ordered_json schema = {{"type", "object"}, {"properties", std::move(properties)}};
    if (!required.empty()) {
        schema["required"] = std::move(required);
    }
    schema["additionalProperties"] = false;
    return schema;
}

ordered_json objectSchema(const StructInfo& table) {
    const ordered_json defaults = writeByTable(table, table.defaults);
    ordered_json properties = ordered_json::object();
    ordered_json required = ordered_json::array();
    for (const Field& field : table.fields) {
        properties[field.key] = fieldSchema(field, defaults);
        if (alwaysRequired(field)) {
            required.push_back(field.key);
        }
    }
    return closedObject(std::move(properties), std::move(required));
}

} // namespace sparkout
