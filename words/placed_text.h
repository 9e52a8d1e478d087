// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <initializer_list>
#include <string>
#include <utility>

namespace sparkout {

/// Placeholder names of a sentence, and their values.
using TextPlaces = std::initializer_list<std::pair<const char*, std::string>>;

/// A sentence with its placeholders filled, "{change}: {cost}"; a placeholder may occur twice.
[[nodiscard]] std::string placedText(const std::string& sentence, TextPlaces places);

} // namespace sparkout
