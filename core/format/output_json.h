// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <nlohmann/json.hpp>

#include <span>

namespace sparkout {

/// An output as JSON has it: null where there is none, an interval as [low, high].
[[nodiscard]] nlohmann::ordered_json outputJson(const OutputValue& value);

/// The outputs of an owner that have a key, as one object.
template <class Owner>
[[nodiscard]] nlohmann::ordered_json outputsJson(std::span<const Output<Owner>> rows,
                                                 const Owner& owner) {
    nlohmann::ordered_json json = nlohmann::ordered_json::object();
    for (const Output<Owner>& row : rows) {
        if (*row.key && (!row.stated || row.stated(owner))) {
            json[row.key] = outputJson(row.of(owner));
        }
    }
    return json;
}

} // namespace sparkout
