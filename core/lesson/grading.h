// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"
#include "core/lesson/best_table.h"
#include "core/lesson/goal_check.h"
#include "core/lesson/lesson.h"
#include "core/lesson/work.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// Marking: the engine computes every answer again from the teacher's lesson. Results, lesson and
/// variant stated by a work are not trusted.

namespace sparkout {

/// A property of a work to be examined; the teacher decides on the consequences.
enum class WorkFlag {
    unreadable,    ///< not a work, or with faults: not marked
    foreign,       ///< a work of another lesson or another version of it: not marked
    edited,        ///< a seal is broken, or its lesson or variant is not the one given out
    copied,        ///< its variant or its entries equal those of another student's work
    handedInTwice, ///< the same student handed in another work
    notInGroup,    ///< the list does not contain this student
    untrueRuns,    ///< numbers of a kept run differ from the engine's
    late,          ///< a prediction was made after its result was known
    forbidden,     ///< locked inputs were changed
    missing,       ///< nothing was handed in
    overBudget,    ///< marking took too long: some of it is left out
};
inline constexpr int workFlags = static_cast<int>(WorkFlag::overBudget) + 1;

[[nodiscard]] const char* flagKey(WorkFlag flag);

struct GradedStep {
    GoalResult result;
    double points = 0;
    double most = 0;
    double hints = 0; ///< price of the hints
    int attempts = 0;
    bool isLate = false;    ///< predicted too late: no points
    bool isPending = false; ///< the teacher must give the points
    Answer answer;          ///< without the set-up
};

struct GradedWork {
    std::string file;
    std::string name, group;
    int variant = 0;
    std::set<WorkFlag> flags;
    Issues issues;                       ///< faults of an unreadable work
    std::optional<std::size_t> brokenAt; ///< brokenSeal()
    std::vector<std::string> copiedFrom; ///< names of the other students
    std::vector<std::string> untrueRuns; ///< names of kept runs
    std::vector<GradedStep> steps;       ///< one for each step of the lesson; empty if not marked
    double points = 0, most = 0;
    double pending = 0;             ///< points that are the teacher's to give
    std::optional<double> time_min; ///< time of the quickest submitted cycle that passed its step
    std::optional<double> best_min; ///< proved for the variant

    /// Best time divided by time, 1 at the best.
    [[nodiscard]] std::optional<double> nearness() const {
        return time_min && best_min ? std::optional(*best_min / *time_min) : std::nullopt;
    }
};

/// A file that was handed in.
struct HandedIn {
    std::string file;
    std::string text;
};

/// The works of a class, of which one at a time is in memory.
struct ClassWorks {
    ClassWorks(std::size_t howMany, std::function<HandedIn(std::size_t)> reader)
        : count(howMany), read(std::move(reader)) {}
    /// The files must outlive it.
    ClassWorks(const std::vector<HandedIn>& files) // NOLINT(google-explicit-constructor)
        : ClassWorks(files.size(), [&files](std::size_t i) { return files[i]; }) {}

    std::size_t count = 0;
    std::function<HandedIn(std::size_t)> read;
};

struct GradeWish {
    std::vector<Student> group; ///< for finding missing students; empty: not checked
    /// The teacher's table; if empty, best answers are searched where needed, and variants are
    /// checked against the lesson alone.
    std::vector<BestRow> best;
    /// Greatest time for reading a work, and for marking it; a usual one takes 0.1 s. The rest is
    /// left to the teacher.
    std::chrono::duration<double> budget = std::chrono::seconds(10);
};

/// Marks one work by itself, without comparison with others.
[[nodiscard]] GradedWork gradeWork(const Lesson& lesson, HandedIn handedIn, const GradeWish& wish,
                                   const std::stop_token& stop = {});

/// Marks a class, in the order of the works; then lists missing students, in the order of the list.
/// `note` is called after each work with the number of marked ones. A stop keeps those marked
/// before it, without missing students.
[[nodiscard]] std::vector<GradedWork> gradeClass(const Lesson& lesson, const ClassWorks& handedIn,
                                                 const GradeWish& wish,
                                                 const std::stop_token& stop = {},
                                                 const std::function<void(std::size_t)>& note = {});

/// The results of checking an answer to each step of a lesson.
struct CheckedSteps {
    Lesson lesson;
    std::vector<GoalResult> steps;
};

/// Checks each step as given, before the student changes anything. If the lesson asks for the best
/// cycle, its time is searched first.
[[nodiscard]] CheckedSteps checkedAsGiven(Lesson lesson, const std::stop_token& stop = {});

/// The last answers of a work, checked by the engine.
[[nodiscard]] CheckedSteps checkedAnswers(const Work& work);

// The marks of a class as a table: one description for all file formats.

/// Empty, a count, a number, or a text.
using GradeCell = std::variant<std::monostate, int, double, std::string>;

struct GradeColumn {
    static constexpr int asGiven = -1; ///< keep the decimals of the numbers

    std::string key;   ///< "step_1_points": in a file for programs
    std::string title; ///< "step 1": in a file for people
    int decimals = 0;  ///< decimals of its numbers in display
};

struct GradeTable {
    std::vector<GradeColumn> columns;
    std::vector<std::vector<GradeCell>> rows;
};

/// The notation of a work's flags: a function such as flagKey().
struct FlagStyle {
    const char* (*word)(WorkFlag) = flagKey;
    const char* separator = " ";
};

/// A row for every work: name, group, variant, flags, points by step, sum, times.
[[nodiscard]] GradeTable gradeTable(const Lesson& lesson, const std::vector<GradedWork>& works,
                                    FlagStyle flags = {});

/// The table with a row of keys as CSV in UTF-8.
[[nodiscard]] std::string gradesCsv(const Lesson& lesson, const std::vector<GradedWork>& works);

} // namespace sparkout
