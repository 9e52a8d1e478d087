// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/member.h"

#include "core/project/project.h"

#include <cassert>
#include <charconv>

namespace sparkout {

namespace {

void collectLeaves(const StructInfo& table, const void* owner, const std::string& path,
                   std::vector<Leaf>& leaves) {
    for (const Field& field : table.fields) {
        const std::string here = path + "/" + field.key;
        if (field.kind == Kind::objectList) {
            leaves.push_back({here, &field, owner});
            for (std::size_t i = 0; i < field.size(owner); ++i) {
                collectLeaves(*field.nested, field.itemIn(owner, i), here + "/" + std::to_string(i),
                              leaves);
            }
        } else if (const void* const object = field.nested ? field.objectIn(owner) : nullptr) {
            collectLeaves(*field.nested, object, here, leaves);
        } else {
            leaves.push_back({here, &field, owner});
        }
    }
}

} // namespace

std::vector<Leaf> leavesOf(const StructInfo& table, const void* owner) {
    std::vector<Leaf> leaves;
    collectLeaves(table, owner, {}, leaves);
    return leaves;
}

namespace {

/// Removes the first key from a path.
std::string_view takeKey(std::string_view& path) {
    if (path.starts_with('/')) {
        path.remove_prefix(1);
    }
    const std::size_t end = path.find('/');
    const std::string_view key = path.substr(0, end);
    path.remove_prefix(end == std::string_view::npos ? path.size() : end);
    return key;
}

/// The treatment of a struct that is not given; with the last two nothing is written.
enum class Missing { stop, create, defaults, none };

/// The struct in which a path continues below an object row; null if there is none. A struct that
/// is only read stays shared with other projects.
void* descend(const Field& field, void* owner, std::string_view& path, Missing missing) {
    if (field.kind == Kind::object || field.kind == Kind::optionalObject) {
        return missing == Missing::defaults || missing == Missing::none
                   ? const_cast<void*>(field.objectIn(owner))
                   : field.object(owner, missing == Missing::create);
    }
    if (field.kind != Kind::objectList) {
        return nullptr;
    }
    const std::string_view key = takeKey(path);
    std::size_t index = 0;
    const auto [end, error] = std::from_chars(key.data(), key.data() + key.size(), index);
    const bool read = error == std::errc{} && end == key.data() + key.size();
    return read && index < field.size(owner) ? field.at(owner, index) : nullptr;
}

Member walk(const StructInfo* table, void* owner, std::string_view path, Missing missing,
            const Field** nearest = nullptr) {
    while (true) {
        const Field* const field = table->find(takeKey(path));
        if (!field) {
            return {};
        }
        if (nearest) {
            *nearest = field;
        }
        if (path.empty()) {
            return {field, owner};
        }
        if (!field->nested) {
            return {};
        }
        owner = descend(*field, owner, path, missing);
        if (!owner && missing == Missing::defaults && field->kind == Kind::optionalObject) {
            owner = const_cast<void*>(field->nested->defaults); // never written to
        }
        if (!owner) {
            return {};
        }
        table = field->nested;
        if (path.empty()) {
            return {field, owner};
        }
    }
}

} // namespace

Member findMember(Project& project, std::string_view path, bool create) {
    return walk(&tableOf<Project>(), &project, path, create ? Missing::create : Missing::stop);
}

ConstMember findMember(const Project& project, std::string_view path) {
    const Member member = walk(&tableOf<Project>(), const_cast<Project*>(&project), path,
                               Missing::defaults); // only read from
    return {member.field, member.owner};
}

Member memberIn(const StructInfo& table, void* root, std::string_view path) {
    return walk(&table, root, path, Missing::stop);
}

ConstMember memberIn(const StructInfo& table, const void* root, std::string_view path) {
    const Member member = walk(&table, const_cast<void*>(root), path, Missing::none); // only read
    return {member.field, member.owner};
}

std::optional<double> numberIn(const Field& field, const void* owner) {
    switch (field.kind) {
    case Kind::number: return field.as<double>(owner);
    case Kind::integer: return field.as<int>(owner);
    case Kind::optionalInteger: {
        const auto& value = field.as<std::optional<int>>(owner);
        return value ? std::optional<double>(*value) : std::nullopt;
    }
    default: assert(field.kind == Kind::optionalNumber);
    }
    return field.as<std::optional<double>>(owner);
}

void setNumberIn(const Field& field, void* owner, std::optional<double> value) {
    switch (field.kind) {
    case Kind::number: field.as<double>(owner) = value.value_or(0); return;
    case Kind::integer: field.as<int>(owner) = static_cast<int>(value.value_or(0)); return;
    case Kind::optionalInteger:
        field.as<std::optional<int>>(owner) =
            value ? std::optional<int>(static_cast<int>(*value)) : std::nullopt;
        return;
    default: assert(field.kind == Kind::optionalNumber);
    }
    field.as<std::optional<double>>(owner) = value;
}

const Field* nearestField(const Project& project, std::string_view path) {
    const Field* nearest = nullptr;
    walk(&tableOf<Project>(), const_cast<Project*>(&project), path, Missing::defaults,
         &nearest); // only read from
    return nearest;
}

} // namespace sparkout
