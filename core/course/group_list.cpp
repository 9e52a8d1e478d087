// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/group_list.h"

#include "core/printable.h"
#include "core/tables/table_cell.h"
#include "core/tables/table_reader.h"

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <utility>

namespace sparkout {

namespace {

/// A combining mark, the letters that it follows, and the composed letters [UNICODE-15, lower
/// case].
struct CombiningMark {
    char32_t mark;
    std::u32string_view bases, composed;
};

constexpr std::array combiningMarks{
    CombiningMark{0x300, U"aeiouеи", U"àèìòùѐѝ"},
    CombiningMark{0x301, U"aeiouyclnrszгк", U"áéíóúýćĺńŕśźѓќ"},
    CombiningMark{0x302, U"aeioucghjswy", U"âêîôûĉĝĥĵŝŵŷ"},
    CombiningMark{0x303, U"anoiu", U"ãñõĩũ"},
    CombiningMark{0x304, U"aeiouиу", U"āēīōūӣӯ"},
    CombiningMark{0x306, U"aegiouиужае", U"ăĕğĭŏŭйўӂӑӗ"},
    CombiningMark{0x307, U"cegz", U"ċėġż"},
    CombiningMark{0x308, U"aeiouyеіаәжзиоөэучы", U"äëïöüÿёїӓӛӝӟӥӧӫӭӱӵӹ"},
    CombiningMark{0x30A, U"au", U"åů"},
    CombiningMark{0x30B, U"ouу", U"őűӳ"},
    CombiningMark{0x30C, U"cdelnrstz", U"čďěľňřšťž"},
    CombiningMark{0x30F, U"ѵ", U"ѷ"},
    CombiningMark{0x327, U"cgklnrst", U"çģķļņŗşţ"},
    CombiningMark{0x328, U"aeiu", U"ąęįų"},
};

bool isSpace(char32_t c) {
    return (c >= 0x09 && c <= 0x0D) || c == 0x20 || c == 0x85 || c == 0xA0 || c == 0x1680
           || (c >= 0x2000 && c <= 0x200A) || c == 0x2028 || c == 0x2029 || c == 0x202F
           || c == 0x205F || c == 0x3000;
}

/// Invisible characters: soft hyphens, joiners, marks of direction.
bool isInvisible(char32_t c) {
    return c == 0xAD || (c >= 0x200B && c <= 0x200F) || (c >= 0x202A && c <= 0x202E)
           || (c >= 0x2060 && c <= 0x2069) || c == 0xFEFF;
}

char32_t lower(char32_t c) {
    const bool isLatin1 = c >= 0xC0 && c <= 0xDE && c != 0xD7;
    if ((c >= 'A' && c <= 'Z') || isLatin1 || (c >= 0x410 && c <= 0x42F)) {
        return c + 0x20;
    }
    if (c >= 0x400 && c <= 0x40F) {
        return c + 0x50;
    }
    if (c == 0x178) {
        return 0xFF;
    }
    // Pairs of a capital and its small letter; these ranges begin with an odd code.
    const bool isOddFirst = (c >= 0x139 && c <= 0x148) || (c >= 0x179 && c <= 0x17E);
    const bool isPair = isOddFirst || (c >= 0x100 && c <= 0x177 && c != 0x130 && c != 0x131)
                        || (c >= 0x460 && c <= 0x481) || (c >= 0x48A && c <= 0x4BF)
                        || (c >= 0x4D0 && c <= 0x4FF);
    const bool isCapital = (c % 2 == 1) == isOddFirst;
    return isPair && isCapital ? c + 1 : c;
}

/// Adds a character, composing it with a preceding letter.
void addLetter(std::u32string& text, char32_t c) {
    for (const CombiningMark& mark : combiningMarks) {
        if (const std::size_t at = mark.composed.find(c); at != mark.composed.npos) {
            text += mark.bases[at];
            text += mark.mark;
            return;
        }
    }
    text += c;
}

template <typename Take>
void eachCharacter(std::string_view text, const Take& take) {
    while (!text.empty()) {
        const std::size_t size = characterBytes(text);
        const std::string_view character = text.substr(0, std::max<std::size_t>(size, 1));
        take(size > 0 ? characterCode(character) : char32_t{0xFFFD}, character);
        text.remove_prefix(character.size());
    }
}

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

std::string withSingleSpaces(std::string_view text) {
    std::string spaced;
    bool isDue = false;
    eachCharacter(text, [&](char32_t code, std::string_view character) {
        if (isSpace(code)) {
            isDue = !spaced.empty();
            return;
        }
        spaced += isDue ? " " : "";
        spaced += character;
        isDue = false;
    });
    return spaced;
}

std::u32string comparedName(std::string_view name) {
    std::u32string letters;
    eachCharacter(withSingleSpaces(name), [&](char32_t code, std::string_view) {
        if (!isInvisible(code)) {
            addLetter(letters, lower(code));
        }
    });
    return letters;
}

bool isSameStudent(const Student& a, const Student& b) {
    return comparedName(a.name) == comparedName(b.name)
           && comparedName(a.group) == comparedName(b.group);
}

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
