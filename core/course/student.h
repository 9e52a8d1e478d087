// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace sparkout {

/// A student as named in a list.
struct Student {
    std::string name, group;
    friend bool operator==(const Student&, const Student&) = default;
};

/// A name in the form used for comparison: composed letters, one space between words, lower case,
/// nothing invisible. Федоров and Фёдоров are different names.
[[nodiscard]] std::u32string comparedName(std::string_view name);

/// Whether both are the same student of the same group.
[[nodiscard]] bool isSameStudent(const Student& a, const Student& b);

/// The text with single spaces between its words and none around it.
[[nodiscard]] std::string withSingleSpaces(std::string_view text);

} // namespace sparkout
