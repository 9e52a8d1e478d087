// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/format/table_writer.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

template <class T>
ordered_json orNull(const std::optional<T>& value) {
    return value ? ordered_json(*value) : ordered_json(nullptr);
}

ordered_json complianceJson(const GivenCompliance& compliance) {
    if (const auto* zones = std::get_if<ZoneCompliance>(&compliance)) {
        return {{"rz1", zones->rz1}, {"nz", zones->nz}, {"rz2", zones->rz2}};
    }
    const auto* sections = std::get_if<std::vector<double>>(&compliance);
    return sections ? ordered_json(*sections) : ordered_json(nullptr);
}

ordered_json levelsJson(const Levels& levels) {
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels)) {
        return {{"from", stepped->from}, {"to", stepped->to}, {"step", stepped->step}};
    }
    const auto* list = std::get_if<std::vector<double>>(&levels);
    return list ? ordered_json(*list) : ordered_json(nullptr);
}

ordered_json choiceJson(const Field& field, const void* owner) {
    return field.choices[static_cast<std::size_t>(field.getChoice(owner))].key;
}

ordered_json countOrWordJson(const Field& field, const void* owner) {
    if (const int* number = field.wholeNumber(owner)) {
        return *number;
    }
    return field.getChoice(owner) < 0 ? ordered_json(nullptr) : choiceJson(field, owner);
}

ordered_json listJson(const Field& field, const void* owner) {
    ordered_json list = ordered_json::array();
    for (std::size_t i = 0; i < field.size(owner); ++i) {
        list.push_back(writeByTable(*field.nested, field.itemIn(owner, i)));
    }
    return list;
}

ordered_json fieldJson(const Field& field, const void* owner) {
    switch (field.kind) {
    case Kind::number: return field.as<double>(owner);
    case Kind::optionalNumber: return orNull(field.as<std::optional<double>>(owner));
    case Kind::integer: return field.as<int>(owner);
    case Kind::optionalInteger: return orNull(field.as<std::optional<int>>(owner));
    case Kind::boolean: return field.as<bool>(owner);
    case Kind::text: return field.as<std::string>(owner);
    case Kind::choice: return choiceJson(field, owner);
    case Kind::numberList: return field.as<std::vector<double>>(owner);
    case Kind::optionalNumberList:
        return orNull(field.as<std::optional<std::vector<double>>>(owner));
    case Kind::object: return writeByTable(*field.nested, field.objectIn(owner));
    case Kind::optionalObject: {
        const void* object = field.objectIn(owner);
        return object ? writeByTable(*field.nested, object) : ordered_json(nullptr);
    }
    case Kind::objectList: return listJson(field, owner);
    case Kind::countOrWord: return countOrWordJson(field, owner);
    case Kind::compliance: return complianceJson(field.as<GivenCompliance>(owner));
    case Kind::levels: return levelsJson(field.as<Levels>(owner));
    case Kind::numberRows: return orNull(field.as<NumberRows>(owner));
    case Kind::samples: return field.as<Samples>(owner).values();
    case Kind::jsonText: // through json: in the order of the keys, as it is read again
        return nlohmann::json::parse(field.as<JsonText>(owner).text);
    }
    return nullptr;
}

/// Whether a member that older files lack has its default.
bool isDefault(const Field& field, const void* owner, const ordered_json& value,
               const StructInfo& table) {
    const bool holdsSparse = field.kind == Kind::object || field.kind == Kind::objectList;
    return holdsSparse ? value.empty() : field.same(owner, table.defaults);
}

} // namespace

ordered_json writeByTable(const StructInfo& table, const void* owner,
                          const std::vector<std::string>& skip) {
    ordered_json object = ordered_json::object();
    for (const Field& field : table.fields) {
        if (std::find(skip.begin(), skip.end(), field.key) != skip.end()) {
            continue;
        }
        ordered_json value = fieldJson(field, owner);
        // The table's defaults are written in full, for the reference page and the schema.
        if (field.sparse && owner != table.defaults && isDefault(field, owner, value, table)) {
            continue;
        }
        if (!value.is_null() || !fieldJson(field, table.defaults).is_null()) {
            object[field.key] = std::move(value);
        }
    }
    return object;
}

} // namespace sparkout
