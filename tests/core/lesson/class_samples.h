// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal_check.h"
#include "core/lesson/make_variants.h"
#include "core/lesson/work.h"
#include "core/project/cycle.h"
#include "core/setup/setup_file.h"
#include "tests/core/lesson/lesson_samples.h"

#include <string>
#include <vector>

/// A class and a scripted student, who knows what the engine says.
namespace sparkout::samples {

inline std::vector<Student> students(std::size_t count) {
    std::vector<Student> all;
    for (std::size_t i = 0; i < count; ++i) {
        all.push_back({"Студент " + std::to_string(i + 1), i % 2 == 0 ? "ТМ-31" : "ТМ-32"});
    }
    return all;
}

struct GivenOut {
    Lesson lesson;
    std::vector<Student> group;
    MadeVariants made;
    std::vector<Work> works; ///< as given out
};

inline GivenOut giveOut(const Lesson& lesson, std::size_t count, std::uint32_t seed) {
    GivenOut out{lesson, students(count), makeVariants(lesson, count, seed), {}};
    for (std::size_t i = 0; i < out.made.variants.size(); ++i) {
        const MadeVariant& variant = out.made.variants[i];
        out.works.push_back(
            newWork(lesson, variant.levels,
                    variant.best ? std::optional(variant.best->time_min) : std::nullopt,
                    static_cast<int>(i) + 1, out.group[i].name, out.group[i].group));
    }
    return out;
}

/// What the script hands in for a step: the right answer, or a wrong one.
inline Answer scripted(const GivenOut& out, std::size_t student, std::size_t step, bool right) {
    const Lesson& lesson = out.works[student].lesson;
    const Goal& goal = lesson.steps[step].goal;
    Answer answer;
    if (goal.choice) {
        answer.chosen = {{right ? 1.0 : 2.0}};
    } else if (goal.text) {
        answer.text = "РЗ1 видит за двойной ход пять шагов, НЗ — два: пока деформация не сошла, "
                      "РЗ1 снимает больше, и её диаметр меньше. При вдвое меньшей податливости "
                      "зоны различаются меньше.";
    } else if (goal.time || goal.requirements) {
        Setup setup = setupOf(lesson, step);
        if (right) {
            setup.surfaces.front().project.cycle =
                solving(out.made.variants[student].best->project, goal).cycle;
        }
        answer.setup.text = writeSetup(setup);
    } else if (goal.figure) {
        Setup setup = setupOf(lesson, step);
        if (right) { // the feed at which it is met, by trying
            for (double feed_mm = 0.0002; feed_mm < 0.005; feed_mm += 0.0001) {
                setup.surfaces.front().project.cycle->stages[1].radial_feed_mm = feed_mm;
                answer.setup.text = writeSetup(setup);
                if (checkStep(lesson, step, answer).passed()) {
                    break;
                }
            }
        }
        answer.setup.text = writeSetup(setup);
    } else {
        const GoalResult engine = checkStep(lesson, step, {});
        answer.number =
            goal.prediction ? std::optional(*engine.value * (right ? 1 : 3)) : std::nullopt;
        if (goal.curve) {
            answer.curve.emplace();
            for (const ComparedPoint& point : engine.curve) {
                answer.curve->push_back({point.at, right ? point.value : point.value + 9});
            }
        }
        if (goal.order) {
            answer.order.emplace(engine.order.begin(), engine.order.end());
            if (!right) {
                std::swap(answer.order->front(), answer.order->back());
            }
        }
    }
    return answer;
}

inline void handIn(Work& work, std::size_t step, Answer answer, const std::string& when) {
    const bool predicts = isPrediction(work.lesson.steps[step].goal);
    WorkEntry entry;
    entry.event = predicts ? WorkEvent::prediction : WorkEvent::attempt;
    entry.step = static_cast<int>(step) + 1;
    entry.when = when;
    entry.answer = std::move(answer);
    addEntry(work, std::move(entry));
}

inline void takeHint(Work& work, std::size_t step, int hint, const std::string& when) {
    WorkEntry entry;
    entry.event = WorkEvent::hint;
    entry.step = static_cast<int>(step) + 1;
    entry.when = when;
    entry.hint = hint;
    addEntry(work, std::move(entry));
}

/// Every step answered, those of `wrong` (from 1) wrongly. Each student works at his own times.
inline Work solved(const GivenOut& out, std::size_t student,
                   const std::vector<std::size_t>& wrong = {}) {
    Work work = out.works[student];
    for (std::size_t step = 0; step < work.lesson.steps.size(); ++step) {
        const bool right = std::find(wrong.begin(), wrong.end(), step + 1) == wrong.end();
        handIn(work, step, scripted(out, student, step, right),
               "2026-11-26T10:" + std::to_string(10 + step) + ":" + std::to_string(10 + student)
                   + "Z");
    }
    return work;
}

} // namespace sparkout::samples
