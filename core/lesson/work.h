// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/text_encoding.h"
#include "core/issue.h"
#include "core/lesson/goal.h"
#include "core/lesson/lesson.h"
#include "core/lesson/make_variants.h"
#include "core/project/project.h"

#include <cstddef>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

/// A student's work: the lesson with the student's variant, and all submissions in their order.

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

namespace limits {
inline constexpr std::size_t workEntries = 2000;
} // namespace limits

/// The kinds of entries of a work.
enum class WorkEvent {
    prediction, ///< made before the run
    attempt,    ///< an answer to a step was handed in
    hint,       ///< a hint was used
    run,        ///< a run was kept
};

/// One entry, never changed. Its seal covers it and, through the previous seal, all before it.
struct WorkEntry {
    WorkEvent event = WorkEvent::attempt;
    int step = 1;            ///< counted from 1
    std::string when;        ///< ISO 8601, UTC, by the student's clock
    Answer answer;           ///< for a prediction or an attempt
    std::optional<int> hint; ///< hint that was used, from 1
    std::optional<KeptRun> run;
    std::string sha256;
};

/// A work without its lesson.
struct WorkSheet {
    std::string name;  ///< student's name
    std::string group; ///< student's group
    int variant = 0;   ///< number of the variant, from 1
    /// Level of each varied input, from 0; empty if all have the same project.
    std::vector<double> levels;
    std::string lesson_sha256; ///< hash of the original lesson, as given to students
    std::string sha256;        ///< seal of all of this and of `lesson`
    std::vector<WorkEntry> entries;
};

struct Work : WorkSheet {
    Lesson lesson; ///< with the variant, as given to students

    [[nodiscard]] VariantLevels variantLevels() const;
};

/// A new work for a student with a variant, sealed and without entries.
[[nodiscard]] Work newWork(const Lesson& lesson, const VariantLevels& levels,
                           const std::optional<double>& best_min, int variant, std::string name,
                           std::string group);

/// The student's view of a step in a work: the answer that counts, hints and attempts.
struct StepRecord {
    std::optional<Answer> answer; ///< the first prediction, otherwise the last answer
    std::string when;             ///< time of the submission
    int attempts = 0;
    std::vector<int> hints;       ///< hints used, from 1, each once
    bool isPredictedLate = false; ///< after an attempt at the step, or a run kept in it
};
[[nodiscard]] StepRecord recordOf(const Work& work, std::size_t step);

/// The price of the hints used.
[[nodiscard]] double priceOf(const LessonStep& step, const StepRecord& record);

template <>
std::span<const Choice> choicesOf<WorkEvent>();
template <>
const StructInfo& tableOf<WorkEntry>();
template <>
const StructInfo& tableOf<WorkSheet>();

// The seals of a work: a chain of SHA-256 digests. The first covers the original lesson, the
// lesson with the variant, name, group and number; each further one an entry and the seal before
// it.
//
// They prove: that a work with a broken chain was changed outside the program, even in one digit
// of an old entry; that two works with the same entries are copies; that a work belongs to this
// lesson and this variant.
//
// They contain no secret. Any reader of this page can change a work and seal it again; the last
// entries can be cut off; the times are those of the student's clock; and another person may have
// done the work. So marking takes no number from a work: the answers are computed again from the
// teacher's lesson, and variants are checked against the teacher's table, which the student does
// not have.

/// Identifies a lesson by its text as given to students, without a variant. The right options and
/// the rules for variants may be changed after works were given out.
[[nodiscard]] std::string lessonDigest(const Lesson& lesson);

/// Digest of a lesson with a variant, as given out.
[[nodiscard]] std::string variantDigest(const Lesson& issued);

/// The seal of a work without entries.
[[nodiscard]] std::string firstSeal(const Work& work);

/// The seal of an entry that follows another.
[[nodiscard]] std::string nextSeal(const std::string& before, const WorkEntry& entry);

void addEntry(Work& work, WorkEntry entry);

/// The first broken seal: 0 that of the work itself, otherwise the number of an entry from 1. Empty
/// if the chain is intact.
[[nodiscard]] std::optional<std::size_t> brokenSeal(const Work& work);

/// Digest of all entries, without seals, names and variant: equal if one work was copied from
/// another. Empty without entries.
[[nodiscard]] std::string contentDigest(const Work& work);

// The file of a student's work, `.sparkout-work`: one UTF-8 JSON text, read and written by the
// tables, its lesson as in a lesson file.

inline constexpr const char* workFormat = "sparkout-work";
inline constexpr int workVersion = 1;

struct ReadWork {
    std::optional<Work> work; ///< given without errors; its seals may be broken
    Issues issues;            ///< those of its lesson below "/lesson"
};

/// Reads and checks a work within the limits of a project file. Returns all faults at once.
[[nodiscard]] ReadWork readWork(std::string_view text, const std::stop_token& stop = {});

/// The text of a work: the same work, the same bytes.
[[nodiscard]] std::string writeWork(const Work& work);

} // namespace sparkout
