// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

/// The object of a project in the file of a set-up, where what is shared stands apart.
namespace sparkout {

struct SplitProject {
    nlohmann::ordered_json shared, own;
};
/// What is shared of a project's object, and what is not.
[[nodiscard]] SplitProject splitProject(const nlohmann::ordered_json& project);

/// A project's object out of both parts.
[[nodiscard]] nlohmann::json joinProject(const nlohmann::json& shared, const nlohmann::json& own);

} // namespace sparkout
