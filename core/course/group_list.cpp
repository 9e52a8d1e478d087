// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/group_list.h"

#include "core/tables/table_cell.h"
#include "core/tables/table_reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

namespace sparkout {

namespace {

using Cells = std::vector<std::string_view>;
using Names = std::initializer_list<const char*>;

/// A heading without variations of spelling: "Ф.И.О." becomes "фио".
std::string comparedHeading(std::string_view heading) {
    std::string name = lowerCase(withSingleSpaces(heading));
    std::erase(name, '.');
    return name;
}

std::optional<std::size_t> columnOf(const Cells& headings, Names names) {
    for (const char* const name : names) {
        const auto found = std::ranges::find(headings, name, comparedHeading);
        if (found != headings.end()) {
            return static_cast<std::size_t>(found - headings.begin());
        }
    }
    return std::nullopt;
}

std::string cellAt(const Cells& cells, std::size_t column) {
    return column < cells.size() ? withSingleSpaces(cells[column]) : std::string();
}

class Columns {
public:
    /// False if these are not headings.
    bool takeHeadings(const Cells& cells) {
        const auto whole = columnOf(cells, {"фио", "фамилия имя отчество", "фамилия, имя, отчество",
                                            "фамилия и имя", "студент", "обучающийся", "full name",
                                            "student name", "student", "name"});
        const auto surname = columnOf(cells, {"фамилия", "surname", "last name", "family name"});
        const auto first = columnOf(cells, {"имя", "first name", "given name"});
        const auto patronymic = columnOf(cells, {"отчество", "middle name"});
        std::vector<std::size_t> names;
        if (whole && !(surname && first)) {
            names = {*whole};
        } else {
            for (const auto& column : {surname, first, patronymic}) {
                if (column) {
                    names.push_back(*column);
                }
            }
        }
        if (names.empty()) {
            return false;
        }
        m_names = names;
        m_headings = cells.size();
        m_group = columnOf(cells, {"группа", "учебная группа", "группы", "group", "groups"})
                      .value_or(m_headings);
        return true;
    }

    [[nodiscard]] Student studentOf(const Cells& cells) const {
        std::string name;
        for (const std::size_t column : m_names) {
            name += (name.empty() ? "" : " ") + cellAt(cells, column);
        }
        return {withSingleSpaces(name), cellAt(cells, m_group)};
    }

    /// The row has cells behind the last heading.
    [[nodiscard]] bool hasMoreCells(const Cells& cells) const {
        return m_headings > 0 && cells.size() > m_headings
               && std::any_of(cells.begin() + static_cast<std::ptrdiff_t>(m_headings), cells.end(),
                              [](std::string_view cell) { return !cell.empty(); });
    }

private:
    std::vector<std::size_t> m_names{0};
    std::size_t m_group = 1;
    std::size_t m_headings = 0; ///< number of the row of headings; 0: none
};

} // namespace

GroupList readGroup(const TableText& text) {
    GroupList list;
    TableReader rows(text.utf8(), dialectOf(text.utf8()).delimiter);
    Columns columns;
    std::set<std::pair<std::u32string, std::u32string>> seen;
    bool isFirst = true;
    while (rows.next()) {
        const Cells& cells = rows.cells();
        if (rows.isEmpty() || (std::exchange(isFirst, false) && columns.takeHeadings(cells))) {
            continue;
        }
        Student student = columns.studentOf(cells);
        if (columns.hasMoreCells(cells)) {
            list.faults.push_back({GroupFault::Kind::moreCells, rows.line(), {}});
        } else if (student.name.empty()) {
            list.faults.push_back({GroupFault::Kind::noName, rows.line(), {}});
        } else if (!seen.insert({comparedName(student.name), comparedName(student.group)}).second) {
            list.faults.push_back({GroupFault::Kind::twice, rows.line(), student.name});
        } else if (list.students.size() == limits::students) {
            list.faults.push_back({GroupFault::Kind::tooMany, rows.line(), {}});
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
