// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/optimisation.h"

#include "core/project/conditions.h"
#include "core/project/cycle.h"
#include "core/text.h"

namespace sparkout {

template <>
std::span<const Choice> choicesOf<OptimisationScenarios>() {
    static const std::array choices{Choice{"nominal", SPARKOUT_NOOP("Choice", "nominal part")},
                                    Choice{"stocks", SPARKOUT_NOOP("Choice", "every stock")},
                                    Choice{"corners", SPARKOUT_NOOP("Choice", "all corners")},
                                    Choice{"batch", SPARKOUT_NOOP("Choice", "the batch")}};
    return choices;
}

template <>
std::span<const Choice> choicesOf<SearchObjective>() {
    static const std::array choices{
        Choice{"time", SPARKOUT_NOOP("Choice", "minimum time")},
        Choice{"cost", SPARKOUT_NOOP("Choice", "minimum cost")},
        Choice{"wheel_life", SPARKOUT_NOOP("Choice", "most parts per dressing")}};
    return choices;
}

template <>
const StructInfo& tableOf<Cost>() {
    static const std::array rows{
        SPARKOUT_FIELD(Cost, machine_per_h, .label = SPARKOUT_NOOP("Input", "Machine and operator"),
                       .symbol = "C_m", .unit = SPARKOUT_NOOP("Unit", "1/h"), .hard = {0, 1e9},
                       .required = conditions::always, .page = Page::search,
                       .hint = SPARKOUT_NOOP("Input", "Cost of an hour, in any currency."),
                       .formula = "C = C_m·(T + t_h + t_d/N) + C_d/N", .source = "GILBERT1950"),
        SPARKOUT_FIELD(
            Cost, handling_s, .label = SPARKOUT_NOOP("Input", "Handling"), .symbol = "t_h",
            .unit = "s", .hard = {0, 1e6}, .page = Page::search,
            .hint = SPARKOUT_NOOP("Input", "Loading and measuring, in addition to the cycle."),
            .formula = "C = C_m·(T + t_h + t_d/N) + C_d/N", .source = "GILBERT1950"),
        SPARKOUT_FIELD(Cost, dressing_s, .label = SPARKOUT_NOOP("Input", "Dressing time"),
                       .symbol = "t_d", .unit = "s", .hard = {0, 1e6}, .page = Page::search,
                       .hint = SPARKOUT_NOOP("Input", "Shared by the parts between dressings."),
                       .formula = "C = C_m·(T + t_h + t_d/N) + C_d/N", .source = "GILBERT1950"),
        SPARKOUT_FIELD(Cost, dressing_cost,
                       .label = SPARKOUT_NOOP("Input", "Wheel worn by a dressing"), .symbol = "C_d",
                       .hard = {0, 1e9}, .page = Page::search,
                       .hint = SPARKOUT_NOOP("Input", "Wheel and diamond, in the same currency."),
                       .formula = "C = C_m·(T + t_h + t_d/N) + C_d/N", .source = "GILBERT1950"),
        SPARKOUT_FIELD(Cost, parts_between_dressings,
                       .label = SPARKOUT_NOOP("Input", "Parts between dressings"), .symbol = "N",
                       .hard = {1, 1000000},
                       .nullMeaning = SPARKOUT_NOOP(
                           "Input", "as the batch's dullness grows, otherwise no dressing"),
                       .page = Page::search,
                       .hint = SPARKOUT_NOOP(
                           "Input", "For the minimum cost with a wheel that wears, the search "
                                    "finds this number, and the value given is its maximum."),
                       .formula = "C = C_m·(T + t_h + t_d/N) + C_d/N", .source = "GILBERT1950"),
    };
    static const StructInfo info = makeTable<Cost>(SPARKOUT_NOOP("Struct", "Cost of a part"), rows);
    return info;
}

namespace {

Field unfedSteps() {
    return makeField<&Optimisation::unfed_steps>(
        "spark_out",
        Row{.label = SPARKOUT_NOOP("Input", "Spark-outs at the end"),
            .hard = {0, 10000},
            .nullMeaning = SPARKOUT_NOOP("Input", "none"),
            .whole = true,
            .page = Page::search,
            .hint = SPARKOUT_NOOP(
                "Input",
                "Double strokes or revolutions of one more stage without feed that removes the "
                "last stock: a list, or from, to and step; 0: without this stage."),
            .source = "MODEL-7"});
}

Field adaptiveLevels() {
    return SPARKOUT_FIELD(
        Optimisation, adaptive, .label = SPARKOUT_NOOP("Input", "Levels follow the answer"),
        .page = Page::search,
        .hint = SPARKOUT_NOOP(
            "Input",
            "Levels of the feeds are added around the answer, and beyond the edge of the grid if "
            "the answer lies there and the machine allows it; then the grid is searched again."),
        .source = "MODEL-8");
}

Field continuousLevels() {
    return SPARKOUT_FIELD(
        Optimisation, continuous_feed_mm_min,
        .label = SPARKOUT_NOOP("Input", "Levels of the continuous infeed"), .unit = "mm/min",
        .hard = {0, 10, true},
        .nullMeaning = SPARKOUT_NOOP("Input", "cycles without one are searched"),
        .relevant = conditions::travels, .page = Page::search,
        .hint = SPARKOUT_NOOP(
            "Input", "A stage then has either one of these and no radial feed at the reversals, or "
                     "one of the radial feeds: a list, or from, to and step."),
        .source = "MODEL-8");
}

Field continuousByStage() {
    return SPARKOUT_FIELD(
        Optimisation, stage_continuous_feed_mm_min,
        .label = SPARKOUT_NOOP("Input", "Continuous infeed by stage"), .unit = "mm/min",
        .hard = {0, 10}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"),
        .relevant = conditions::travels, .count = 2, .page = Page::search,
        .hint = SPARKOUT_NOOP("Input", "Minimum and maximum for each stage in order, where it is "
                                       "fed continuously; equal values fix it."),
        .source = "MODEL-8");
}

Field objective() {
    return SPARKOUT_FIELD(
        Optimisation, objective, .label = SPARKOUT_NOOP("Input", "Objective"), .page = Page::search,
        .usual = true,
        .hint = SPARKOUT_NOOP("Input",
                              "Cost and wheel life are searched over the parts from one dressing "
                              "to the next: the cycle is fit for all of them, with the wheel as "
                              "worn by the parts. The minimum cost needs the cost of a part."),
        .source = "GILBERT1950");
}

Field marginWithin() {
    return SPARKOUT_FIELD(
        Optimisation, margin_within_min,
        .label = SPARKOUT_NOOP("Input", "Maximum margin within a time"), .unit = "min",
        .hard = {0, 600, true},
        .nullMeaning = SPARKOUT_NOOP("Input", "the minimum time is searched"), .page = Page::search,
        .hint =
            SPARKOUT_NOOP("Input", "The search then returns the cycle farthest from its limits "
                                   "within this machining time: the one with the largest minimum "
                                   "margin of all requirements, each as a share of its limit."),
        .source = "MODEL-8");
}

Field ratioDistance() {
    return SPARKOUT_FIELD(
        Optimisation, least_ratio_distance,
        .label = SPARKOUT_NOOP("Input", "Rotation ratio off a whole number"),
        .hard = {0, 0.45, true},
        .nullMeaning =
            SPARKOUT_NOOP("Input", "any; 0.05 if work speeds are searched and the wheel's "
                                   "runout is not given"),
        .page = Page::search,
        .hint = SPARKOUT_NOOP(
            "Input", "Minimum distance of n_k/n, the revolutions of the wheel for one of the work, "
                     "from a whole number: the search leaves out work speeds that are nearer to "
                     "one, at which waves of the wheel print onto one another."),
        .source = "BADGER2010");
}

Field costOfPart() {
    return SPARKOUT_FIELD(
        Optimisation, cost, .label = SPARKOUT_NOOP("Input", "Cost of a part"),
        .nullMeaning = SPARKOUT_NOOP("Input", "not computed"), .page = Page::search,
        .hint = SPARKOUT_NOOP(
            "Input", "Shown beside the time; the minimum is searched if it is the objective."),
        .source = "GILBERT1950");
}

} // namespace

template <>
const StructInfo& tableOf<Optimisation>() {
    static const std::array rows{
        SPARKOUT_FIELD(Optimisation, stages, .label = SPARKOUT_NOOP("Input", "Numbers of stages"),
                       .hard = {1, 5}, .whole = true, .page = Page::search, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Numbers of stages the search tries."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(Optimisation, stock_step_mm,
                       .label = SPARKOUT_NOOP("Input", "Stock step per side"), .unit = "mm",
                       .hard = {0, 5, true}, .soft = {0.001, 0.1}, .page = Page::search,
                       .hint = SPARKOUT_NOOP("Input", "Stage stocks are multiples of it."),
                       .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Optimisation, last_stock_mm,
            .label = SPARKOUT_NOOP("Input", "Stock per side of the last stage"), .unit = "mm",
            .hard = {0, 5}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .count = 2,
            .page = Page::search,
            .hint = SPARKOUT_NOOP("Input", "Minimum and maximum, in cycles of several stages."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(Optimisation, non_increasing,
                       .label = SPARKOUT_NOOP("Input", "Feeds never rise"), .page = Page::search,
                       .hint = SPARKOUT_NOOP("Input", "Neither feed rises from stage to stage."),
                       .source = "MODEL-8"),
        objective(),
        adaptiveLevels(),
        marginWithin(),
        SPARKOUT_FIELD(
            Optimisation, scenarios, .label = SPARKOUT_NOOP("Input", "Must be fit for"),
            .page = Page::search, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "The parts for which the cycle must meet the drawing."),
            .source = "MODEL-8"),
        ratioDistance(),
        SPARKOUT_FIELD(
            Optimisation, radial_feed_mm,
            .label = SPARKOUT_NOOP("Input", "Levels of the radial feed"), .unit = "mm/dbl stroke",
            .hard = {0, 1, true}, .nullMeaning = SPARKOUT_NOOP("Input", "not searched"),
            .relevant = conditions::setsFeed<&Stage::radial_feed_mm>, .page = Page::search,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Per double stroke: a list, or from, to and step."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Optimisation, axial_feed_mm_min,
            .label = SPARKOUT_NOOP("Input", "Levels of the axial feed"), .unit = "mm/min",
            .hard = {0, 1e5, true}, .nullMeaning = SPARKOUT_NOOP("Input", "not searched"),
            .relevant = conditions::setsFeed<&Stage::axial_feed_mm_min>, .page = Page::search,
            .usual = true, .hint = SPARKOUT_NOOP("Input", "A list, or from, to and step."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Optimisation, radial_feed_mm_min,
            .label = SPARKOUT_NOOP("Input", "Levels of the plunge feed"), .unit = "mm/min",
            .hard = {0, 100, true}, .nullMeaning = SPARKOUT_NOOP("Input", "not searched"),
            .relevant = conditions::setsFeed<&Stage::radial_feed_mm_min>, .page = Page::search,
            .usual = true, .hint = SPARKOUT_NOOP("Input", "A list, or from, to and step."),
            .source = "MODEL-8"),
        continuousLevels(),
        SPARKOUT_FIELD(
            Optimisation, work_speed_rpm,
            .label = SPARKOUT_NOOP("Input", "Levels of the work speed"), .unit = "rev/min",
            .hard = {0.1, 10000}, .nullMeaning = SPARKOUT_NOOP("Input", "as the machine is set"),
            .page = Page::search, .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input",
                "One value for the whole cycle; its levels as a list, or from, to and step."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Optimisation, dwell_entry_s,
            .label = SPARKOUT_NOOP("Input", "Levels of the entry dwell"), .unit = "s",
            .hard = {0, 3600}, .nullMeaning = SPARKOUT_NOOP("Input", "as the machine is set"),
            .relevant = conditions::travels, .page = Page::search,
            .hint = SPARKOUT_NOOP(
                "Input",
                "One value for the whole cycle; its levels as a list, or from, to and step."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Optimisation, dwell_exit_s, .label = SPARKOUT_NOOP("Input", "Levels of the exit dwell"),
            .unit = "s", .hard = {0, 3600},
            .nullMeaning = SPARKOUT_NOOP("Input", "as the machine is set"),
            .relevant = conditions::travels, .page = Page::search,
            .hint = SPARKOUT_NOOP(
                "Input",
                "One value for the whole cycle; its levels as a list, or from, to and step."),
            .source = "MODEL-8"),
        unfedSteps(),
        SPARKOUT_FIELD(
            Optimisation, stage_radial_feed_mm,
            .label = SPARKOUT_NOOP("Input", "Radial feed by stage"), .unit = "mm/dbl stroke",
            .hard = {0, 1}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"),
            .relevant = conditions::setsFeed<&Stage::radial_feed_mm>, .count = 2,
            .page = Page::search,
            .hint = SPARKOUT_NOOP(
                "Input", "Minimum and maximum for each stage in order; equal values fix it."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Optimisation, stage_axial_feed_mm_min,
            .label = SPARKOUT_NOOP("Input", "Axial feed by stage"), .unit = "mm/min",
            .hard = {0, 1e5}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"),
            .relevant = conditions::setsFeed<&Stage::axial_feed_mm_min>, .count = 2,
            .page = Page::search,
            .hint = SPARKOUT_NOOP(
                "Input", "Minimum and maximum for each stage in order; equal values fix it."),
            .source = "MODEL-8"),
        SPARKOUT_FIELD(
            Optimisation, stage_radial_feed_mm_min,
            .label = SPARKOUT_NOOP("Input", "Plunge feed by stage"), .unit = "mm/min",
            .hard = {0, 100}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"),
            .relevant = conditions::setsFeed<&Stage::radial_feed_mm_min>, .count = 2,
            .page = Page::search,
            .hint = SPARKOUT_NOOP(
                "Input", "Minimum and maximum for each stage in order; equal values fix it."),
            .source = "MODEL-8"),
        continuousByStage(),
        SPARKOUT_FIELD(
            Optimisation, stage_stock_mm,
            .label = SPARKOUT_NOOP("Input", "Stock per side by stage"), .unit = "mm",
            .hard = {0, 5}, .nullMeaning = SPARKOUT_NOOP("Input", "not limited"), .count = 2,
            .page = Page::search, .usual = true,
            .hint = SPARKOUT_NOOP(
                "Input", "Minimum and maximum for each stage in order; equal values fix it."),
            .source = "MODEL-8"),
        costOfPart(),
    };
    static const StructInfo info =
        makeTable<Optimisation>(SPARKOUT_NOOP("Struct", "Optimisation"), rows);
    return info;
}

} // namespace sparkout
