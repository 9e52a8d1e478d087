// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <span>
#include <string_view>

/// What all surfaces of a set-up share: it stands once in their file, at the path it has in the
/// file of a single surface. The rest stands with each surface.
namespace sparkout {

[[nodiscard]] std::span<const std::string_view> sharedMembers(); ///< as JSON pointers

/// Whether a path names a shared member, or something in one.
[[nodiscard]] bool isShared(std::string_view path);
/// Whether a path names an object that has shared members among others.
[[nodiscard]] bool holdsShared(std::string_view path);

struct SplitProject {
    nlohmann::ordered_json shared, own;
};
/// What is shared of a project's object, and what is not.
[[nodiscard]] SplitProject splitProject(const nlohmann::ordered_json& project);

/// A project's object out of both parts.
[[nodiscard]] nlohmann::json joinProject(const nlohmann::json& shared, const nlohmann::json& own);

} // namespace sparkout
