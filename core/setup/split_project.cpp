// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/split_project.h"

#include "core/setup/setup.h"

#include <string>
#include <utility>

namespace sparkout {

namespace {

void split(const nlohmann::ordered_json& object, const std::string& path, SplitProject& into) {
    for (const auto& [key, value] : object.items()) {
        std::string at = path;
        at.append("/").append(key);
        if (isShared(at)) {
            into.shared[key] = value;
        } else if (holdsShared(at) && value.is_object()) {
            SplitProject within;
            split(value, at, within);
            if (!within.shared.empty()) {
                into.shared[key] = std::move(within.shared);
            }
            if (!within.own.empty()) {
                into.own[key] = std::move(within.own);
            }
        } else {
            into.own[key] = value;
        }
    }
}

} // namespace

SplitProject splitProject(const nlohmann::ordered_json& project) {
    SplitProject parts;
    split(project, {}, parts);
    return parts;
}

nlohmann::json joinProject(const nlohmann::json& shared, const nlohmann::json& own) {
    nlohmann::json joined = shared;
    for (const auto& [key, value] : own.items()) {
        const auto there = joined.find(key);
        const bool both = there != joined.end() && there->is_object() && value.is_object();
        joined[key] = both ? joinProject(*there, value) : value;
    }
    return joined;
}

} // namespace sparkout
