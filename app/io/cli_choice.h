// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/manual/given.h"
#include "core/field.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace sparkout::cli {

/// The choice that an option names by its key in files; empty if it is not given.
template <class E>
std::optional<E> choiceOf(const manual::Given& given, std::string_view option) {
    const auto choices = choicesOf<E>();
    for (std::size_t i = 0; i < choices.size(); ++i) {
        if (given.text(option) == choices[i].key) {
            if constexpr (detail::Kinds<E>) {
                return E::ofIndex(i);
            } else {
                return static_cast<E>(i);
            }
        }
    }
    return std::nullopt;
}

} // namespace sparkout::cli
