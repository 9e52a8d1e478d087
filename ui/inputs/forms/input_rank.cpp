// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/inputs/forms/input_rank.h"

#include "core/measured/calibrated_inputs.h"
#include "core/project/member.h"
#include "ui/text/field_text.h"

#include <algorithm>

namespace sparkout {

namespace {

bool isAsIn(const Project& other, const Field& field, const void* owner, const std::string& path) {
    const ConstMember there = findMember(other, path);
    if (!there) {
        return false;
    }
    switch (field.kind) {
    case Kind::optionalObject:
        if (!field.objectIn(owner) || !field.objectIn(there.owner)) {
            return !field.objectIn(owner) && !field.objectIn(there.owner);
        }
        [[fallthrough]];
    case Kind::object:
        return std::ranges::all_of(field.nested->fields, [&](const Field& member) {
            return isAsIn(other, member, field.objectIn(owner), path + '/' + member.key);
        });
    case Kind::objectList: return field.size(owner) == field.size(there.owner);
    default: return field.same(owner, there.owner);
    }
}

} // namespace

bool InputRank::isNews(const Project& project, const std::string& path) const {
    const bool isWanted = std::ranges::any_of(wanted, [&path](const std::string& one) {
        return one == path || one.starts_with(path + '/') || path.starts_with(one + '/');
    });
    if (isWanted || calibrationOf(project, path)) {
        return true;
    }
    const ConstMember member = findMember(project, path);
    return member && !isAsNew(*member.field, member.owner)
           && !(asCatalogue && isAsIn(*asCatalogue, *member.field, member.owner, path));
}

} // namespace sparkout
