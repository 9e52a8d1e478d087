// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/member.h"

#include "core/project/project.h"

#include <cassert>
#include <charconv>

namespace sparkout {

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

enum class Missing { stop, create, defaults };

/// The struct below an object row in which a path continues; null if there is none. A struct that
/// is only read (`defaults`) stays shared with other projects.
void* descend(const Field& field, void* owner, std::string_view& path, Missing missing) {
    if (field.kind == Kind::object || field.kind == Kind::optionalObject) {
        return missing == Missing::defaults ? const_cast<void*>(field.objectIn(owner))
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

Member walk(Project& project, std::string_view path, Missing missing, const Field** nearest) {
    const StructInfo* table = &tableOf<Project>();
    void* owner = &project;
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
    return walk(project, path, create ? Missing::create : Missing::stop, nullptr);
}

ConstMember findMember(const Project& project, std::string_view path) {
    const Member member =
        walk(const_cast<Project&>(project), path, Missing::defaults, nullptr); // never written to
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
    walk(const_cast<Project&>(project), path, Missing::defaults, &nearest); // never written to
    return nearest;
}

} // namespace sparkout
