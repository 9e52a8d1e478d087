// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/file/output_json.h"

#include <type_traits>

namespace sparkout {

using nlohmann::ordered_json;

ordered_json outputJson(const OutputValue& value) {
    return std::visit(
        [](const auto& of) -> ordered_json {
            using Value = std::decay_t<decltype(of)>;
            if constexpr (std::is_same_v<Value, std::monostate>) {
                return nullptr;
            } else if constexpr (std::is_same_v<Value, Interval>) {
                return ordered_json::array({of.low, of.high});
            } else if constexpr (std::is_same_v<Value, Estimate>) {
                return {{"value", of.value}, {"interval_95", outputJson(of.interval)}};
            } else if constexpr (std::is_same_v<Value, Share>) {
                return {{"count", of.count},
                        {"share", of.value},
                        {"interval_95",
                         of.interval ? outputJson(*of.interval) : ordered_json(nullptr)}};
            } else {
                return of;
            }
        },
        value);
}

} // namespace sparkout
