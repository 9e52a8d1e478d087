// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/machine_steps.h"

#include "core/project/machine.h"
#include "core/project/operation.h"
#include "core/project/project.h"

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

constexpr std::string_view stagesPath("/cycle/stages/");
constexpr double onStep = 1e-6; ///< share of a step: values this near to one count as on it

double withoutLastBits(double value) {
    constexpr double tidy = 1e9;
    return std::round(value * tidy) / tidy;
}

std::string_view keyOf(std::string_view path) {
    return path.substr(path.rfind('/') + 1);
}

std::optional<std::vector<double>> MachineLimits::*statedFor(const Project& project,
                                                             std::string_view path) {
    if (path == "/machine/work_speed_rpm") {
        return &MachineLimits::work_speed_rpm;
    }
    if (path == "/machine/plunge_feed_mm_min") {
        return &MachineLimits::plunge_feed_mm_min;
    }
    if (!path.starts_with(stagesPath)) {
        return nullptr;
    }
    for (const StageFeed& feed : project.operation->feeds) {
        if (keyOf(path) == feed.key) {
            return feed.range;
        }
    }
    return keyOf(path) == "continuous_feed_mm_min" ? &MachineLimits::continuous_feed_mm_min
                                                   : nullptr;
}

} // namespace

double MachineSteps::nearest(double value) const {
    return withoutLastBits(low + std::round((value - low) / step) * step);
}

double MachineSteps::stepped(double value, int steps) const {
    if (value < 0) {
        return -stepped(-value, -steps);
    }
    const double place = (value - low) / step;
    const double from = steps > 0 ? std::floor(place + onStep) : std::ceil(place - onStep);
    const double last = std::floor((high - low) / step + onStep); // infinite if high is
    const double next = withoutLastBits(low + std::clamp(from + steps, 0.0, last) * step);
    return (next - value) * steps > 0 ? next : value; // one beyond the ends stays there
}

const std::vector<double>* machineRange(const Project& project, std::string_view path) {
    const auto stated = statedFor(project, path);
    const auto* range = stated ? &(project.machine->limits.*stated) : nullptr;
    return range && *range && (*range)->size() == 3 ? &**range : nullptr;
}

std::optional<MachineSteps> machineSteps(const Project& project, std::string_view path) {
    if (path.starts_with(stagesPath) && keyOf(path) == "stock_mm") {
        const auto& infeed = project.machine->limits.radial_feed_mm;
        return infeed && infeed->size() == 3 && infeed->back() > 0
                   ? std::optional(MachineSteps{.step = infeed->back()})
                   : std::nullopt;
    }
    const std::vector<double>* range = machineRange(project, path);
    if (!range || !((*range)[2] > 0) || !((*range)[0] <= (*range)[1])) {
        return {};
    }
    return MachineSteps{(*range)[0], (*range)[1], (*range)[2]};
}

std::optional<double> steppedOnMachine(const Project& project, std::string_view path, double value,
                                       int steps) {
    const auto on = machineSteps(project, path);
    return on ? std::optional(on->stepped(value, steps)) : std::nullopt;
}

} // namespace sparkout
