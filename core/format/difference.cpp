// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/format/difference.h"

#include "core/project/project.h"

namespace sparkout {

namespace {

std::string difference(const StructInfo& table, const void* a, const void* b,
                       const std::string& path, InputFilter counts);

std::string difference(const Field& field, const void* a, const void* b, const std::string& path,
                       InputFilter counts) {
    if (!field.nested) {
        return field.same(a, b) ? std::string() : path;
    }
    if (field.kind != Kind::objectList) {
        const void* const ofA = field.objectIn(a);
        const void* const ofB = field.objectIn(b);
        if (ofA == ofB) {
            return {}; // shared, or not given in either
        }
        const bool both = ofA && ofB;
        return both ? difference(*field.nested, ofA, ofB, path, counts) : path;
    }
    if (field.size(a) != field.size(b)) {
        return path;
    }
    for (std::size_t i = 0; i < field.size(a); ++i) {
        const std::string item = path + "/" + std::to_string(i);
        if (std::string found =
                difference(*field.nested, field.itemIn(a, i), field.itemIn(b, i), item, counts);
            !found.empty()) {
            return found;
        }
    }
    return {};
}

std::string difference(const StructInfo& table, const void* a, const void* b,
                       const std::string& path, InputFilter counts) {
    for (const Field& field : table.fields) {
        const std::string at = path + "/" + field.key;
        if (counts && !counts(at)) {
            continue;
        }
        if (std::string found = difference(field, a, b, at, counts); !found.empty()) {
            return found;
        }
    }
    return {};
}

} // namespace

std::string firstDifference(const Project& a, const Project& b, InputFilter counts) {
    return difference(tableOf<Project>(), &a, &b, {}, counts);
}

} // namespace sparkout
