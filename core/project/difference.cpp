// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/difference.h"

#include "core/project/project.h"

namespace sparkout {

namespace {

template <class T>
bool same(const Field& field, const void* a, const void* b) {
    return field.as<T>(a) == field.as<T>(b);
}

/// Of a member that is a value.
bool sameValue(const Field& field, const void* a, const void* b) {
    switch (field.kind) {
    case Kind::number: return same<double>(field, a, b);
    case Kind::optionalNumber: return same<std::optional<double>>(field, a, b);
    case Kind::integer: return same<int>(field, a, b);
    case Kind::optionalInteger: return same<std::optional<int>>(field, a, b);
    case Kind::boolean: return same<bool>(field, a, b);
    case Kind::text: return same<std::string>(field, a, b);
    case Kind::choice: return field.getChoice(a) == field.getChoice(b);
    case Kind::numberList: return same<std::vector<double>>(field, a, b);
    case Kind::optionalNumberList: return same<std::optional<std::vector<double>>>(field, a, b);
    case Kind::sparkOut: return same<SparkOut>(field, a, b);
    case Kind::compliance: return same<GivenCompliance>(field, a, b);
    case Kind::levels: return same<Levels>(field, a, b);
    case Kind::numberRows: return same<NumberRows>(field, a, b);
    case Kind::jsonText: return same<JsonText>(field, a, b);
    case Kind::object:
    case Kind::optionalObject:
    case Kind::objectList: break;
    }
    return true;
}

std::string difference(const StructInfo& table, const void* a, const void* b,
                       const std::string& path);

std::string difference(const Field& field, const void* a, const void* b, const std::string& path) {
    if (!field.nested) {
        return sameValue(field, a, b) ? std::string() : path;
    }
    if (field.kind != Kind::objectList) {
        const void* const ofA = field.objectIn(a);
        const void* const ofB = field.objectIn(b);
        const bool both = ofA && ofB;
        return both ? difference(*field.nested, ofA, ofB, path) : ofA || ofB ? path : std::string();
    }
    if (field.size(a) != field.size(b)) {
        return path;
    }
    for (std::size_t i = 0; i < field.size(a); ++i) {
        const std::string item = path + "/" + std::to_string(i);
        if (std::string found =
                difference(*field.nested, field.itemIn(a, i), field.itemIn(b, i), item);
            !found.empty()) {
            return found;
        }
    }
    return {};
}

std::string difference(const StructInfo& table, const void* a, const void* b,
                       const std::string& path) {
    for (const Field& field : table.fields) {
        if (std::string found = difference(field, a, b, path + "/" + field.key); !found.empty()) {
            return found;
        }
    }
    return {};
}

} // namespace

std::string firstDifference(const Project& a, const Project& b) {
    return difference(tableOf<Project>(), &a, &b, {});
}

} // namespace sparkout
