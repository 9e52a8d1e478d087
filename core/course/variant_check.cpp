// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/variant_check.h"

#include "core/lesson/goal_check.h"
#include "core/optimisation/optimise.h"
#include "core/project/number_input.h"
#include "core/project/validate.h"
#include "core/setup/setup_file.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

constexpr double inPercent = 100;

Answer answerOf(const Setup& setup) {
    Answer answer;
    answer.setup.text = writeSetup(setup);
    return answer;
}

Setup withProject(Setup setup, std::size_t surface, Project project) {
    setup.surfaces[surface].project = std::move(project);
    return setup;
}

/// A margin or a time to six decimals: last bits of cos and exp differ between processors and shall
/// decide nothing.
double inMillionths(double value) {
    constexpr double perUnit = 1e6;
    return std::round(value * perUnit) / perUnit;
}

/// Decides on one set of levels.
class VariantCheck {
public:
    VariantCheck(const Lesson& lesson, const VariantLevels& levels, std::stop_token stop)
        : m_rules(lesson.variants ? lesson.variants->difficulty : Difficulty())
        , m_lesson(withVariant(lesson, levels, std::nullopt))
        , m_surface(variedSurface(lesson))
        , m_stop(std::move(stop)) {}

    CheckedVariant run(const std::optional<BestAnswer>& reference) {
        CheckedVariant checked;
        checked.fault = faultAsGiven();
        if (!checked.fault && needsSearch(m_lesson)) {
            checked.best = bestAnswer(m_lesson.base.surfaces[m_surface].project, m_stop);
            checked.fault = checked.best ? faultOfBest(*checked.best, reference)
                                         : std::optional(VariantFault::noAnswer);
        }
        if (!checked.fault) {
            checked.fault = faultOfSettings(checked.best);
        }
        return checked;
    }

private:
    /// What the projects of the steps say as they are given.
    std::optional<VariantFault> faultAsGiven() {
        for (std::size_t i = 0; i < m_lesson.steps.size(); ++i) {
            const Goal& goal = m_lesson.steps[i].goal;
            const Setup setup = setupOf(m_lesson, i);
            for (const GroundSurface& surface : setup.surfaces) {
                if (hasErrors(validate(surface.project))) {
                    return VariantFault::invalid;
                }
            }
            if (!needsRun(goal) || (goal.time && !goal.time->below_min)) {
                continue; // a time that follows from the best is not known yet
            }
            const GoalResult result = checkStep(m_lesson, i, answerOf(setup), m_stop);
            if (result.finding == Finding::noSuchFigure) {
                return VariantFault::noFigure;
            }
            const bool runs =
                result.finding != Finding::refused
                && (isMetBySetting(goal.kind()) || result.finding != Finding::doesNotEnd);
            if (!runs) {
                return VariantFault::invalid;
            }
            if (isMetBySetting(goal.kind()) && result.passed()) {
                return VariantFault::solved;
            }
        }
        return std::nullopt;
    }

    std::optional<VariantFault> faultOfBest(const BestAnswer& best,
                                            const std::optional<BestAnswer>& reference) const {
        if (!reference || !m_lesson.variants) {
            return std::nullopt;
        }
        const double time_percent = inMillionths(inPercent * best.time_min / reference->time_min);
        if (time_percent < m_rules.least_time_percent) {
            return VariantFault::tooQuick;
        }
        if (time_percent > m_rules.most_time_percent) {
            return VariantFault::tooSlow;
        }
        const double apart =
            inMillionths(std::abs(best.margin_percent - reference->margin_percent));
        return apart > m_rules.margin_within_percent ? std::optional(VariantFault::otherMargin)
                                                     : std::nullopt;
    }

    /// Whether each step that asks for something to be set can be met, and is not met as given.
    std::optional<VariantFault> faultOfSettings(const std::optional<BestAnswer>& best) {
        const Lesson timed =
            withVariant(m_lesson, {}, best ? std::optional(best->time_min) : std::nullopt);
        for (std::size_t i = 0; i < timed.steps.size(); ++i) {
            const Goal& goal = timed.steps[i].goal;
            if (!isMetBySetting(goal.kind())) {
                continue;
            }
            const bool isTimed = m_lesson.steps[i].goal.time.has_value();
            if (isTimed && checkStep(timed, i, answerOf(setupOf(timed, i)), m_stop).passed()) {
                return VariantFault::solved;
            }
            const auto fault =
                goal.figure ? faultOfFigure(timed, i) : faultOfSearch(timed, i, *best);
            if (fault) {
                return fault;
            }
        }
        return std::nullopt;
    }

    /// The best answer, or where a margin is asked for the quickest that has it, meets the step.
    std::optional<VariantFault> faultOfSearch(const Lesson& timed, std::size_t step,
                                              const BestAnswer& best) const {
        const Goal& goal = timed.steps[step].goal;
        Project project = best.project;
        if (goal.requirements
            && inMillionths(best.margin_percent) <= goal.requirements->least_margin_percent
            && goal.requirements->least_margin_percent > 0) {
            SearchOptions options;
            options.stop = m_stop;
            options.beyondMargin = goal.requirements->least_margin_percent / inPercent;
            const Project& given = timed.base.surfaces[m_surface].project;
            const SearchSummary summary = optimise(given, options);
            if (!summary.best) {
                return VariantFault::noAnswer;
            }
            project = withBest(given, summary);
        }
        // On what the step puts into the project, beside the cycle that was found.
        Setup setup = withProject(setupOf(timed, step), m_surface, std::move(project));
        for (const InputValue& value : timed.steps[step].values) {
            (void)putInput(setup, m_surface, value);
        }
        const GoalResult result = checkStep(timed, step, answerOf(setup), m_stop);
        return result.passed()                        ? std::nullopt
               : result.finding == Finding::forbidden ? std::optional(VariantFault::notFree)
                                                      : std::optional(VariantFault::noAnswer);
    }

    /// A value of one free input at which the figure is as asked: a proof by example.
    std::optional<VariantFault> faultOfFigure(const Lesson& timed, std::size_t step) const {
        const auto surface = static_cast<std::size_t>(timed.steps[step].surface) - 1;
        const Setup setup = setupOf(timed, step);
        const Project& project = setup.surfaces[surface].project;
        for (const NumberInput& input : numberInputs(project)) {
            if (input.value && isFree(timed, step, input.path)
                && isAttained(timed, step, setup, surface, input)) {
                return std::nullopt;
            }
        }
        return VariantFault::unattained;
    }

    static bool isFree(const Lesson& timed, std::size_t step, const std::string& path) {
        return std::any_of(timed.steps.begin(),
                           timed.steps.begin() + static_cast<std::ptrdiff_t>(step) + 1,
                           [&](const LessonStep& each) {
                               return each.surface == timed.steps[step].surface
                                      && accessTo(each, path) == Access::free;
                           });
    }

    /// The figure less its value asked for, at a value of an input; nothing where there is none.
    [[nodiscard]] std::optional<double> offset(const Lesson& timed, std::size_t step,
                                               const Setup& setup, std::size_t surface,
                                               const NumberInput& input, double value,
                                               bool& attained) const {
        Setup changed = setup;
        if (!input.allowed.contains(value)
            || !putInput(changed, surface, {input.path, value, {}})) {
            return std::nullopt;
        }
        const GoalResult result = checkStep(timed, step, answerOf(changed), m_stop);
        attained = attained || result.passed();
        return result.value ? std::optional(*result.value - *result.asked) : std::nullopt;
    }

    [[nodiscard]] bool isAttained(const Lesson& timed, std::size_t step, const Setup& setup,
                                  std::size_t surface, const NumberInput& input) const {
        constexpr std::array factors{0.1,  0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 1.1,
                                     1.25, 1.5, 2.0,  3.0, 5.0,  8.0, 12.0};
        constexpr int halvings = 24;
        bool attained = false;
        struct Tried {
            double value = 0, offset = 0;
            bool isKnown = false;
        } before;
        for (const double factor : factors) {
            double high = *input.value * factor;
            const auto at = offset(timed, step, setup, surface, input, high, attained);
            if (attained) {
                return true;
            }
            if (at && before.isKnown && (*at > 0) != (before.offset > 0)) {
                double low = before.value;
                for (int i = 0; i < halvings && !attained && !m_stop.stop_requested(); ++i) {
                    const double middle = (low + high) / 2;
                    const auto there = offset(timed, step, setup, surface, input, middle, attained);
                    if (!there) {
                        break;
                    }
                    ((*there > 0) == (before.offset > 0) ? low : high) = middle;
                }
                if (attained) {
                    return true;
                }
            }
            before = {high, at.value_or(0), at.has_value()};
        }
        return false;
    }

    Difficulty m_rules;
    Lesson m_lesson; ///< with the inputs of the variant
    std::size_t m_surface;
    std::stop_token m_stop;
};

} // namespace

bool needsSearch(const Lesson& lesson) {
    return std::any_of(lesson.steps.begin(), lesson.steps.end(), [](const LessonStep& step) {
        return step.goal.requirements || step.goal.time;
    });
}

CheckedVariant checkVariant(const Lesson& lesson, const VariantLevels& levels,
                            const std::optional<BestAnswer>& reference,
                            const std::stop_token& stop) {
    return VariantCheck(lesson, levels, stop).run(reference);
}

} // namespace sparkout
