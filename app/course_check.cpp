// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/cli_io.h"
#include "core/file/project_file.h"
#include "core/lesson/grading.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/work.h"
#include "core/printable.h"
#include "words/goal_words.h"
#include "words/lesson_words.h"

#include <nlohmann/json.hpp>

#include <optional>
#include <string_view>
#include <utility>

namespace sparkout::cli {

namespace {

using nlohmann::ordered_json;

void printSteps(const CheckedSteps& checked, const std::optional<std::string>& json) {
    std::string text;
    for (std::size_t i = 0; i < checked.steps.size(); ++i) {
        const Goal& goal = checked.lesson.steps[i].goal;
        text += "step " + std::to_string(i + 1) + "  " + goalKey(goal.kind()) + "  "
                + GoalWording().found(goal, checked.steps[i], projectOf(checked.lesson, i), true)
                + '\n';
    }
    print(stdout, json.value_or(text));
}

int checkLessonFile(const std::string& file, const std::string& content, bool json) {
    const ReadLesson read = readLesson(content);
    printIssues(file, read.issues);
    if (!read.lesson) {
        return refused;
    }
    const CheckedSteps checked = checkedAsGiven(*read.lesson);
    printSteps(checked, json ? std::optional(lessonCheckJson(checked)) : std::nullopt);
    return done;
}

/// Checks a single work: its seals, and its answers by the engine.
int checkWorkFile(const std::string& file, const std::string& content, bool json) {
    const ReadWork read = readWork(content);
    printIssues(file, read.issues);
    if (!read.work) {
        return refused;
    }
    const Work& work = *read.work;
    const auto broken = brokenSeal(work);
    if (broken) {
        print(stderr,
              printable(file) + ": "
                  + (*broken == 0 ? std::string("the seal of the work is broken")
                                  : "the seal of entry " + std::to_string(*broken) + " is broken")
                  + ": it was edited outside the program\n");
    }
    const CheckedSteps checked = checkedAnswers(work);
    printSteps(checked, json ? std::optional(workCheckJson(work, checked)) : std::nullopt);
    return broken ? static_cast<int>(requirementFails) : static_cast<int>(done);
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

int runCourseCheck(const manual::Given& given) {
    const std::string& file = given.operands.front();
    const bool isLesson = endsAs(file, ".sparkout-lesson"), isWork = endsAs(file, ".sparkout-work");
    if (!isLesson && !isWork) {
        return checkProjectFile(file, given.has("--json"));
    }
    const auto content = readOrSay(file, limits::fileBytes);
    if (!content) {
        return refused;
    }
    return isLesson ? checkLessonFile(file, *content, given.has("--json"))
                    : checkWorkFile(file, *content, given.has("--json"));
}

} // namespace sparkout::cli
