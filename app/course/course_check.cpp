// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/course/course_check.h"

#include "app/io/cli_io.h"
#include "app/io/cli_kept_runs.h"
#include "core/course/variant.h"
#include "core/course/work_file.h"
#include "core/course/work_seal.h"
#include "core/format/project_file.h"
#include "core/lesson/goal_check.h"
#include "core/lesson/lesson_file.h"
#include "core/printable.h"
#include "core/setup/setup_file.h"
#include "words/lesson_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <string_view>
#include <utility>

namespace sparkout::cli {

namespace {

using nlohmann::ordered_json;

ordered_json stepJson(const Lesson& lesson, std::size_t step, const GoalResult& result) {
    const auto orNull = [](const std::optional<double>& value) {
        return value ? ordered_json(*value) : ordered_json(nullptr);
    };
    ordered_json failing = ordered_json::array();
    for (const ConstraintKind kind : result.failing) {
        failing.push_back(requirementOf(kind).key);
    }
    return {{"step", step + 1},
            {"goal", goalKey(lesson.steps[step].goal.kind())},
            {"points", lesson.steps[step].points},
            {"finding", findingKey(result.finding)},
            {"value", orNull(result.value)},
            {"asked", orNull(result.asked)},
            {"failing", std::move(failing)}};
}

/// What each step of a lesson finds in an answer of it.
template <class AnswerOf>
int printSteps(const Lesson& lesson, bool json, ordered_json root, const AnswerOf& answerOf) {
    ordered_json list = ordered_json::array();
    std::string text;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        const GoalResult result = checkStep(lesson, i, answerOf(i));
        list.push_back(stepJson(lesson, i, result));
        text += "step " + std::to_string(i + 1) + "  " + goalKey(lesson.steps[i].goal.kind()) + "  "
                + goalSentence(lesson.steps[i].goal, result) + '\n';
    }
    root["steps"] = std::move(list);
    print(stdout, json ? root.dump(2) + '\n' : text);
    return done;
}

/// A lesson, each step as it is given: what a student finds before he does anything.
int checkLessonFile(const std::string& file, const std::string& content, bool json) {
    const ReadLesson read = readLesson(content);
    printIssues(file, read.issues);
    if (!read.lesson) {
        return refused;
    }
    Lesson lesson = *read.lesson;
    if (asksForBest(lesson)) { // else nobody knows what time is asked for
        const auto best = bestAnswer(lesson.base.surfaces[variedSurface(lesson)].project);
        lesson =
            withVariant(std::move(lesson), {}, best ? std::optional(best->time_min) : std::nullopt);
    }
    return printSteps(lesson, json, {{"lesson", lesson.title.in(false)}}, [&](std::size_t step) {
        Answer answer;
        answer.setup.text = writeSetup(setupOf(lesson, step));
        return answer;
    });
}

/// A work by itself: its seals, and its answers by the engine.
int checkWorkFile(const std::string& file, const std::string& content, bool json) {
    const ReadWork read = readWork(content);
    printIssues(file, read.issues);
    if (!read.work) {
        return refused;
    }
    const Work& work = *read.work;
    const auto broken = brokenSeal(work);
    if (broken) {
        print(stderr, printable(file) + ": "
                          + (*broken == 0 ? std::string("the seal of the work does not hold")
                                          : "the seal of entry " + std::to_string(*broken)
                                                + " does not hold")
                          + ": it was edited outside the program\n");
    }
    const int status = printSteps(
        work.lesson, json,
        {{"name", work.name},
         {"group", work.group},
         {"variant", work.variant},
         {"sealed", !broken}},
        [&](std::size_t step) { return recordOf(work, step).answer.value_or(Answer()); });
    return broken ? static_cast<int>(requirementFails) : status;
}

int checkProjectFile(const std::string& file, bool json) {
    const auto setup = loadSetup(file);
    if (!setup) {
        return refused;
    }
    bool isTrue = true;
    ordered_json surfaces = ordered_json::array();
    for (const GroundSurface& surface : setup->surfaces) {
        const std::vector<std::string> untrue = printUntrueRuns(
            surface.name.empty() ? file : file + ": surface " + surface.name, surface.project);
        surfaces.push_back({{"name", surface.name},
                            {"kept_runs", surface.project.runs.size()},
                            {"untrue_runs", untrue}});
        isTrue = isTrue && untrue.empty();
    }
    if (json) {
        print(stdout, ordered_json{{"surfaces", std::move(surfaces)}}.dump(2) + '\n');
    }
    return isTrue ? done : requirementFails;
}

bool endsAs(std::string_view file, std::string_view extension) {
    return file.size() >= extension.size()
           && file.substr(file.size() - extension.size()) == extension;
}

} // namespace

int runCourseCheck(const CourseOptions& options) {
    const std::string& file = options.operands.front();
    const bool isLesson = endsAs(file, ".sparkout-lesson"), isWork = endsAs(file, ".sparkout-work");
    if (!isLesson && !isWork) {
        return checkProjectFile(file, options.json);
    }
    const auto content = readOrSay(file, limits::fileBytes);
    if (!content) {
        return refused;
    }
    return isLesson ? checkLessonFile(file, *content, options.json)
                    : checkWorkFile(file, *content, options.json);
}

} // namespace sparkout::cli
