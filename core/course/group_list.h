// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout {

namespace limits {
inline constexpr std::size_t students = 1000;
inline constexpr std::size_t groupBytes = 1u << 20;
} // namespace limits

struct Student {
    std::string name, group;
    friend bool operator==(const Student&, const Student&) = default;
};

/// What is wrong with a line of a list.
struct GroupFault {
    enum class Kind { noName, twice, tooMany, empty };
    Kind kind = Kind::empty;
    std::size_t line = 0; ///< from 1; 0: the whole list
    std::string name;     ///< that stands there twice
};

struct GroupList {
    std::vector<Student> students; ///< in the order of the list
    std::vector<GroupFault> faults;
};

/// A list of students: a table of names and, if there are several, groups, UTF-8, in either
/// dialect. Where its first line names columns ("name", "group", «ФИО», «имя», «студент»,
/// «группа»), these are taken; else the first and second.
[[nodiscard]] GroupList readGroup(std::string_view text);

} // namespace sparkout
