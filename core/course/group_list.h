// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tables/table_text.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

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

namespace limits {
inline constexpr std::size_t students = 1000;
inline constexpr std::size_t groupBytes = 1u << 20;
} // namespace limits

/// A fault in a line of a list.
struct GroupFault {
    enum class Kind { noName, twice, tooMany, empty, moreCells };
    Kind kind = Kind::empty;
    std::size_t line = 0; ///< counted from 1; 0: the whole list
    std::string name;     ///< name that occurs twice
};

struct GroupList {
    std::vector<Student> students; ///< in the order of the list
    std::vector<GroupFault> faults;
};

/// A list of students: a table of names and, if there are several, groups, in either dialect. Where
/// its first row names columns ("name", "student", «ФИО», «студент»; "surname" and "first name",
/// «фамилия» and «имя», which are joined; "group", «группа»), these are used; otherwise the first
/// and second. Multiple spaces in names become one.
[[nodiscard]] GroupList readGroup(const TableText& text);

} // namespace sparkout
