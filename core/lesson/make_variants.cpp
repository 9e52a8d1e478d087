// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/make_variants.h"

#include "core/lesson/figure_value.h"
#include "core/lesson/goal_check.h"
#include "core/project/number_input.h"
#include "core/project/optimisation.h"
#include "core/project/validate.h"
#include "core/search/optimise.h"
#include "core/setup/setup_file.h"
#include "core/setup/worn_project.h"
#include "core/statistics/philox.h"
#include "core/study/search.h"
#include "core/units.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

namespace sparkout {

std::optional<BestAnswer> bestAnswer(const Project& project, const std::stop_token& stop) {
    if (!project.optimisation || hasErrors(validate(project))
        || Variants(project, stop).fault() != GridFault::none) {
        return std::nullopt;
    }
    SearchOptions options;
    options.stop = stop;
    const SearchSummary summary = optimise(project, options);
    if (summary.status != SearchStatus::proved || !summary.best) {
        return std::nullopt;
    }
    constexpr double percent = 100;
    return BestAnswer{summary.best->time_s / units::secondsPerMinute,
                      summary.best->leastRelativeMargin * percent, withBest(project, summary)};
}

VariantLevels levelCounts(const Lesson& lesson) {
    VariantLevels counts;
    if (lesson.variants) {
        for (const VariedInput& input : lesson.variants->inputs) {
            counts.push_back(static_cast<std::size_t>(input.levels()));
        }
    }
    return counts;
}

bool areLevels(const Lesson& lesson, const VariantLevels& levels) {
    const VariantLevels counts = levelCounts(lesson);
    return std::equal(levels.begin(), levels.end(), counts.begin(), counts.end(),
                      [](std::size_t level, std::size_t count) { return level < count; });
}

bool asksForBest(const Lesson& lesson) {
    return std::any_of(lesson.steps.begin(), lesson.steps.end(), [](const LessonStep& step) {
        return step.goal.time && !step.goal.time->below_min;
    });
}

std::size_t variedSurface(const Lesson& lesson) {
    return lesson.variants ? static_cast<std::size_t>(lesson.variants->surface) - 1 : 0;
}

Lesson withBestTimes(Lesson lesson, const std::stop_token& stop) {
    if (!asksForBest(lesson)) {
        return lesson;
    }
    const auto best = bestAnswer(lesson.base.surfaces[variedSurface(lesson)].project, stop);
    return withVariant(std::move(lesson), {}, best ? std::optional(best->time_min) : std::nullopt);
}

double timeAllowed_min(double best_min, double within_percent) {
    constexpr double percent = 100, perMinute = 1000, lastBit = 1e-9;
    return std::ceil(best_min * (1 + within_percent / percent) * perMinute - lastBit) / perMinute;
}

Lesson withVariant(Lesson lesson, const VariantLevels& levels,
                   const std::optional<double>& best_min) {
    for (std::size_t i = 0; i < levels.size(); ++i) {
        for (const InputValue& value : lesson.variants->inputs[i].valuesAt(levels[i])) {
            (void)putInput(lesson.base, variedSurface(lesson), value);
        }
    }
    for (LessonStep& step : lesson.steps) {
        if (best_min && step.goal.time && !step.goal.time->below_min) {
            step.goal.time->below_min =
                timeAllowed_min(*best_min, *step.goal.time->within_percent_of_best);
        }
    }
    return lesson;
}

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

/// A margin or a time rounded to six decimals: cos and exp differ between processors in the last
/// bits, which must not matter.
double inMillionths(double value) {
    constexpr double perUnit = 1e6;
    return std::round(value * perUnit) / perUnit;
}

/// Searches a value of one free input that gives the required figure of a step.
class FigureSearch {
public:
    FigureSearch(const Lesson& timed, std::size_t step, std::stop_token stop)
        : m_lesson(timed)
        , m_step(step)
        , m_surface(static_cast<std::size_t>(timed.steps[step].surface) - 1)
        , m_given(setupOf(timed, step))
        , m_stop(std::move(stop)) {}

    std::optional<Setup> run() {
        for (const NumberInput& input : numberInputs(m_given.surfaces[m_surface].project)) {
            if (input.value && isFree(input.path) && isAttained(input)) {
                return std::move(m_found);
            }
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] bool isFree(const std::string& path) const {
        return std::any_of(m_lesson.steps.begin(),
                           m_lesson.steps.begin() + static_cast<std::ptrdiff_t>(m_step) + 1,
                           [&](const LessonStep& each) {
                               return each.surface == m_lesson.steps[m_step].surface
                                      && accessTo(each, path) == Access::free;
                           });
    }

    /// The figure less its required value, at a value of an input; empty if there is none.
    std::optional<double> offset(const NumberInput& input, double value) {
        Setup changed = m_given;
        if (!input.allowed.contains(value)
            || !putInput(changed, m_surface, {input.path, value, {}})) {
            return std::nullopt;
        }
        const GoalResult result = checkStep(m_lesson, m_step, answerOf(changed), m_stop);
        if (result.passed()) {
            m_found = std::move(changed);
        }
        return result.value ? std::optional(*result.value - *result.asked) : std::nullopt;
    }

    bool isAttained(const NumberInput& input) {
        constexpr std::array factors{0.1,  0.2, 0.35, 0.5, 0.65, 0.8, 0.9, 1.1,
                                     1.25, 1.5, 2.0,  3.0, 5.0,  8.0, 12.0};
        struct Tried {
            double value = 0, offset = 0;
            bool isKnown = false;
        } before;
        for (const double factor : factors) {
            const double value = *input.value * factor;
            const auto at = offset(input, value);
            const bool isAcross =
                at && before.isKnown && (*at > 0) != (before.offset > 0) && !m_found;
            if (isAcross) {
                halve(input, before.value, value, before.offset > 0);
            }
            if (m_found) {
                return true;
            }
            before = {value, at.value_or(0), at.has_value()};
        }
        return false;
    }

    /// Bisects between two values with the figure above and below the required one.
    void halve(const NumberInput& input, double low, double high, bool isLowAbove) {
        constexpr int halvings = 24;
        for (int i = 0; i < halvings && !m_found && !m_stop.stop_requested(); ++i) {
            const double middle = (low + high) / 2;
            const auto there = offset(input, middle);
            if (!there) {
                return;
            }
            ((*there > 0) == isLowAbove ? low : high) = middle;
        }
    }

    const Lesson& m_lesson;
    std::size_t m_step, m_surface;
    Setup m_given;
    std::stop_token m_stop;
    std::optional<Setup> m_found;
};

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
    /// Checks the projects of the steps as given.
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
                continue; // a time that depends on the best is not known yet
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
        return faultOfBounds();
    }

    /// Checks the figures that the rules bound, as the steps begin.
    [[nodiscard]] std::optional<VariantFault> faultOfBounds() const {
        const auto bounds =
            m_lesson.variants ? m_lesson.variants->figures : std::vector<FigureBound>();
        for (const FigureBound& bound : bounds) {
            const auto step = static_cast<std::size_t>(bound.step) - 1;
            const WornProject worn =
                wornProject(setupOf(m_lesson, step),
                            static_cast<std::size_t>(m_lesson.steps[step].surface) - 1, m_stop);
            if (!worn.issues.empty()) {
                return VariantFault::invalid;
            }
            const StudiedRun run = studyRun(worn.project, needsTrajectory(bound.figure), m_stop);
            const auto value =
                run.isCompleted() ? figureValue(bound.figure, run.figures()) : std::nullopt;
            if (!value) {
                return VariantFault::noFigure;
            }
            const double rounded = inMillionths(*value);
            if ((bound.least && rounded < *bound.least) || (bound.most && rounded > *bound.most)) {
                return VariantFault::otherFigure;
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

    /// Checks that the best answer, or if a margin is required the quickest that has it, meets the
    /// step.
    std::optional<VariantFault> faultOfSearch(const Lesson& timed, std::size_t step,
                                              const BestAnswer& best) const {
        const Goal& goal = timed.steps[step].goal;
        Project project = best.project;
        if (goal.requirements && goal.requirements->every_stock) {
            Project given = timed.base.surfaces[m_surface].project;
            given.optimisation->scenarios = OptimisationScenarios::stocks;
            const SearchOutcomePtr found = search(given, {}, m_stop);
            if (!found->answer()) {
                return VariantFault::noAnswer;
            }
            project = withFound(timed.base.surfaces[m_surface].project, *found->answer());
        } else if (goal.requirements
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
        // Applied to the step's own project values, besides the cycle that was found.
        Setup setup = withProject(setupOf(timed, step), m_surface, std::move(project));
        for (const InputValue& value : timed.steps[step].values) {
            (void)putInput(setup, m_surface, value);
        }
        const GoalResult result = checkStep(timed, step, answerOf(setup), m_stop);
        return result.passed()                        ? std::nullopt
               : result.finding == Finding::forbidden ? std::optional(VariantFault::notFree)
                                                      : std::optional(VariantFault::noAnswer);
    }

    /// Looks for a value of one free input that gives the required figure: a proof by example.
    std::optional<VariantFault> faultOfFigure(const Lesson& timed, std::size_t step) const {
        return attainingSetup(timed, step, m_stop) ? std::nullopt
                                                   : std::optional(VariantFault::unattained);
    }

    Difficulty m_rules;
    Lesson m_lesson; ///< with the inputs of the variant
    std::size_t m_surface;
    std::stop_token m_stop;
};

/// The levels of a try, drawn uniformly.
VariantLevels drawn(const VariantLevels& counts, std::uint32_t seed, long long tried) {
    VariantLevels levels;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        const std::uint64_t bits =
            randomBits(seed, RandomStream::variant, static_cast<std::uint64_t>(tried),
                       static_cast<std::uint32_t>(i));
        levels.push_back(
            static_cast<std::size_t>((bits >> 32) * static_cast<std::uint64_t>(counts[i]) >> 32));
    }
    return levels;
}

} // namespace

std::optional<Setup> attainingSetup(const Lesson& lesson, std::size_t step,
                                    const std::stop_token& stop) {
    return FigureSearch(lesson, step, stop).run();
}

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

MadeVariants makeVariants(const Lesson& lesson, std::size_t count, std::uint32_t seed,
                          const std::stop_token& stop,
                          const std::function<void(const VariantTry&)>& note) {
    MadeVariants made;
    if (needsSearch(lesson)) {
        const Project& project = lesson.base.surfaces[variedSurface(lesson)].project;
        if (!project.optimisation) {
            made.fault = LessonFault::noGrid;
            return made;
        }
        made.reference = bestAnswer(project, stop);
        made.isStopped = stop.stop_requested();
        if (!made.reference) {
            made.fault = LessonFault::noReference;
            return made;
        }
    }
    if (!lesson.variants) {
        made.variants.assign(count, {{}, made.reference});
        return made;
    }
    const VariantLevels counts = levelCounts(lesson);
    std::map<VariantLevels, VariantFault> known;
    std::set<VariantLevels> taken;
    while (made.variants.size() < count && made.tries < mostTries(count)) {
        const VariantLevels levels = drawn(counts, seed, made.tries++);
        CheckedVariant found;
        if (taken.contains(levels)) {
            found.fault = VariantFault::alike;
        } else if (const auto before = known.find(levels); before != known.end()) {
            found.fault = before->second;
        } else {
            found = checkVariant(lesson, levels, made.reference, stop);
            if (stop.stop_requested()) {
                made.isStopped = true;
                return made;
            }
            if (found.fault) {
                known.emplace(levels, *found.fault);
            } else {
                taken.insert(levels);
                made.variants.push_back({levels, found.best});
            }
        }
        if (found.fault) {
            ++made.refused[static_cast<std::size_t>(*found.fault)];
        }
        if (note) {
            note({levels, std::move(found), made.variants.size()});
        }
    }
    return made;
}

} // namespace sparkout
