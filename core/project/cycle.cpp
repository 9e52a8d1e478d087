// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/cycle.h"

#include "core/issue.h"
#include "core/project/conditions.h"
#include "core/project/gauge.h"
#include "core/text.h"

#include <algorithm>
#include <array>

namespace sparkout {

static_assert(CountOrWord<SparkOut>);

std::span<const Choice> SparkOut::words() {
    static constexpr std::array words{Choice{"until_size", SPARKOUT_NOOP("Choice", "until size")}};
    return words;
}

Phrase SparkOut::expected() {
    return Phrase::wholeNumberOrUntilSize;
}

namespace {

bool feeds(const Project&, const void* stage) {
    return static_cast<const Stage*>(stage)->feeds();
}
template <auto Feed>
bool feedsWith(const Project& p, const void* stage) {
    return conditions::setsFeed<Feed>(p, stage) && feeds(p, stage);
}
bool retracts(const Project& p, const void* stage) {
    return mayRetract(p, *static_cast<const Stage*>(stage));
}
bool feedsWhileTravelling(const Project& p, const void* stage) {
    return p.operation->travels && feeds(p, stage);
}
/// Whether the stage feeds continuously and so may do without a feed at the reversals.
bool feedsAllTheTime(const Project& p, const void* stage) {
    return p.operation->travels && static_cast<const Stage*>(stage)->continuousFeed_mm_min() > 0;
}

} // namespace

bool feedsContinuously(const Project& project) {
    return project.operation->travels
           && std::ranges::any_of(project.cycle->stages, [](const Stage& stage) {
                  return stage.continuousFeed_mm_min() > 0;
              });
}

bool drawsBack(const Project& project) {
    const StageFeed& radial = project.operation->radial();
    return std::ranges::any_of(project.cycle->stages, [&](const Stage& stage) {
        return (stage.*radial.value).value_or(0) < 0;
    });
}

bool mayRetract(const Project& project, const Stage& stage) {
    const auto& stages = project.cycle->stages;
    return !project.operation->travels && project.gauge->control == Control::gauge
           && stages.size() > 2 && &stage > &stages.front() && &stage < &stages.back();
}

template <>
const StructInfo& tableOf<Stage>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            Stage, radial_feed_mm, .label = SPARKOUT_NOOP("Input", "Radial feed per double stroke"),
            .symbol = "S_t", .unit = "mm/dbl stroke", .hard = {0, 1}, .soft = {0.0002, 0.05},
            .nullMeaning = SPARKOUT_NOOP("Input", "not used"),
            .required = feedsWith<&Stage::radial_feed_mm>,
            .relevant = feedsWith<&Stage::radial_feed_mm>, .slider = true, .read = {1e-6, 1},
            .exempt = feedsAllTheTime, .page = Page::cycle, .usual = true,
            .hint =
                SPARKOUT_NOOP("Input", "Programmed infeed at the reversals of each double stroke."),
            .formula = "t_П ← t_П + S_t", .column = SPARKOUT_NOOP("InputBrief", "Radial feed"),
            .source = "MODEL-5"),
        SPARKOUT_FIELD(Stage, axial_feed_mm_min, .label = SPARKOUT_NOOP("Input", "Axial feed"),
                       .symbol = "S_ax", .unit = "mm/min", .hard = {0.01, 1e5}, .soft = {50, 6000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not used"),
                       .required = conditions::setsFeed<&Stage::axial_feed_mm_min>,
                       .relevant = conditions::setsFeed<&Stage::axial_feed_mm_min>, .slider = true,
                       .page = Page::cycle, .usual = true,
                       .hint = SPARKOUT_NOOP("Input",
                                             "Table speed; S_ax/n per revolution is the effective "
                                             "width of cut, at most the wheel width."),
                       .formula = "b = min(S_ax/n, B)", .source = "MODEL-5"),
        SPARKOUT_FIELD(Stage, radial_feed_mm_min, .label = SPARKOUT_NOOP("Input", "Radial feed"),
                       .symbol = "S_p", .unit = "mm/min", .hard = {-100, 100}, .soft = {0.01, 5},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not used"),
                       .required = feedsWith<&Stage::radial_feed_mm_min>,
                       .relevant = feedsWith<&Stage::radial_feed_mm_min>, .slider = true,
                       .read = {1e-6, 100}, .exempt = retracts, .page = Page::cycle, .usual = true,
                       .hint = SPARKOUT_NOOP(
                           "Input", "Programmed plunge feed; S_p/n per revolution of the part. "
                                    "Beyond the sources: a stage between others may retract "
                                    "(negative feed) until its stock is off or nothing is cut."),
                       .formula = "t_П ← t_П + S_p/n", .source = "MODEL-6"),
        SPARKOUT_FIELD(Stage, continuous_feed_mm_min,
                       .label = SPARKOUT_NOOP("Input", "Continuous radial infeed"), .symbol = "S_c",
                       .unit = "mm/min", .hard = {0, 10}, .soft = {0, 1},
                       .nullMeaning = SPARKOUT_NOOP("Input", "none"),
                       .relevant = feedsWhileTravelling, .page = Page::cycle,
                       .hint = SPARKOUT_NOOP(
                           "Input",
                           "Radial infeed that continues while the table travels and dwells, in "
                           "addition to the radial feed at the reversals, which may then be 0."),
                       .formula = "t_П ← t_П + S_c·Δt",
                       .column = SPARKOUT_NOOP("InputBrief", "Cont. infeed"), .source = "MODEL-5"),
        SPARKOUT_FIELD(
            Stage, stock_mm, .label = SPARKOUT_NOOP("Input", "Stage stock per side"),
            .symbol = "Π_z", .unit = "mm", .hard = {0, 5}, .soft = {0, 0.6}, .required = feeds,
            .slider = true, .page = Page::cycle, .usual = true,
            .hint = SPARKOUT_NOOP("Input", "Radial stock of the stage. The stage ends when only "
                                           "the stock of the later stages remains."),
            .formula = "Π_rem ≤ Σ Π_j, j > z",
            .column = SPARKOUT_NOOP("InputBrief", "Stock per side"), .source = "MODEL-7"),
        SPARKOUT_FIELD(
            Stage, spark_out, .label = SPARKOUT_NOOP("Input", "Spark-out"), .hard = {1, 100000},
            .nullMeaning = SPARKOUT_NOOP("Input", "an ordinary stage"), .page = Page::cycle,
            .usual = true,
            .hint = SPARKOUT_NOOP("Input", "The last stage may have no feed: a number of double "
                                           "strokes or revolutions, or until size."),
            .column = SPARKOUT_NOOP("InputBrief", "Spark-out"), .source = "MODEL-7"),
    };
    static const StructInfo info = makeTable<Stage>(SPARKOUT_NOOP("Struct", "Stage"), rows);
    return info;
}

template <>
const StructInfo& tableOf<Cycle>() {
    static const std::array rows{
        SPARKOUT_FIELD(Cycle, stages, .label = SPARKOUT_NOOP("Input", "Stages"), .hard = {1, 100},
                       .required = conditions::always, .page = Page::cycle, .usual = true,
                       .hint = SPARKOUT_NOOP("Input", "Stages of the cycle in the order they run."),
                       .source = "MODEL-7"),
    };
    static const StructInfo info = makeTable<Cycle>(SPARKOUT_NOOP("Struct", "Cycle"), rows);
    return info;
}

} // namespace sparkout
