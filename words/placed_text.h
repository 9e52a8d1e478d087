// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

namespace sparkout {

/// Names of places in a sentence, and what stands there.
using TextPlaces = std::initializer_list<std::pair<const char*, std::string>>;

/// A sentence with what stands in its places, "{change}: {cost}"; a place may come twice.
[[nodiscard]] std::string placedText(const std::string& sentence, TextPlaces places);

} // namespace sparkout
