// SPDX-License-Identifier: GPL-3.0-or-later
// Labels: unsanitized
// The words of goals and of their results, for every step of the shipped lessons.
#include "words/goal_words.h"

#include "core/digits.h"
#include "tests/core/lesson/lesson_samples.h"
#include "tests/registry.h"

#include <QTest>

#include <functional>
#include <set>

namespace sparkout::test_goal_words {

/// Marks each text that is translated, so that an unmarked one stands out.
class Marked : public GoalWording {
protected:
    [[nodiscard]] std::string translated(const char*, const char* text) const override {
        return '<' + std::string(text) + '>';
    }
};

void ofEachStep(const std::function<void(const Lesson&, std::size_t)>& check) {
    for (const auto& file : samples::lessonFiles()) {
        const Lesson lesson = readLesson(samples::readText(file)).lesson.value();
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            check(lesson, step);
        }
    }
}

bool contains(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

class TestGoalWords : public QObject {
    Q_OBJECT

private slots:
    void questionOfEachStepIsACompleteSentence() {
        std::set<GoalKind> kinds;
        ofEachStep([&](const Lesson& lesson, std::size_t step) {
            const Goal& goal = lesson.steps[step].goal;
            const std::string asked = GoalWording().asked(goal, projectOf(lesson, step));
            QVERIFY2(asked.ends_with('.') && !contains(asked, "{"), asked.c_str());
            kinds.insert(goal.kind());
            if (goal.asked()) {
                const std::string label = rowOf(goal.asked()->name).choice.label;
                QVERIFY2(contains(asked, label.substr(1)), asked.c_str());
            }
        });
        QCOMPARE(kinds.size(), std::size_t{8}); // every kind occurs
    }

    /// A student who hands in nothing reads no number; the teacher reads the engine's.
    void unansweredQuestionRevealsNothingToAStudent() {
        int revealed = 0;
        ofEachStep([&](const Lesson& lesson, std::size_t step) {
            const Goal& goal = lesson.steps[step].goal;
            if (!isAnsweredByEngine(goal.kind())) {
                return;
            }
            const GoalResult result = checkStep(lesson, step, {});
            if (result.finding != Finding::notAnswered) {
                return; // a figure of a search, which is not proved here
            }
            const Project& project = projectOf(lesson, step);
            QCOMPARE(GoalWording().found(goal, result, project, false),
                     std::string("not answered"));
            const std::string shown = GoalWording().found(goal, result, project, true);
            if (goal.prediction) {
                const int digits = rowOf(goal.prediction->figure.name).digits;
                QVERIFY2(contains(shown, fixed(*result.value, digits)), shown.c_str());
                ++revealed;
            }
            if (goal.order) {
                QVERIFY2(contains(shown, GoalWording().order(project, result.order)),
                         shown.c_str());
                ++revealed;
            }
        });
        QVERIFY(revealed > 20);
    }

    void predictionStandsBesideTheResult() {
        int compared = 0;
        ofEachStep([&](const Lesson& lesson, std::size_t step) {
            const Goal& goal = lesson.steps[step].goal;
            if (!goal.prediction) {
                return;
            }
            Answer answer;
            answer.number = -987654321;
            const GoalResult result = checkStep(lesson, step, answer);
            if (!result.value) {
                return;
            }
            ++compared;
            const std::string text =
                GoalWording().found(goal, result, projectOf(lesson, step), false);
            QVERIFY2(text.starts_with("not passed: ") && contains(text, "-987654321")
                         && contains(text, fixed(*result.value,
                                                 rowOf(goal.prediction->figure.name).digits)),
                     text.c_str());
        });
        QVERIFY(compared > 20);
    }

    void everySentenceIsTranslated() {
        ofEachStep([&](const Lesson& lesson, std::size_t step) {
            const std::string asked =
                Marked().asked(lesson.steps[step].goal, projectOf(lesson, step));
            QVERIFY2(asked.starts_with('<') && asked.ends_with('>'), asked.c_str());
        });
        GoalResult result;
        for (int i = 0; i < findings; ++i) {
            result.finding = static_cast<Finding>(i);
            Goal goal;
            goal.text.emplace();
            QCOMPARE(Marked().found(goal, result, {}, true),
                     '<' + std::string(findingText(result.finding)) + '>');
        }
    }

    void failedRequirementsAndLockedInputsAreNamed() {
        Goal goal;
        goal.requirements.emplace();
        GoalResult result;
        result.finding = Finding::failed;
        result.value = -12.34;
        result.failingStocks_percent = 7;
        result.failing = {ConstraintKind::roundness, ConstraintKind::roughness};
        QCOMPARE(GoalWording().found(goal, result, {}, true),
                 std::string("not passed: minimum margin -12.3 %; unfit for 7 % of stocks; "
                             "not met: roundness, roughness Ra"));
        result = {};
        result.finding = Finding::forbidden;
        result.forbidden = {"/wheel/width_mm", "/cycle"};
        QCOMPARE(GoalWording().found(goal, result, {}, true),
                 std::string("locked inputs were changed: /wheel/width_mm; /cycle"));
    }
};

} // namespace sparkout::test_goal_words

SPARKOUT_TEST(test_goal_words, TestGoalWords)
#include "test_goal_words.moc"
