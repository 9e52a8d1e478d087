// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/shared_members.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>

namespace sparkout {

namespace {

constexpr std::array<std::string_view, 21> members{"/title",
                                                   "/author",
                                                   "/notes",
                                                   "/coolant",
                                                   "/part/name",
                                                   "/part/shaft/segments",
                                                   "/part/shaft/youngs_modulus_gpa",
                                                   "/part/shaft/mounting",
                                                   "/part/shaft/steady_rests",
                                                   "/part/shaft/quill",
                                                   "/material",
                                                   "/wheel",
                                                   "/machine/name",
                                                   "/machine/wheel_speed_m_s",
                                                   "/machine/stiffness_n_um",
                                                   "/machine/geometric_runout_um",
                                                   "/machine/wheel_drive_kw",
                                                   "/machine/work_drive_kw",
                                                   "/machine/wheel_contact",
                                                   "/machine/feed_change_delay_s",
                                                   "/machine/limits"};

/// Whether one path is the other, or leads to it.
bool leadsTo(std::string_view path, std::string_view longer) {
    return longer.starts_with(path) && (longer.size() == path.size() || longer[path.size()] == '/');
}

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

std::span<const std::string_view> sharedMembers() {
    return members;
}

bool isShared(std::string_view path) {
    return std::ranges::any_of(members,
                               [path](std::string_view member) { return leadsTo(member, path); });
}

bool holdsShared(std::string_view path) {
    return !isShared(path) && std::ranges::any_of(members, [path](std::string_view member) {
        return leadsTo(path, member);
    });
}

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
