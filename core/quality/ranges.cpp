// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/ranges.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/wheel.h"
#include "core/quality/requirement.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <string_view>

namespace sparkout {

namespace {

using Limits = std::optional<std::vector<double>>;

/// Tolerance of a setting, as a share of a step.
constexpr double stepSlack = 1e-6;

double nearestSetting(double value, double low, double high, double step) {
    const double inside = std::clamp(value, low, high);
    if (step <= 0) {
        return inside;
    }
    const double steps = std::round((inside - low) / step);
    const double last = std::floor((high - low) / step + stepSlack);
    return low + std::min(steps, last) * step;
}

class Checks {
public:
    explicit Checks(std::optional<ConstraintKind> only) : m_only(only) {}
    void add(ConstraintKind kind, const Limits& limits, int stage, std::optional<double> value) {
        if (!limits || limits->size() != 3 || !value || (m_only && kind != *m_only)) {
            return;
        }
        MachineRange check{kind};
        check.stage = stage;
        check.value = *value;
        check.low = (*limits)[0];
        check.high = (*limits)[1];
        check.step = (*limits)[2];
        check.nearest = nearestSetting(check.value, check.low, check.high, check.step);
        const double slack = stepSlack * (check.step > 0 ? check.step : check.high - check.low);
        check.onStep = std::abs(check.value - check.nearest) <= slack;
        m_found.push_back(check);
    }
    std::vector<MachineRange> take() { return std::move(m_found); }

private:
    std::optional<ConstraintKind> m_only;
    std::vector<MachineRange> m_found;
};

/// The requirement whose row names this feed of a stage as its setting.
ConstraintKind kindOf(const StageFeed& feed) {
    const auto row = std::ranges::find_if(requirementRows, [&](const Requirement& each) {
        return each.source == LimitSource::range && each.settingOfStage
               && std::string_view(each.settingOfStage) == feed.key;
    });
    assert(row != requirementRows.end());
    return row->kind;
}

/// A retraction is set as fast as a feed. A spark-out has an axial feed only; a feed of 0 that
/// another one replaces is not set.
std::optional<double> magnitude(const Project& project, const StageFeed& feed, const Stage& stage) {
    const std::optional<double>& value = stage.*feed.value;
    const bool set = stage.feeds() || &feed == project.operation->axial();
    return set && value && *value != 0 ? std::optional(std::abs(*value)) : std::nullopt;
}

} // namespace

std::vector<MachineRange> checkMachineRanges(const Project& project,
                                             std::optional<ConstraintKind> only) {
    const MachineLimits& limits = project.machine->limits;
    Checks checks(only);
    for (const StageFeed& feed : project.operation->feeds) {
        const ConstraintKind kind = kindOf(feed);
        int number = 0;
        for (const Stage& stage : project.cycle->stages) {
            checks.add(kind, limits.*feed.range, ++number, magnitude(project, feed, stage));
        }
    }
    if (project.operation->travels) {
        checks.add(ConstraintKind::rangePlungeFeed, limits.plunge_feed_mm_min, 0,
                   project.machine->plunge_feed_mm_min);
        int number = 0;
        for (const Stage& stage : project.cycle->stages) {
            const double feed = stage.continuousFeed_mm_min();
            checks.add(ConstraintKind::rangeContinuousFeed, limits.continuous_feed_mm_min, ++number,
                       feed > 0 ? std::optional(feed) : std::nullopt); // 0: no feed
        }
    }
    checks.add(ConstraintKind::rangeWorkSpeed, limits.work_speed_rpm, 0,
               project.machine->work_speed_rpm);
    return checks.take();
}

std::optional<GaugeCommands> checkGaugeCommands(const Project& project) {
    if (project.gauge->control != Control::gauge) {
        return {};
    }
    return GaugeCommands{static_cast<int>(project.cycle->stages.size()), project.gauge->commands};
}

double overlapOf(const Project& project, double axialFeed_mm_min) {
    return project.wheel->width_mm * project.machine->work_speed_rpm / axialFeed_mm_min;
}

OverlapCheck checkOverlap(const Project& project, double axialFeed_mm_min, bool last) {
    OverlapCheck check;
    check.overlap = overlapOf(project, axialFeed_mm_min);
    if (leavesStrips(check.overlap)) {
        return check;
    }
    const auto require = [&check](ConstraintKind kind, const std::optional<double>& least) {
        if (least && *least >= check.least) {
            check.kind = kind;
            check.least = *least;
        }
    };
    require(ConstraintKind::leastOverlap, project.least_overlap);
    if (last) {
        require(ConstraintKind::leastOverlapLast, project.least_overlap_last);
    }
    return check;
}

std::vector<OverlapCheck> checkOverlaps(const Project& project) {
    std::vector<OverlapCheck> found;
    const StageFeed* const axial = project.operation->axial();
    const auto& stages = project.cycle->stages;
    for (std::size_t z = 0; axial && z < stages.size(); ++z) {
        const std::optional<double>& axialFeed = stages[z].*axial->value;
        if (axialFeed && *axialFeed > 0) {
            found.push_back(checkOverlap(project, *axialFeed, z + 1 == stages.size()));
            found.back().stage = static_cast<int>(z) + 1;
        }
    }
    return found;
}

bool leavesStrips(const Project& project) {
    const std::vector<OverlapCheck> all = checkOverlaps(project);
    return std::any_of(all.begin(), all.end(),
                       [](const auto& each) { return leavesStrips(each.overlap); });
}

std::optional<StageSteps> fewestSteps(const SimulationResult& result) {
    const auto& stages = result.project.cycle->stages;
    std::optional<StageSteps> fewest;
    for (std::size_t z = 0; z < result.countsByStage.size(); ++z) {
        const bool counts = stages[z].stock_mm > 0 && !stages[z].sparkOutSteps();
        if (counts && (!fewest || result.countsByStage[z] < fewest->steps)) {
            fewest = {static_cast<int>(z) + 1, result.countsByStage[z]};
        }
    }
    return fewest;
}

} // namespace sparkout
