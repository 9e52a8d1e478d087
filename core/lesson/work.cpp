// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/work.h"

#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/file/text_table.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_json.h"
#include "core/printable.h"
#include "core/project/conditions.h"
#include "core/sha256.h"

#include <algorithm>
#include <array>
#include <cmath>
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

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// The text of an entry that its seal covers.
std::string sealedText(const WorkEntry& entry) {
    return printJson(writeByTable(tableOf<WorkEntry>(), &entry, {"sha256"}));
}

constexpr const char* lessonKey = "lesson";

/// Faults of a work besides its keys and ranges: entries with missing steps and hints.
void checkEntries(const Work& work, Issues& issues) {
    const auto steps = static_cast<double>(work.lesson.steps.size());
    for (std::size_t i = 0; i < work.levels.size(); ++i) {
        if (work.levels[i] != std::floor(work.levels[i])) {
            addIssue(issues, {IssueCode::wrongType, Severity::error, "/levels/" + std::to_string(i),
                              Amount{work.levels[i]}, Phrase::wholeNumber});
        }
    }
    for (std::size_t i = 0; i < work.entries.size(); ++i) {
        const WorkEntry& entry = work.entries[i];
        const std::string path = "/entries/" + std::to_string(i);
        if (entry.step > steps) {
            addIssue(issues, {IssueCode::outOfRange, Severity::error, path + "/step",
                              Count{entry.step}, Bounds{{1, steps}}});
            continue;
        }
        const LessonStep& step = work.lesson.steps[static_cast<std::size_t>(entry.step) - 1];
        const auto hints = static_cast<double>(step.hints.size());
        if (entry.event == WorkEvent::hint && !entry.hint) {
            addIssue(
                issues,
                {IssueCode::missingKey, Severity::error, path + "/hint", {}, Bounds{{1, hints}}});
        } else if (entry.event == WorkEvent::hint && *entry.hint > hints) {
            addIssue(issues, {IssueCode::outOfRange, Severity::error, path + "/hint",
                              Count{*entry.hint}, Bounds{{1, hints}}});
        } else if (entry.event == WorkEvent::run && !entry.run) {
            addIssue(issues,
                     {IssueCode::missingKey, Severity::error, path + "/run", {}, Phrase::object});
        }
    }
}

ReadWork readWorkJson(const json& root, Issues found, const std::stop_token& stop) {
    ReadWork read{std::nullopt, std::move(found)};
    Issues& issues = read.issues;
    if (const Issues header = checkFileHeader(root, workFormat, workVersion); !header.empty()) {
        issues.insert(issues.end(), header.begin(), header.end());
        return read;
    }
    Work work;
    readStruct(root, tableOf<WorkSheet>(), static_cast<WorkSheet*>(&work), {}, issues,
               {"format", "version", lessonKey});
    const std::string path = std::string("/") + lessonKey;
    const auto lesson = root.find(lessonKey);
    if (lesson == root.end()) {
        addIssue(issues, {IssueCode::missingKey, Severity::error, path, {}, Phrase::object});
        return read;
    }
    ReadLesson inner = readLessonJson(*lesson, LessonOf::student, {}, stop);
    for (Issue& issue : inner.issues) {
        issue.path = path + issue.path;
        addIssue(issues, std::move(issue));
    }
    if (stop.stop_requested() || !inner.lesson || hasErrors(issues)) {
        return read;
    }
    work.lesson = std::move(*inner.lesson);
    Issues faults;
    checkEntries(work, faults);
    if (faults.empty()) {
        read.work = std::move(work);
    } else { // placed before warnings, since the list may be full
        issues.insert(issues.begin(), faults.begin(), faults.end());
        issues.resize(std::min(issues.size(), limits::issues));
    }
    return read;
}

} // namespace

VariantLevels Work::variantLevels() const {
    VariantLevels whole;
    for (const double level : levels) {
        whole.push_back(static_cast<std::size_t>(level));
    }
    return whole;
}

Work newWork(const Lesson& lesson, const VariantLevels& levels,
             const std::optional<double>& best_min, int variant, std::string name,
             std::string group) {
    Work work;
    work.name = std::move(name);
    work.group = std::move(group);
    work.variant = variant;
    work.levels.assign(levels.begin(), levels.end());
    work.lesson_sha256 = lessonDigest(lesson);
    work.lesson = forStudents(withVariant(lesson, levels, best_min));
    work.sha256 = firstSeal(work);
    return work;
}

StepRecord recordOf(const Work& work, std::size_t step) {
    StepRecord record;
    const bool predicts = isPrediction(work.lesson.steps[step].goal);
    bool isSeen = false;
    const WorkEntry* counts = nullptr; // copied once: a work may have thousands
    for (const WorkEntry& entry : work.entries) {
        if (static_cast<std::size_t>(entry.step) != step + 1) {
            continue;
        }
        switch (entry.event) {
        case WorkEvent::hint:
            if (std::find(record.hints.begin(), record.hints.end(), entry.hint.value_or(0))
                == record.hints.end()) {
                record.hints.push_back(entry.hint.value_or(0));
            }
            break;
        case WorkEvent::run: isSeen = true; break;
        case WorkEvent::prediction:
            if (predicts && !counts) {
                counts = &entry;
                record.isPredictedLate = isSeen;
            }
            record.attempts += predicts ? 1 : 0;
            break;
        case WorkEvent::attempt:
            isSeen = true;
            if (!predicts) {
                counts = &entry;
                ++record.attempts;
            }
            break;
        }
    }
    if (counts) {
        record.answer = counts->answer;
        record.when = counts->when;
    }
    return record;
}

double priceOf(const LessonStep& step, const StepRecord& record) {
    double price = 0;
    for (const int hint : record.hints) {
        const auto index = static_cast<std::size_t>(hint) - 1;
        price += hint > 0 && index < step.hints.size() ? step.hints[index].price : 0;
    }
    return price;
}

template <>
std::span<const Choice> choicesOf<WorkEvent>() {
    static constexpr std::array choices{Choice{"prediction", "predicted before the run"},
                                        Choice{"attempt", "handed in"},
                                        Choice{"hint", "hint taken"}, Choice{"run", "run kept"}};
    return choices;
}

template <>
const StructInfo& tableOf<WorkEntry>() {
    static const std::array rows{
        SPARKOUT_FIELD(WorkEntry, event, .label = "Event", .required = conditions::always),
        SPARKOUT_FIELD(WorkEntry, step, .label = "Step", .hard = {1, 100},
                       .required = conditions::always, .hint = "Counted from 1."),
        SPARKOUT_FIELD(WorkEntry, when, .label = "When", .required = conditions::always,
                       .hint = "By the clock of the student's machine, UTC."),
        SPARKOUT_FIELD(WorkEntry, answer, .label = "Answer", .sparse = true,
                       .hint = "Answer of a prediction or an attempt."),
        SPARKOUT_FIELD(WorkEntry, hint, .label = "Hint", .hard = {1, 20},
                       .nullMeaning = "the entry is no hint", .hint = "Counted from 1."),
        SPARKOUT_FIELD(WorkEntry, run, .label = "Run", .nullMeaning = "the entry is no run",
                       .hint = "Kept run as in a project file."),
        SPARKOUT_FIELD(WorkEntry, sha256, .label = "Seal", .required = conditions::always,
                       .hint = "SHA-256 of the seal before and of this entry."),
    };
    static const StructInfo info = makeTable<WorkEntry>("Entry", rows);
    return info;
}

template <>
const StructInfo& tableOf<WorkSheet>() {
    static const std::array rows{
        SPARKOUT_FIELD(WorkSheet, name, .label = "Student", .required = conditions::always),
        SPARKOUT_FIELD(WorkSheet, group, .label = "Group", .required = conditions::always),
        SPARKOUT_FIELD(WorkSheet, variant, .label = "Variant", .hard = {1, 1000000},
                       .required = conditions::always, .hint = "Number of the variant."),
        SPARKOUT_FIELD(WorkSheet, levels, .label = "Levels", .hard = {0, 10000},
                       .required = conditions::always, .whole = true,
                       .hint = "Levels of the varied inputs, from 0, in their order."),
        SPARKOUT_FIELD(WorkSheet, lesson_sha256, .label = "Digest of the lesson",
                       .required = conditions::always,
                       .hint = "SHA-256 of the teacher's lesson as students may have it, without "
                               "a variant."),
        SPARKOUT_FIELD(WorkSheet, sha256, .label = "Seal", .required = conditions::always,
                       .hint = "SHA-256 of the values above and of the lesson with its variant."),
        SPARKOUT_FIELD(WorkSheet, entries, .label = "Entries",
                       .hard = {0, static_cast<double>(limits::workEntries)},
                       .hint = "Everything handed in, in order."),
    };
    static const StructInfo info = makeTable<WorkSheet>("Work", rows);
    return info;
}

std::string lessonDigest(const Lesson& lesson) {
    return sha256(writeLesson(forStudents(lesson)));
}

std::string variantDigest(const Lesson& issued) {
    return sha256(writeLesson(issued));
}

std::string firstSeal(const Work& work) {
    const auto* sheet = static_cast<const WorkSheet*>(&work);
    return sha256(printJson(writeByTable(tableOf<WorkSheet>(), sheet, {"sha256", "entries"}))
                  + variantDigest(work.lesson));
}

std::string nextSeal(const std::string& before, const WorkEntry& entry) {
    return sha256(before + '\n' + sealedText(entry));
}

void addEntry(Work& work, WorkEntry entry) {
    const std::string& before = work.entries.empty() ? work.sha256 : work.entries.back().sha256;
    entry.sha256 = nextSeal(before, entry);
    work.entries.push_back(std::move(entry));
}

std::optional<std::size_t> brokenSeal(const Work& work) {
    if (work.sha256 != firstSeal(work)) {
        return 0;
    }
    const std::string* before = &work.sha256;
    for (std::size_t i = 0; i < work.entries.size(); ++i) {
        if (work.entries[i].sha256 != nextSeal(*before, work.entries[i])) {
            return i + 1;
        }
        before = &work.entries[i].sha256;
    }
    return std::nullopt;
}

std::string contentDigest(const Work& work) {
    std::string all;
    for (const WorkEntry& entry : work.entries) {
        all += sealedText(entry);
    }
    return all.empty() ? all : sha256(all);
}

ReadWork readWork(std::string_view text, const std::stop_token& stop) {
    Issues issues;
    const auto root = parseStrictly(text, issues, stop);
    if (!root || stop.stop_requested()) {
        return {std::nullopt, stop.stop_requested() ? Issues() : std::move(issues)};
    }
    return readWorkJson(*root, std::move(issues), stop);
}

std::string writeWork(const Work& work) {
    ordered_json root = {{"format", workFormat}, {"version", workVersion}};
    root.update(writeByTable(tableOf<WorkSheet>(), static_cast<const WorkSheet*>(&work)));
    root[lessonKey] = lessonJson(work.lesson);
    return printJson(root);
}

} // namespace sparkout
