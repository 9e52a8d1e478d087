// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

/// The object of a project in the file of a set-up, split into shared and own values.
namespace sparkout {

struct SplitProject {
    nlohmann::ordered_json shared, own;
};
/// Splits a project's object into shared and own values.
[[nodiscard]] SplitProject splitProject(const nlohmann::ordered_json& project);

/// A project's object out of both parts.
[[nodiscard]] nlohmann::json joinProject(const nlohmann::json& shared, const nlohmann::json& own);

} // namespace sparkout
