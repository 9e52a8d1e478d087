// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/json_schema.h"

#include "core/file/project_file.h"
#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/project/conditions.h"
#include "core/project/optimisation.h"
#include "core/setup/setup.h"
#include "core/setup/wheel_wear.h"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

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

ordered_json kindSchema(const Field& field) {
    const ordered_json null = {{"type", "null"}};
    switch (field.kind) {
    case Kind::number: return numberSchema(field);
    case Kind::optionalNumber: return orNull(numberSchema(field));
    case Kind::integer: return integerSchema(field);
    case Kind::optionalInteger: return orNull(integerSchema(field));
    case Kind::boolean: return {{"type", "boolean"}};
    case Kind::text: return {{"type", "string"}};
    case Kind::choice: return {{"type", "string"}, {"enum", choiceKeys(field)}};
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

/// Keys of a table that the reader requires only for some projects.
void addConditional(const StructInfo& table, const std::string& path, std::string& list) {
    for (const Field& field : table.fields) {
        const std::string here = path + "/" + field.key;
        if (field.required && !alwaysRequired(field)) {
            list += (list.empty() ? "" : ", ") + here;
        }
        if (field.nested) {
            addConditional(*field.nested, here + (field.kind == Kind::objectList ? "/N" : ""),
                           list);
        }
    }
}

/// Where the search requires whole numbers, which lists and levels of numbers do not express.
std::string wholeNumbers(Kind kind) {
    std::string list;
    for (const Field& field : tableOf<Optimisation>().fields) {
        if (field.whole && field.kind == kind) {
            list += (list.empty() ? "/optimisation/" : ", /optimisation/") + std::string(field.key);
        }
    }
    return list;
}

/// Constraints that the reader checks and the schema does not.
std::string gaps() {
    std::string conditional;
    addConditional(tableOf<Project>(), {}, conditional);
    return "The program refuses everything that this schema refuses, and also: keys that only some "
           "projects need ("
           + conditional
           + "); rules between values, such as a lower deviation that is not below the upper one, "
             "a "
             "ground length that leaves no zone between the reversals, a list with another number "
             "of values than sections, or a spark-out before the last stage; among the levels of "
           + wholeNumbers(Kind::levels) + " and in " + wholeNumbers(Kind::numberList)
           + " what is not a whole number; the "
             "inputs of a kept run, which are a project of their own, and its summary; a key given "
             "twice in one object; a number beyond the range of a double; a file of more than "
           + std::to_string(limits::fileBytes >> 20U) + " MB, " + std::to_string(limits::values)
           + " values or " + std::to_string(limits::depth) + " levels, a text of more than "
           + std::to_string(limits::stringBytes >> 10U)
           + " kB. sparkout-cli validate names each of them.";
}

/// An object of a project in a file of several surfaces: the shared half and the rest.
struct Halves {
    ordered_json shared, own;
};

/// A half of an object; a nested object is required if any of its members is.
class Half {
public:
    void add(const std::string& key, ordered_json schema, bool isRequired) {
        m_properties[key] = std::move(schema);
        if (isRequired) {
            m_required.push_back(key);
        }
    }
    void addObject(const std::string& key, const ordered_json& whole, ordered_json half,
                   bool isRequired) {
        const bool needed = isRequired && half.contains("required");
        if (!half.at("properties").empty()) {
            ordered_json schema = {{"title", whole.value("title", key)}};
            schema.update(half);
            add(key, std::move(schema), needed);
        }
    }
    [[nodiscard]] ordered_json schema() const { return closedObject(m_properties, m_required); }

private:
    ordered_json m_properties = ordered_json::object(), m_required = ordered_json::array();
};

Halves halvesOf(const ordered_json& object, const std::string& path) {
    const ordered_json required = object.value("required", ordered_json::array());
    Half shared, own;
    for (const auto& [key, schema] : object.at("properties").items()) {
        std::string at = path;
        at.append("/").append(key);
        const bool isRequired = std::find(required.begin(), required.end(), key) != required.end();
        if (isShared(at)) {
            shared.add(key, schema, isRequired);
        } else if (holdsShared(at)) {
            const Halves within = halvesOf(schema, at);
            shared.addObject(key, schema, within.shared, isRequired);
            own.addObject(key, schema, within.own, isRequired);
        } else {
            own.add(key, schema, isRequired);
        }
    }
    return {shared.schema(), own.schema()};
}

/// The schema of a file's object, with its format and version first.
ordered_json fileSchema(ordered_json object, int version) {
    ordered_json properties = {{"format", {{"const", "sparkout-project"}}},
                               {"version", {{"const", version}}}};
    properties.update(object.at("properties"));
    ordered_json required = {"format", "version"};
    for (const ordered_json& key : object.value("required", ordered_json::array())) {
        required.push_back(key);
    }
    return closedObject(std::move(properties), std::move(required));
}

ordered_json setupSchema(const ordered_json& project) {
    const Halves halves = halvesOf(project, {});
    ordered_json surface = halves.own;
    ordered_json named = {{"name", {{"title", "Name of the surface"}, {"type", "string"}}}};
    named.update(surface.at("properties"));
    surface["properties"] = std::move(named);
    ordered_json setup = halves.shared;
    setup["properties"]["times"] = objectSchema(tableOf<SetupTimes>());
    setup["properties"]["wear"] = objectSchema(tableOf<WheelWear>());
    setup["properties"]["surfaces"] = {{"title", "Surfaces, in the order they are ground in"},
                                       {"type", "array"},
                                       {"items", std::move(surface)},
                                       {"minItems", 1},
                                       {"maxItems", limits::surfaces}};
    setup["required"].push_back("surfaces");
    return fileSchema(std::move(setup), newestVersion);
}

} // namespace

bool alwaysRequired(const Field& field) {
    return field.required == conditions::always;
}

ordered_json orNull(ordered_json schema) {
    schema["type"] = {schema["type"], "null"};
    return schema;
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

std::string projectSchema() {
    const ordered_json project = objectSchema(tableOf<Project>());
    const ordered_json versionOfSetups = {{"properties", {{"version", {{"const", newestVersion}}}}},
                                          {"required", {"version"}}};
    const ordered_json root = {
        {"$schema", "https://json-schema.org/draft/2020-12/schema"},
        {"title", "Sparkout project"},
        {"description", gaps()},
        {"type", "object"},
        {"if", versionOfSetups},
        {"then", {{"$ref", "#/$defs/setup"}}},
        {"else", {{"$ref", "#/$defs/project"}}},
        {"$defs",
         {{"project", fileSchema(project, projectVersion)}, {"setup", setupSchema(project)}}}};
    return printJson(root);
}

} // namespace sparkout
