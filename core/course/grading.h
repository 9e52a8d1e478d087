// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/best_table.h"
#include "core/course/group_list.h"
#include "core/course/work.h"
#include "core/issue.h"
#include "core/lesson/goal_check.h"

#include <chrono>
#include <cstddef>
#include <functional>
#include <optional>
#include <set>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

/// Marking: every answer is computed again by the engine from the teacher's lesson. Nothing that a
/// work says of its results, of its lesson or of its variant is taken on trust.
namespace sparkout {

/// What is to be looked at in a work; the teacher decides what follows from it.
enum class WorkFlag {
    unreadable,    ///< the file is none, or has faults: nothing was marked
    foreign,       ///< of another lesson, or another version of it: nothing was marked
    edited,        ///< a seal is broken, or the lesson or variant in it is not the one given out
    copied,        ///< its variant or its entries are those of another student's work
    handedInTwice, ///< there is another work of the same student
    notInGroup,    ///< the list has no such student
    untrueRuns,    ///< numbers of a kept run are not the engine's
    late,          ///< a prediction came after what it predicts
    forbidden,     ///< inputs were changed that are not free
    missing,       ///< nothing was handed in
    overBudget,    ///< it took too long: some of it was not looked at
};
inline constexpr int workFlags = static_cast<int>(WorkFlag::overBudget) + 1;

[[nodiscard]] const char* flagKey(WorkFlag flag);

struct GradedStep {
    GoalResult result;
    double points = 0;
    double most = 0;
    double hints = 0; ///< what they cost
    int attempts = 0;
    bool isLate = false;    ///< predicted too late, which gives no points
    bool isPending = false; ///< for the teacher to give the points of
    Answer answer;          ///< without its set-up
};

struct GradedWork {
    std::string file;
    std::string name, group;
    int variant = 0;
    std::set<WorkFlag> flags;
    Issues issues;                       ///< of an unreadable one
    std::optional<std::size_t> brokenAt; ///< brokenSeal()
    std::vector<std::string> copiedFrom; ///< names of the others
    std::vector<std::string> untrueRuns; ///< names of kept runs
    std::vector<GradedStep> steps;       ///< as many as the lesson has; none where not marked
    double points = 0, most = 0;
    double pending = 0;             ///< points that are the teacher's to give
    std::optional<double> time_min; ///< of the quickest cycle handed in that passed its step
    std::optional<double> best_min; ///< proved for the variant

    /// How near to the best: best over time, 1 at the best.
    [[nodiscard]] std::optional<double> nearness() const {
        return time_min && best_min ? std::optional(*best_min / *time_min) : std::nullopt;
    }
};

/// A file as it was handed in.
struct HandedIn {
    std::string file;
    std::string text;
};

/// The works of a class, of which one at a time is held in memory.
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
    std::vector<Student> group; ///< to name who is missing; none: not asked
    /// The teacher's table; none: the best answers are searched for where they are needed, and
    /// variants are held against the lesson alone.
    std::vector<BestRow> best;
    /// What reading a work may take, and what marking it may: a usual one takes 0.1 s. What is not
    /// looked at by then is left to the teacher.
    std::chrono::duration<double> budget = std::chrono::seconds(10);
};

/// Marks one work by itself: all but what comparing works tells.
[[nodiscard]] GradedWork gradeWork(const Lesson& lesson, HandedIn handedIn, const GradeWish& wish,
                                   const std::stop_token& stop = {});

/// Marks a class, in the order of the works; then those who are missing, in the order of the list.
/// `note` is called after each work with how many are marked. A stop leaves those marked before it,
/// and nobody is named as missing.
[[nodiscard]] std::vector<GradedWork> gradeClass(const Lesson& lesson, const ClassWorks& handedIn,
                                                 const GradeWish& wish,
                                                 const std::stop_token& stop = {},
                                                 const std::function<void(std::size_t)>& note = {});

} // namespace sparkout
