// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/search_words.h"

#include "core/optimisation/grid.h"
#include "core/optimisation/search_names.h"
#include "core/project/optimisation.h"

#include <cmath>
#include <string>
#include <vector>

namespace sparkout {

namespace {

/// "a, b and c"
std::string listed(const std::vector<std::string>& keys) {
    std::string list;
    for (std::size_t i = 0; i < keys.size(); ++i) {
        list += (i == 0 ? "" : i + 1 == keys.size() ? " and " : ", ") + keys[i];
    }
    return list;
}

std::vector<std::string> feedKeys(const Operation& operation) {
    std::vector<std::string> keys;
    for (const StageFeed& feed : operation->feeds) {
        keys.emplace_back(feed.key);
    }
    return keys;
}

} // namespace

std::string searchRefusal(const GridSearchReport& report) {
    if (report.isOtherOperation) {
        return std::string("/operation: --method ") + searchMethodName(report.method)
               + " is for plunge grinding; --method search takes traverse cycles";
    }
    if (report.isOtherAim) {
        return std::string(report.marginWithin_us ? "/optimisation/margin_within_min: "
                                                  : "/optimisation/objective: ")
               + (isHeuristic(report.method)
                      ? std::string("--method ") + searchMethodName(report.method)
                      : "--refine")
               + " looks for the least time alone";
    }
    switch (report.objectiveFault) {
    case ObjectiveFault::none: break;
    case ObjectiveFault::noRates:
        return "/optimisation/cost: not given; the objective cost needs what an hour costs";
    case ObjectiveFault::otherAim:
        return "/optimisation/margin_within_min: the largest margin is searched with the objective "
               "time alone";
    case ObjectiveFault::otherParts:
        return "/optimisation/objective: cost and wheel_life are searched for the part as it "
               "stands, without phases of the stock and batch";
    }
    switch (report.fault) {
    case GridFault::none: break;
    case GridFault::notGiven: return "/optimisation: what to search is not given";
    case GridFault::noLevels:
        return "/optimisation: " + listed(feedKeys(report.project.operation)) + " must be given";
    case GridFault::tooManyLevels:
        return "/optimisation: more than " + std::to_string(std::lround(mostSettings))
               + " settings of a stage's feeds";
    case GridFault::tooManySteps:
        return "/optimisation/stock_step_mm: more than "
               + std::to_string(std::lround(mostStockSteps)) + " steps of stock";
    case GridFault::tooManyVariants:
        return "/optimisation: more than " + std::to_string(std::lround(mostVariants))
               + " combinations of " + listed(wholeCycleKeys());
    case GridFault::noDivision:
        return "/optimisation: the stock and the feeds cannot be divided into these numbers of "
               "stages within their bounds";
    }
    return {};
}

} // namespace sparkout
