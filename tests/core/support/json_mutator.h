// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include <iterator>
#include <string>
#include <vector>

namespace sparkout::samples {

using nlohmann::json;

/// A random place of a file, by its pointer. `pick(n)` gives 0 … n − 1.
template <class Pick>
json::json_pointer randomPlace(const json& file, Pick& pick) {
    json::json_pointer at;
    const json* value = &file;
    while (value->is_structured() && !value->empty() && pick(8) != 0) {
        auto item = value->begin();
        std::advance(item, pick(static_cast<int>(value->size())));
        if (value->is_object()) {
            at /= item.key();
        } else {
            at /= static_cast<std::size_t>(item - value->begin());
        }
        value = &*item;
    }
    return at;
}

/// Takes out, replaces, doubles or changes one value at random.
template <class Pick>
void mutateJson(json& file, Pick& pick) {
    static const std::vector<json> others{
        nullptr,       true,           0,     -1, 1e9, 0.5,   "", "nz", "/cycle", "E1", 12345,
        json::array(), json::object(), "<b>", 1,  2,   "free"};
    const auto at = randomPlace(file, pick);
    if (at.empty()) {
        return;
    }
    json& value = file[at];
    json& parent = file[at.parent_pointer()];
    switch (pick(5)) {
    case 0:
        if (parent.is_object()) {
            parent.erase(at.back());
        } else {
            parent.erase(static_cast<std::size_t>(std::stoul(at.back())));
        }
        break;
    case 1: value = others[static_cast<std::size_t>(pick(static_cast<int>(others.size())))]; break;
    case 2:
        if (parent.is_array()) {
            parent.push_back(json(value));
        }
        break;
    case 3: value = json(file[randomPlace(file, pick)]); break;
    default:
        if (value.is_number()) {
            value = value.get<double>() * (pick(2) ? 2 : 0.5);
        }
    }
}

} // namespace sparkout::samples
