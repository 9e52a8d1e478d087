// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/operation.h"

#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/text.h"

#include <array>

namespace sparkout {

namespace {

constexpr std::array strokeFeeds{
    StageFeed{"radial_feed_mm", &Stage::radial_feed_mm, &MachineLimits::radial_feed_mm,
              &Optimisation::radial_feed_mm, &Optimisation::stage_radial_feed_mm},
    StageFeed{"axial_feed_mm_min", &Stage::axial_feed_mm_min, &MachineLimits::axial_feed_mm_min,
              &Optimisation::axial_feed_mm_min, &Optimisation::stage_axial_feed_mm_min}};

constexpr StageFeed continuousFeed{"continuous_feed_mm_min", &Stage::continuous_feed_mm_min,
                                   &MachineLimits::continuous_feed_mm_min,
                                   &Optimisation::continuous_feed_mm_min,
                                   &Optimisation::stage_continuous_feed_mm_min};

constexpr std::array plungeFeeds{
    StageFeed{"radial_feed_mm_min", &Stage::radial_feed_mm_min, &MachineLimits::plunge_feed_mm_min,
              &Optimisation::radial_feed_mm_min, &Optimisation::stage_radial_feed_mm_min}};

template <std::size_t... Kinds>
Operation kindAt(std::size_t index, std::index_sequence<Kinds...>) {
    constexpr Operation kinds[]{Operation(std::in_place_index<Kinds>)...};
    return kinds[index];
}

template <std::size_t... Kinds>
std::span<const Choice> choicesOfKinds(std::index_sequence<Kinds...>) {
    static const std::array choices{
        std::variant_alternative_t<Kinds, Operation::variant>::traits.choice...};
    return choices;
}

using AllKinds = std::make_index_sequence<std::variant_size_v<Operation::variant>>;

} // namespace

const OperationTraits Traverse::traits{
    .choice = {"traverse", SPARKOUT_NOOP("Choice", "traverse grinding")},
    .feeds = strokeFeeds,
    .continuous = &continuousFeed,
    .usualRadial = 0.001,
    .usualLeastSteps = 2,
    .travels = true,
};

const OperationTraits Plunge::traits{
    .choice = {"plunge", SPARKOUT_NOOP("Choice", "plunge grinding")},
    .feeds = plungeFeeds,
    .usualRadial = 0.1,
    .usualLeastSteps = 3,
};

std::vector<const StageFeed*> OperationTraits::searchedFeeds() const {
    std::vector<const StageFeed*> searched;
    for (const StageFeed& feed : feeds) {
        searched.push_back(&feed);
    }
    if (continuous) {
        searched.push_back(continuous);
    }
    return searched;
}

Operation Operation::ofIndex(std::size_t index) {
    return kindAt(index, AllKinds());
}

template <>
std::span<const Choice> choicesOf<Operation>() {
    return choicesOfKinds(AllKinds());
}

} // namespace sparkout
