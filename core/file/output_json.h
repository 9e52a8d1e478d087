// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <span>

namespace sparkout {

/// Null without a value.
template <class Value>
[[nodiscard]] nlohmann::ordered_json jsonOrNull(const std::optional<Value>& value) {
    return value ? nlohmann::ordered_json(*value) : nlohmann::ordered_json(nullptr);
}

/// An output in JSON: null without a value, an interval as [low, high].
[[nodiscard]] nlohmann::ordered_json outputJson(const OutputValue& value);

/// The outputs of an owner that have a key, as one object.
template <class Owner>
[[nodiscard]] nlohmann::ordered_json outputsJson(std::span<const Output<Owner>> rows,
                                                 const Owner& owner) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const Output<Owner>& row : rows) {
        if (*row.key && row.isStated(owner)) {
            json[row.key] = outputJson(row.of(owner));
        }
    }
    return json;
}

/// For an owner that may be missing: null then.
template <class Owner>
[[nodiscard]] nlohmann::ordered_json outputsJson(std::span<const Output<Owner>> rows,
                                                 const std::optional<Owner>& owner) {
    return owner ? outputsJson(rows, *owner) : nlohmann::ordered_json();
}

template <class Owner, class Owners>
[[nodiscard]] nlohmann::ordered_json outputsJsonOfEach(std::span<const Output<Owner>> rows,
                                                       const Owners& owners) {
    nlohmann::ordered_json list = nlohmann::ordered_json::array();
    for (const Owner& owner : owners) {
        list.push_back(outputsJson(rows, owner));
    }
    return list;
}

} // namespace sparkout
