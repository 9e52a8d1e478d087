// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/goal_check.h"

#include "core/batch/judgement.h"
#include "core/project/validate.h"
#include "core/setup/setup_file.h"
#include "core/setup/worn_project.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <utility>

namespace sparkout {

namespace {

constexpr double hundred = 100; ///< %
const Figure leastMarginFigure{FigureName::leastMargin, {}, {}, {}, Step::none};

/// Tolerance for rounding.
constexpr double lastBit = 1e-9;

bool isWithin(double said, double value, double tolerance) {
    return std::abs(said - value) <= tolerance + lastBit * std::max(1.0, std::abs(value));
}

Finding passedIf(bool passes) {
    return passes ? Finding::passed : Finding::failed;
}

std::vector<ConstraintKind> failingOf(const FigureSource& run) {
    std::vector<ConstraintKind> failing;
    for (const ConstraintResult& each : worstByKind(run.constraints)) {
        if (!each.holds) {
            failing.push_back(each.kind);
        }
    }
    return failing;
}

/// Checks each kind of goal against a run.
class GoalCheck {
public:
    GoalCheck(const FigureSource& run, const Answer& answer) : m_run(run), m_answer(answer) {}

    GoalResult check(const RequirementsGoal& goal) {
        m_result.failing = failingOf(m_run);
        m_result.value = figureValue(leastMarginFigure, m_run);
        m_result.asked = goal.least_margin_percent;
        if (goal.every_stock && m_result.failing.empty()) {
            judgeEveryStock();
        }
        const bool hasMargin = goal.least_margin_percent <= 0
                               || (m_result.value && *m_result.value >= goal.least_margin_percent);
        return done(
            passedIf(m_result.failing.empty() && !m_result.failingStocks_percent && hasMargin));
    }

    GoalResult check(const TimeGoal& goal) {
        m_result.value = m_run.result.time_s / units::secondsPerMinute;
        m_result.asked = goal.below_min;
        if (goal.requirements_hold) {
            m_result.failing = failingOf(m_run);
        }
        if (!goal.below_min) { // it depends on the best time, which is not proved here
            return done(Finding::noSuchFigure);
        }
        return done(passedIf(*m_result.value <= *goal.below_min && m_result.failing.empty()));
    }

    GoalResult check(const FigureGoal& goal) {
        m_result.value = figureValue(goal.figure, m_run);
        m_result.asked = goal.value;
        m_result.tolerance = goal.tolerance;
        return done(m_result.value ? passedIf(isWithin(goal.value, *m_result.value, goal.tolerance))
                                   : Finding::noSuchFigure);
    }

    GoalResult check(const NumberPrediction& goal) {
        m_result.value = figureValue(goal.figure, m_run);
        m_result.asked = m_answer.number;
        if (!m_result.value) {
            return done(Finding::noSuchFigure);
        }
        m_result.tolerance = toleranceOf(goal.tolerance, goal.tolerance_percent, *m_result.value);
        return done(m_answer.number
                        ? passedIf(isWithin(*m_answer.number, *m_result.value, m_result.tolerance))
                        : Finding::notAnswered);
    }

    GoalResult check(const CurvePrediction& goal) {
        std::size_t within = 0;
        for (const double at : goal.at) {
            const auto value = figureValue(along(goal, at), m_run);
            if (!value) {
                return done(Finding::noSuchFigure);
            }
            ComparedPoint point{at, said(at), *value, false};
            point.isWithin =
                point.said
                && isWithin(*point.said, *value,
                            toleranceOf(goal.tolerance, goal.tolerance_percent, *value));
            within += point.isWithin ? 1 : 0;
            m_result.curve.push_back(point);
        }
        m_result.value = hundred * static_cast<double>(within)
                         / static_cast<double>(std::max<std::size_t>(goal.at.size(), 1));
        m_result.asked = goal.least_share_percent;
        return done(!isCurve() ? Finding::notAnswered
                               : passedIf(*m_result.value >= goal.least_share_percent - lastBit));
    }

    GoalResult check(const OrderPrediction& goal) {
        std::vector<double> values;
        const Project& project = m_run.result.project;
        for (std::size_t i = 0; i < m_run.result.sections.size(); ++i) {
            Figure figure = goal.figure;
            figure.place = placeName(project, i);
            const auto value = figureValue(figure, m_run);
            if (!value) {
                return done(Finding::noSuchFigure);
            }
            values.push_back(*value);
        }
        m_result.order.resize(values.size());
        std::iota(m_result.order.begin(), m_result.order.end(), std::size_t{0});
        std::stable_sort(m_result.order.begin(), m_result.order.end(),
                         [&](std::size_t a, std::size_t b) { return values[a] > values[b]; });
        const auto order = saidOrder(values.size());
        if (!order) {
            return done(Finding::notAnswered);
        }
        bool isRight = true; // no place may follow one that is smaller by more than the tolerance
        for (std::size_t i = 0; i < order->size(); ++i) {
            for (std::size_t j = i + 1; j < order->size(); ++j) {
                isRight =
                    isRight && values[(*order)[j]] - values[(*order)[i]] <= goal.alike + lastBit;
            }
        }
        return done(passedIf(isRight));
    }

private:
    /// Judges the worst of all stocks; where that cannot be decided the verdict of the run remains.
    void judgeEveryStock() {
        const std::optional<JudgedStocks> stocks = judgeStocks(m_run.result);
        if (stocks && stocks->worst) {
            m_result.value = hundred * stocks->worst->relativeMargin;
        }
        if (stocks && !stocks->holds) {
            m_result.failingStocks_percent = hundred * stocks->failingShare;
            if (stocks->worst) {
                m_result.failing.push_back(stocks->worst->kind);
            }
        }
    }

    GoalResult done(Finding finding) {
        m_result.finding = finding;
        return std::move(m_result);
    }

    static double toleranceOf(double absolute, double relative_percent, double value) {
        return std::max(absolute, relative_percent / hundred * std::abs(value));
    }

    [[nodiscard]] Figure along(const CurvePrediction& goal, double at) const {
        Figure figure = goal.figure;
        switch (goal.along) {
        case CurveAlong::count: figure.count = static_cast<int>(at); break;
        case CurveAlong::stage: figure.stage = static_cast<int>(at); break;
        case CurveAlong::place:
            figure.place = placeName(m_run.result.project, static_cast<std::size_t>(at));
            break;
        }
        return figure;
    }

    /// Whether the answer is a curve: at least one point, each with x and y, x rising.
    [[nodiscard]] bool isCurve() const {
        const NumberRows& rows = m_answer.curve;
        for (std::size_t i = 0; rows && i < rows->size(); ++i) {
            if ((*rows)[i].size() != 2 || (i > 0 && (*rows)[i][0] <= (*rows)[i - 1][0])) {
                return false;
            }
        }
        return rows && !rows->empty();
    }

    /// The predicted curve at a place; empty beyond its ends.
    [[nodiscard]] std::optional<double> said(double at) const {
        for (std::size_t i = 0; isCurve() && i < m_answer.curve->size(); ++i) {
            const auto& b = (*m_answer.curve)[i];
            if (b[0] == at) {
                return b[1];
            }
            if (i > 0 && b[0] > at && (*m_answer.curve)[i - 1][0] < at) {
                const auto& a = (*m_answer.curve)[i - 1];
                return a[1] + (at - a[0]) / (b[0] - a[0]) * (b[1] - a[1]);
            }
        }
        return std::nullopt;
    }

    /// The predicted order, if it names each place once.
    [[nodiscard]] std::optional<std::vector<std::size_t>> saidOrder(std::size_t places) const {
        std::vector<std::size_t> order;
        for (const double each : m_answer.order.value_or(std::vector<double>())) {
            if (each != std::floor(each) || each < 0 || each >= static_cast<double>(places)) {
                return std::nullopt;
            }
            order.push_back(static_cast<std::size_t>(each));
        }
        const bool isWhole = order.size() == places
                             && std::set<std::size_t>(order.begin(), order.end()).size() == places;
        return isWhole ? std::optional(std::move(order)) : std::nullopt;
    }

    const FigureSource& m_run;
    const Answer& m_answer;
    GoalResult m_result;
};

GoalResult checkChoiceGoal(const ChoiceGoal& goal, const Answer& answer) {
    GoalResult result;
    if (!answer.chosen || answer.chosen->empty()) {
        return result;
    }
    bool isKnown = false, isRight = true;
    for (std::size_t i = 0; i < goal.options.size(); ++i) {
        const bool isChosen =
            std::find(answer.chosen->begin(), answer.chosen->end(), static_cast<double>(i + 1))
            != answer.chosen->end();
        isRight = isRight && isChosen == goal.options[i].right;
        isKnown = isKnown || goal.options[i].right;
    }
    // A student's file does not contain which options are right.
    result.finding = isKnown ? passedIf(isRight) : Finding::forTeacher;
    return result;
}

/// Letters, not bytes.
std::size_t lettersIn(const std::string& text) {
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0) != 0x80
               && std::string_view(" \t\r\n").find(c) == std::string_view::npos;
    }));
}

GoalResult checkTextGoal(const TextGoal& goal, const Answer& answer) {
    GoalResult result;
    result.value = static_cast<double>(lettersIn(answer.text));
    result.asked = goal.least_letters;
    result.finding = *result.value >= *result.asked ? Finding::forTeacher : Finding::notAnswered;
    return result;
}

GoalResult checkWithoutRun(const Goal& goal, const Answer& answer) {
    return goal.choice ? checkChoiceGoal(*goal.choice, answer) : checkTextGoal(*goal.text, answer);
}

GoalResult checkWithRun(const Goal& goal, const FigureSource& run, const Answer& answer) {
    GoalCheck check(run, answer);
    switch (goal.kind()) {
    case GoalKind::requirements: return check.check(*goal.requirements);
    case GoalKind::time: return check.check(*goal.time);
    case GoalKind::figure: return check.check(*goal.figure);
    case GoalKind::prediction: return check.check(*goal.prediction);
    case GoalKind::curve: return check.check(*goal.curve);
    case GoalKind::order: return check.check(*goal.order);
    case GoalKind::choice:
    case GoalKind::text: break;
    }
    return {};
}

/// The submitted set-up, or the initial one of the step.
std::optional<Setup> submittedSetup(const Lesson& lesson, std::size_t step, const Answer& answer,
                                    GoalResult& result, const std::stop_token& stop) {
    if (!answer.hasSetup()) {
        return setupOf(lesson, step);
    }
    ReadSetup read = readSetup(answer.setup.text, stop);
    if (!read.setup) {
        result.finding = Finding::refused;
        result.issues = std::move(read.issues);
        return std::nullopt;
    }
    result.forbidden = forbiddenChanges(lesson, step, *read.setup);
    if (!result.forbidden.empty()) {
        result.finding = Finding::forbidden;
        return std::nullopt;
    }
    return std::move(read.setup);
}

} // namespace

bool needsRun(const Goal& goal) {
    return !goal.choice && !goal.text;
}

bool needsRecordedRun(const Goal& goal) {
    const Figure* const figure = goal.asked();
    return figure && needsTrajectory(*figure);
}

GoalResult checkGoal(const Goal& goal, const FigureSource& run, const Answer& answer) {
    GoalResult result;
    if (!needsRun(goal)) {
        result = checkWithoutRun(goal, answer);
    } else if (run.result.status == RunStatus::completed) {
        result = checkWithRun(goal, run, answer);
        result.time_min = run.result.time_s / units::secondsPerMinute;
    } else {
        result.finding =
            run.result.status == RunStatus::refused ? Finding::refused : Finding::doesNotEnd;
    }
    result.kind = goal.kind();
    result.status = run.result.status;
    return result;
}

GoalResult checkStep(const Lesson& lesson, std::size_t step, const Answer& answer,
                     const std::stop_token& stop) {
    const LessonStep& of = lesson.steps[step];
    GoalResult result;
    result.kind = of.goal.kind();
    // Where settings are asked for, an answer without a set-up is incomplete.
    if (isMetBySetting(result.kind) && !answer.hasSetup()) {
        return result;
    }
    if (!needsRun(of.goal)) {
        result = checkWithoutRun(of.goal, answer);
        result.kind = of.goal.kind();
        return result;
    }
    const auto setup = submittedSetup(lesson, step, answer, result, stop);
    if (!setup) {
        return result;
    }
    const WornProject worn = wornProject(*setup, static_cast<std::size_t>(of.surface) - 1, stop);
    if (!worn.issues.empty()) {
        result.finding = Finding::refused;
        result.issues = worn.issues;
        return result;
    }
    const StudiedRun run = studyRun(worn.project, needsRecordedRun(of.goal), stop);
    return checkGoal(of.goal, run.figures(), answer);
}

} // namespace sparkout
