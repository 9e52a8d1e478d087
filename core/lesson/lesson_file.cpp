// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_file.h"

#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/lesson/lesson_json.h"
#include "core/lesson/text_markup.h"
#include "core/project/cycle.h"
#include "core/project/member.h"
#include "core/project/number_input.h"
#include "core/project/validate.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::json;

Detail quotedText(const std::string& text) {
    return quoted(json(text));
}

Bounds boundsTo(double low, double high, std::string_view unit = {}) {
    return {{low, high}, unit};
}

class LessonCheck {
public:
    LessonCheck(const Lesson& lesson, LessonOf of) : m_lesson(lesson), m_of(of) {}

    Issues run() {
        needText(m_lesson.title, "/title", limits::lessonTitle);
        checkText(m_lesson.aim, "/aim", limits::lessonLine);
        checkText(m_lesson.theory, "/theory", limits::lessonText);
        for (std::size_t i = 0; i < m_lesson.steps.size(); ++i) {
            checkStep(m_lesson.steps[i], "/steps/" + std::to_string(i));
        }
        if (m_lesson.variants) {
            checkVariants(*m_lesson.variants);
        }
        if (m_lesson.guide) {
            checkGuide(*m_lesson.guide);
        }
        return std::move(m_issues);
    }

private:
    void add(IssueCode code, const std::string& path, Detail value, Detail limit) {
        addIssue(m_issues, {code, Severity::error, path, std::move(value), std::move(limit)});
    }

    void needText(const Bilingual& text, const std::string& path,
                  const TextSize& most = limits::lessonText) {
        if (text.empty()) {
            add(IssueCode::missingKey, path, {}, Keys{{"ru", "en"}, Keys::Kind::alternatives});
        }
        checkText(text, path, most);
    }

    /// Checks the length and the tags: kinds, number and depth.
    void checkText(const Bilingual& text, const std::string& path, const TextSize& most) {
        for (const auto& [key, each] : {std::pair{"/ru", &text.ru}, std::pair{"/en", &text.en}}) {
            if (each->size() > most.bytes) {
                add(IssueCode::stringTooLong, path + key, countOf(each->size(), "bytes"),
                    countOf(most.bytes, "bytes"));
            } else if (const auto tag = foreignTag(*each)) {
                Keys tags{{}, Keys::Kind::alternatives};
                tags.keys.assign(textTags().begin(), textTags().end());
                add(IssueCode::notOneOf, path + key, quotedText(*tag), std::move(tags));
            } else {
                const TagCounts counts = countTags(*each);
                checkCount(path + key, counts.tags, most.tags, "tags");
                checkCount(path + key, counts.depth, limits::lessonTagDepth, "nested tags");
            }
        }
    }

    void checkCount(const std::string& path, std::size_t count, std::size_t most,
                    std::string_view unit) {
        if (count > most) {
            add(IssueCode::outOfRange, path, countOf(count, unit),
                boundsTo(0, static_cast<double>(most), unit));
        }
    }

    /// The project of a surface counted from 1; null if there is none, which is reported.
    const Project* surface(int number, const std::string& path) {
        const auto count = m_lesson.base.surfaces.size();
        if (number < 1 || static_cast<std::size_t>(number) > count) {
            add(IssueCode::outOfRange, path + "/surface", Count{number},
                boundsTo(1, static_cast<double>(count)));
            return nullptr;
        }
        return &m_lesson.base.surfaces[static_cast<std::size_t>(number) - 1].project;
    }

    void checkStep(const LessonStep& step, const std::string& path) {
        needText(step.task, path + "/task");
        const Project* const project = surface(step.surface, path);
        if (!project) {
            return;
        }
        checkAccess(step, *project, path);
        checkValues(step, path);
        checkGoal(step.goal, *project, path + "/goal");
        double prices = 0;
        for (std::size_t i = 0; i < step.hints.size(); ++i) {
            const std::string at = path + "/hints/" + std::to_string(i);
            needText(step.hints[i].text, at + "/text", limits::lessonLine);
            prices += step.hints[i].price;
            if (prices > step.points) {
                add(IssueCode::outOfRange, at + "/price", Amount{step.hints[i].price, "points"},
                    boundsTo(0, step.points - (prices - step.hints[i].price), "points"));
                break;
            }
        }
        if (step.moment) {
            checkMoment(*step.moment, *project, path + "/moment");
        }
    }

    void checkAccess(const LessonStep& step, const Project& project, const std::string& path) {
        std::set<std::string> known;
        for (const Leaf& leaf : leavesOf(tableOf<Project>(), &project)) {
            for (std::string at = leaf.path; !at.empty(); at.resize(at.rfind('/'))) {
                known.insert(at);
            }
        }
        std::set<std::string> seen;
        for (std::size_t i = 0; i < step.inputs.size(); ++i) {
            const std::string& input = step.inputs[i].path;
            const std::string at = path + "/inputs/" + std::to_string(i) + "/path";
            if (!known.contains(input)) {
                add(IssueCode::noSuchInput, at, quotedText(input), Phrase::pathOfInput);
            } else if (!seen.insert(input).second) {
                add(IssueCode::duplicateKey, at, quotedText(input), {});
            }
        }
    }

    /// Checks each value by itself, then the project with all of them.
    void checkValues(const LessonStep& step, const std::string& path) {
        Setup setup = m_lesson.base;
        const auto index = static_cast<std::size_t>(step.surface) - 1;
        bool isReadable = true;
        for (std::size_t i = 0; i < step.values.size(); ++i) {
            const std::string at = path + "/values/" + std::to_string(i) + "/path";
            if (!putInput(setup, index, step.values[i])) {
                add(IssueCode::noSuchInput, at, quotedText(step.values[i].path),
                    Phrase::pathOfInput);
                isReadable = false;
            }
        }
        if (isReadable && !step.values.empty()) {
            addFaultsOf(setup.surfaces[index].project, path + "/values");
        }
    }

    void addFaultsOf(const Project& project, const std::string& path) {
        for (Issue& issue : validate(project)) {
            if (issue.severity == Severity::error) {
                issue.path = path + issue.path;
                addIssue(m_issues, std::move(issue));
            }
        }
    }

    // --- goals ----------------------------------------------------------------------------------

    void checkGoal(const Goal& goal, const Project& project, const std::string& path) {
        if (goal.count() != 1) {
            Keys kinds{{}, Keys::Kind::alternatives};
            for (const Field& field : tableOf<Goal>().fields) {
                kinds.keys.emplace_back(field.key);
            }
            add(IssueCode::wrongCount, path, Count{goal.count()}, std::move(kinds));
            return;
        }
        const std::string at = path + "/" + goalKey(goal.kind());
        if (goal.time && !goal.time->below_min && !goal.time->within_percent_of_best) {
            add(IssueCode::missingKey, at + "/below_min", {}, Phrase::number);
        }
        if (const Figure* figure = goal.asked()) {
            checkFigure(*figure, goal, project, at + "/figure");
        }
        if (goal.curve) {
            checkCurve(*goal.curve, project, at);
        }
        if (goal.choice) {
            checkChoice(*goal.choice, at);
        }
    }

    /// A goal along places or stages does not need these of the figure.
    void checkFigure(const Figure& figure, const Goal& goal, const Project& project,
                     const std::string& path) {
        const FigureScope scope = rowOf(figure.name).scope;
        const bool alongPlaces =
            goal.order || (goal.curve && goal.curve->along == CurveAlong::place);
        const bool alongStages = goal.curve && goal.curve->along == CurveAlong::stage;
        const bool needsPlace = isOfPlace(scope) && !alongPlaces;
        if (figure.place.isGiven() ? !hasPlace(project, figure.place) : needsPlace) {
            addPlace(figure.place, project, path + "/place");
        }
        const bool ofBatch = scope == FigureScope::batch || scope == FigureScope::batchPlace;
        if ((ofBatch && !project.batch)
            || (scope == FigureScope::search && !project.optimisation)) {
            add(IssueCode::missingKey, ofBatch ? "/project/batch" : "/project/optimisation", {},
                Phrase::object);
        }
        checkStage(figure.stage, scope == FigureScope::stage && !alongStages, project,
                   path + "/stage");
        checkStrokeStep(figure.step, project, path + "/step");
    }

    void addPlace(const PlaceName& place, const Project& project, const std::string& path) {
        const bool isMissing = !place.isGiven();
        const auto code = isMissing ? IssueCode::missingKey : IssueCode::notOneOf;
        const Detail value = isMissing    ? Detail()
                             : place.zone ? quotedText(PlaceName::words()[place.index()].key)
                                          : Detail(countOf(place.index()));
        if (project.operation->travels) {
            add(code, path, value, Keys{{"rz1", "nz", "rz2"}, Keys::Kind::choices});
        } else {
            add(code, path, value, boundsTo(0, placeCount(project) - 1));
        }
    }

    void checkStage(std::optional<int> stage, bool isNeeded, const Project& project,
                    const std::string& path) {
        const auto stages = static_cast<double>(project.cycle->stages.size());
        if (!stage && isNeeded) {
            add(IssueCode::missingKey, path, {}, boundsTo(1, stages));
        } else if (stage && *stage > stages) {
            add(IssueCode::outOfRange, path, Count{*stage}, boundsTo(1, stages));
        }
    }

    void checkStrokeStep(Step step, const Project& project, const std::string& path) {
        if (step != Step::none && !project.operation->travels) {
            add(IssueCode::notOneOf, path,
                quotedText(choicesOf<Step>()[static_cast<std::size_t>(step)].key),
                Keys{{choicesOf<Step>().front().key}, Keys::Kind::choices});
        }
    }

    void checkCurve(const CurvePrediction& curve, const Project& project, const std::string& path) {
        const double low = curve.along == CurveAlong::place ? 0 : 1;
        const double high = curve.along == CurveAlong::place ? placeCount(project) - 1
                            : curve.along == CurveAlong::stage
                                ? static_cast<double>(project.cycle->stages.size())
                                : 10'000'000;
        if (curve.at.size() < 2 || curve.at.size() > 1000) {
            add(IssueCode::wrongCount, path + "/at", countOf(curve.at.size()), boundsTo(2, 1000));
        }
        for (std::size_t i = 0; i < curve.at.size(); ++i) {
            const double x = curve.at[i];
            const std::string at = path + "/at/" + std::to_string(i);
            if (x != std::floor(x)) {
                add(IssueCode::wrongType, at, Amount{x}, Phrase::wholeNumber);
            } else if (x < low || x > high || (i > 0 && x <= curve.at[i - 1])) {
                const double from = i > 0 ? std::max(low, curve.at[i - 1] + 1) : low;
                add(IssueCode::outOfRange, at, Amount{x}, boundsTo(from, high));
            }
        }
    }

    void checkChoice(const ChoiceGoal& choice, const std::string& path) {
        std::size_t right = 0;
        for (std::size_t i = 0; i < choice.options.size(); ++i) {
            needText(choice.options[i].text, path + "/options/" + std::to_string(i) + "/text",
                     limits::lessonLine);
            right += choice.options[i].right ? 1 : 0;
        }
        if (m_of == LessonOf::teacher && right == 0) {
            add(IssueCode::missingKey, path + "/options", {}, Keys{{"right"}});
        }
    }

    void checkMoment(const ShownMoment& moment, const Project& project, const std::string& path) {
        if (!moment.view.empty() && !viewNamed(moment.view)) {
            Keys views{{}, Keys::Kind::choices};
            for (const Choice& each : choicesOf<Hideable>()) {
                if (viewNamed(each.key)) {
                    views.keys.emplace_back(each.key);
                }
            }
            add(IssueCode::notOneOf, path + "/view", quotedText(moment.view), std::move(views));
        }
        if (moment.place.isGiven() && !hasPlace(project, moment.place)) {
            addPlace(moment.place, project, path + "/place");
        }
        checkStage(moment.stage, false, project, path + "/stage");
        checkStrokeStep(moment.step, project, path + "/step");
    }

    void checkGuide(const TeachingGuide& guide) {
        for (std::size_t i = 0; i < guide.questions.size(); ++i) {
            const std::string at = "/guide/questions/" + std::to_string(i);
            needText(guide.questions[i].question, at + "/question");
            needText(guide.questions[i].answer, at + "/answer");
        }
        for (std::size_t i = 0; i < guide.mistakes.size(); ++i) {
            needText(guide.mistakes[i].text, "/guide/mistakes/" + std::to_string(i) + "/text");
        }
    }

    // --- variants -------------------------------------------------------------------------------

    void checkVariants(const VariantRules& rules) {
        const Project* const project = surface(rules.surface, "/variants");
        if (!project) {
            return;
        }
        std::set<std::string> varied;
        for (std::size_t i = 0; i < rules.inputs.size(); ++i) {
            checkVaried(rules.inputs[i], *project, "/variants/inputs/" + std::to_string(i), varied);
        }
        for (std::size_t i = 0; i < rules.figures.size(); ++i) {
            checkBound(rules.figures[i], "/variants/figures/" + std::to_string(i));
        }
    }

    void checkBound(const FigureBound& bound, const std::string& path) {
        const auto steps = m_lesson.steps.size();
        if (bound.step < 1 || static_cast<std::size_t>(bound.step) > steps) {
            add(IssueCode::outOfRange, path + "/step", Count{bound.step},
                boundsTo(1, static_cast<double>(steps)));
            return;
        }
        if (!bound.least && !bound.most) {
            add(IssueCode::missingKey, path + "/least", {}, Phrase::number);
        }
        const int number = m_lesson.steps[static_cast<std::size_t>(bound.step) - 1].surface;
        if (number >= 1 && static_cast<std::size_t>(number) <= m_lesson.base.surfaces.size()) {
            checkFigure(bound.figure, {},
                        m_lesson.base.surfaces[static_cast<std::size_t>(number) - 1].project,
                        path + "/figure");
        }
    }

    void checkVaried(const VariedInput& input, const Project& project, const std::string& path,
                     std::set<std::string>& varied) {
        if (input.alternatives() != 1) {
            add(IssueCode::wrongCount, path, Count{input.alternatives()},
                Keys{{"from, to, step", "list", "sets"}, Keys::Kind::alternatives});
            return;
        }
        if (input.sets.empty() && !input.list && !input.isRange()) {
            add(IssueCode::missingKey,
                path
                    + (!input.from ? "/from"
                       : !input.to ? "/to"
                                   : "/step"),
                {}, Phrase::number);
            return;
        }
        const double levels = input.levels();
        if (levels < 1 || levels > static_cast<double>(limits::levelsOfInput)) {
            add(IssueCode::wrongCount, path, Amount{levels},
                boundsTo(1, static_cast<double>(limits::levelsOfInput)));
            return;
        }
        if (input.sets.empty()) {
            checkVariedPath({input.path, 0.0, {}}, project, path + "/path", varied);
            return;
        }
        std::set<std::string> ofSets; // the sets may share inputs
        for (std::size_t i = 0; i < input.sets.size(); ++i) {
            std::set<std::string> ofSet = varied;
            for (std::size_t j = 0; j < input.sets[i].values.size(); ++j) {
                checkVariedPath(input.sets[i].values[j], project,
                                path + "/sets/" + std::to_string(i) + "/values/" + std::to_string(j)
                                    + "/path",
                                ofSet);
            }
            ofSets.insert(ofSet.begin(), ofSet.end());
        }
        varied.insert(ofSets.begin(), ofSets.end());
    }

    void checkVariedPath(const InputValue& value, const Project& project, const std::string& path,
                         std::set<std::string>& varied) {
        Project copy = project;
        if (!putInput(copy, value)) {
            add(value.number ? IssueCode::noSuchNumber : IssueCode::noSuchInput, path,
                quotedText(value.path), Phrase::pathOfInput);
        } else if (!varied.insert(value.path).second) {
            add(IssueCode::variedTwice, path, quotedText(value.path), Phrase::anotherInput);
        }
    }

    const Lesson& m_lesson;
    LessonOf m_of;
    Issues m_issues;
};

} // namespace

Issues checkLesson(const Lesson& lesson, LessonOf of) {
    return LessonCheck(lesson, of).run();
}

ReadLesson readLesson(std::string_view text, LessonOf of, const std::stop_token& stop) {
    Issues issues;
    const auto root = parseStrictly(text, issues, stop);
    if (!root || stop.stop_requested()) {
        return {std::nullopt, stop.stop_requested() ? Issues() : std::move(issues)};
    }
    return readLessonJson(*root, of, std::move(issues), stop);
}

ReadLesson readLessonOfAnybody(std::string_view text) {
    ReadLesson read = readLesson(text);
    if (!read.lesson) {
        if (ReadLesson students = readLesson(text, LessonOf::student); students.lesson) {
            return students;
        }
    }
    return read;
}

std::string writeLesson(const Lesson& lesson) {
    return printJson(lessonJson(lesson));
}

} // namespace sparkout
