// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/search/variants.h"

#include "core/grace_stop.h"
#include "core/project/machine.h"
#include "core/project/optimisation.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "core/quality/shop_numbers.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace sparkout {

namespace {

std::vector<double> listed(const Levels& levels, double own) {
    std::vector<double> values = levelValues(levels);
    return values.empty() ? std::vector<double>{own} : values;
}

Levels only(double value) {
    return std::vector<double>{value};
}

double levelsOrOne(const Levels& levels) {
    return std::max(levelCount(levels), 1.0);
}

/// Number of combinations of dwells at the reversals.
double dwellPairs(const Project& project) {
    const Optimisation& asked = *project.optimisation;
    return project.operation->travels
               ? levelsOrOne(asked.dwell_entry_s) * levelsOrOne(asked.dwell_exit_s)
               : 1;
}

/// Number of work speeds, dwells at the reversals and counts of spark-outs, as listed.
double combinations(const Project& project) {
    const Optimisation& asked = *project.optimisation;
    return levelsOrOne(asked.work_speed_rpm) * dwellPairs(project) * levelsOrOne(asked.unfed_steps);
}

/// The grid with one count of spark-outs.
Grid gridWith(Project project, double sparkOut) {
    project.optimisation->unfed_steps = only(sparkOut);
    return Grid(project);
}

/// A grid for each count: two are read, with and without a spark-out; the others differ only in the
/// count.
std::vector<std::shared_ptr<const Grid>> gridsOf(const Project& project,
                                                 const std::vector<double>& sparkOuts) {
    std::vector<std::shared_ptr<const Grid>> grids;
    std::shared_ptr<const Grid> read;
    for (const double sparkOut : sparkOuts) {
        const int count = static_cast<int>(sparkOut);
        if (count > 0 && read) {
            grids.push_back(std::make_shared<const Grid>(read->withSparkOut(count)));
            continue;
        }
        grids.push_back(std::make_shared<const Grid>(gridWith(project, sparkOut)));
        read = count > 0 ? grids.back() : read;
    }
    return grids;
}

} // namespace

MachineSettings machineSettings(const Project& project) {
    return {project.machine->work_speed_rpm, project.machine->dwell_entry_s,
            project.machine->dwell_exit_s,
            project.wheel->runout ? project.part->radii_per_section : 0};
}

void setMachine(Project& project, const MachineSettings& settings) {
    project.machine->work_speed_rpm = settings.work_speed_rpm;
    project.machine->dwell_entry_s = settings.dwell_entry_s;
    project.machine->dwell_exit_s = settings.dwell_exit_s;
    if (settings.radii > 0) {
        project.part->radii_per_section = settings.radii;
    }
    resolveWaves(project);
}

std::optional<double> leastRatioDistance(const Project& project) {
    const Optimisation& asked = *project.optimisation;
    const bool isChosen = listed(asked.work_speed_rpm, project.machine->work_speed_rpm).size() > 1;
    return asked.least_ratio_distance || project.wheel->runout || !isChosen
               ? asked.least_ratio_distance
               : nearRatio;
}

SearchedSpeeds searchedSpeeds(const Project& project) {
    const Optimisation& asked = *project.optimisation;
    const std::optional<double> least = leastRatioDistance(project);
    const double wheel_rpm = wheelSpeed_rpm(project);
    SearchedSpeeds speeds;
    for (const double work_rpm : listed(asked.work_speed_rpm, project.machine->work_speed_rpm)) {
        const bool isAllowed = !least || distanceFromWhole(wheel_rpm / work_rpm) >= *least;
        (isAllowed ? speeds.allowed : speeds.leftOut).push_back(work_rpm);
    }
    if (speeds.allowed.empty() && !asked.least_ratio_distance) { // by default none is refused
        speeds.allowed.swap(speeds.leftOut);
    }
    return speeds;
}

double farthestSpeed_rpm(const Project& project, double level_rpm, double end_rpm) {
    const std::optional<double> least = leastRatioDistance(project);
    if (!least) {
        return end_rpm;
    }
    constexpr double lastBits = 1e-9; // relative
    const double wheel_rpm = wheelSpeed_rpm(project);
    const auto steps = machineSteps(project, "/machine/work_speed_rpm");
    const double side = end_rpm < level_rpm ? 1 : -1; // towards the level
    double speed_rpm = end_rpm;
    while ((level_rpm - speed_rpm) * side > lastBits * level_rpm) {
        const double ratio = wheel_rpm / speed_rpm, whole = std::max(std::round(ratio), 1.0);
        if (distanceFromWhole(ratio) >= *least) {
            return speed_rpm;
        }
        const double before_rpm = speed_rpm;
        speed_rpm = wheel_rpm / (whole - side * *least) * (1 + side * lastBits);
        if (steps) { // the next one that can be set
            const double place = (speed_rpm - steps->low) / steps->step;
            const double onStep = side > 0 ? std::ceil(place) : std::floor(place);
            speed_rpm = steps->low + onStep * steps->step;
        }
        if ((speed_rpm - before_rpm) * side <= 0) {
            speed_rpm = before_rpm + side * (steps ? steps->step : lastBits * before_rpm);
        }
    }
    return level_rpm;
}

Variants::Variants(const Project& project, const std::stop_token& stop) {
    Project plain = project;
    plain.runs.clear();
    if (!project.optimisation) {
        m_fault = GridFault::notGiven;
        return;
    }
    Optimisation& asked = *plain.optimisation;
    if (!project.operation->travels) {
        asked.dwell_entry_s = asked.dwell_exit_s = {};
    }
    if (combinations(project) > mostVariants) {
        m_fault = GridFault::tooManyVariants;
        return;
    }
    const Grace grace(stop);
    const MachineSettings own = machineSettings(project);
    const std::vector<double> speeds = searchedSpeeds(project).allowed,
                              entries = listed(asked.dwell_entry_s, own.dwell_entry_s),
                              exits = listed(asked.dwell_exit_s, own.dwell_exit_s),
                              sparkOuts = listed(asked.unfed_steps, 0);
    if (speeds.empty()) {
        m_fault = GridFault::wholeRatio;
        return;
    }
    const std::vector<std::shared_ptr<const Grid>> grids = gridsOf(plain, sparkOuts);
    const MachineSettings given = machineSettings(project);
    for (const double speed : speeds) {
        m_isCutShort = grace.isOver();
        if (m_isCutShort) {
            break;
        }
        for (const double entry : entries) {
            for (const double exit : exits) {
                for (std::size_t i = 0; i < sparkOuts.size(); ++i) {
                    setMachine(plain, {speed, entry, exit, given.radii});
                    asked.work_speed_rpm = only(speed);
                    asked.dwell_entry_s = only(entry);
                    asked.dwell_exit_s = only(exit);
                    asked.unfed_steps = only(sparkOuts[i]);
                    m_variants.push_back({plain, grids[i]});
                }
            }
        }
    }
    const bool any = std::any_of(m_variants.begin(), m_variants.end(), [](const Variant& each) {
        return each.grid->fault() == GridFault::none;
    });
    if (!any && !m_isCutShort) {
        m_fault = m_variants.front().grid->fault();
        m_variants.clear();
    }
}

bool Variants::differInOne(std::size_t a, std::size_t b) const {
    const MachineSettings x = machineSettings(project(a)), y = machineSettings(project(b));
    const int differences = static_cast<int>(x.work_speed_rpm != y.work_speed_rpm)
                            + static_cast<int>(x.dwell_entry_s != y.dwell_entry_s)
                            + static_cast<int>(x.dwell_exit_s != y.dwell_exit_s)
                            + static_cast<int>(grid(a).sparkOut() != grid(b).sparkOut());
    return differences == 1;
}

// The number of cycles of a variant depends only on whether they spark out.
std::int64_t Variants::size() const {
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    std::array<std::optional<std::int64_t>, 2> sizes;
    std::int64_t sum = 0;
    for (const Variant& each : m_variants) {
        if (each.grid->fault() != GridFault::none) {
            continue;
        }
        std::optional<std::int64_t>& size = sizes[each.grid->sparkOut() > 0 ? 1 : 0];
        size = size ? size : each.grid->size();
        sum = *size > most - sum ? most : sum + *size;
    }
    return sum;
}

std::int64_t gridSize(const Project& project) {
    if (!project.optimisation || combinations(project) > mostVariants) {
        return 0;
    }
    Project plain = project;
    plain.runs.clear();
    plain.batch.reset();
    const std::vector<double> sparkOuts = listed(project.optimisation->unfed_steps, 0);
    const double others =
        static_cast<double>(searchedSpeeds(project).allowed.size()) * dwellPairs(project);
    std::array<std::optional<Grid>, 2> grids;
    long double sum = 0;
    for (const double sparkOut : sparkOuts) {
        if (sum > 9.3e18L) {
            break; // more than can be stated
        }
        std::optional<Grid>& grid = grids[static_cast<int>(sparkOut) > 0 ? 1 : 0];
        if (!grid) {
            grid = gridWith(plain, sparkOut);
        }
        sum += others * static_cast<long double>(grid->size());
    }
    constexpr auto most = std::numeric_limits<std::int64_t>::max();
    return sum < 9e18L ? std::llround(sum) : most;
}

} // namespace sparkout
