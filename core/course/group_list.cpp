// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/group_list.h"

#include "core/measured/table_text.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

namespace sparkout {

namespace {

constexpr std::array nameHeadings{"name", "student", "фио", "имя", "студент", "фамилия"};
constexpr std::array groupHeadings{"group", "группа"};

template <std::size_t N>
std::optional<std::size_t> columnOf(const std::vector<std::string_view>& cells,
                                    const std::array<const char*, N>& headings) {
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::string cell = lowerCase(cells[i]);
        if (std::find(headings.begin(), headings.end(), cell) != headings.end()) {
            return i;
        }
    }
    return std::nullopt;
}

std::string cellAt(const std::vector<std::string_view>& cells, std::size_t column) {
    return column < cells.size() ? std::string(cells[column]) : std::string();
}

} // namespace

GroupList readGroup(std::string_view text) {
    GroupList list;
    const TableDialect dialect = dialectOf(text);
    TableLines lines(text);
    std::vector<std::string_view> cells;
    std::set<std::pair<std::string, std::string>> seen;
    std::size_t nameColumn = 0, groupColumn = 1;
    for (bool isFirst = true; !lines.atEnd();) {
        const std::string_view line = lines.next();
        if (line.find_first_not_of(" \t\r,;") == std::string_view::npos) {
            continue;
        }
        splitCells(line, dialect.delimiter, cells);
        if (std::exchange(isFirst, false)) {
            if (const auto name = columnOf(cells, nameHeadings)) {
                nameColumn = *name;
                groupColumn = columnOf(cells, groupHeadings).value_or(cells.size());
                continue;
            }
        }
        Student student{cellAt(cells, nameColumn), cellAt(cells, groupColumn)};
        if (student.name.empty()) {
            list.faults.push_back({GroupFault::Kind::noName, lines.number(), {}});
        } else if (!seen.insert({student.name, student.group}).second) {
            list.faults.push_back({GroupFault::Kind::twice, lines.number(), student.name});
        } else if (list.students.size() == limits::students) {
            list.faults.push_back({GroupFault::Kind::tooMany, lines.number(), {}});
            break;
        } else {
            list.students.push_back(std::move(student));
        }
    }
    if (list.students.empty() && list.faults.empty()) {
        list.faults.push_back({});
    }
    return list;
}

} // namespace sparkout
