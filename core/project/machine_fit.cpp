// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/machine_fit.h"

#include "core/project/machine.h"
#include "core/project/part.h"
#include "core/project/wheel.h"

#include <limits>
#include <optional>

namespace sparkout {

Issues machineMisfits(const Project& project) {
    const Part& part = *project.part;
    const Wheel& wheel = *project.wheel;
    const MachineLimits& limits = project.machine->limits;
    Issues misfits;
    const auto compare = [&misfits](const char* path, double size_mm, const char* limit,
                                    const Range& taken_mm) {
        if (!taken_mm.contains(size_mm)) {
            misfits.push_back({IssueCode::machineMisfit, Severity::warning, path,
                               Amount{size_mm, "mm"},
                               Bounds{.range = taken_mm, .unit = "mm", .field = limit}});
        }
    };
    const auto atMost = [](const std::optional<double>& most_mm) {
        return Range{.high = most_mm.value_or(std::numeric_limits<double>::infinity())};
    };
    if (part.surface == Surface::external) {
        compare("/part/diameter_mm", part.diameter_mm, "/machine/limits/part_diameter_mm",
                atMost(limits.part_diameter_mm));
    }
    const bool hasSteps = !part.shaft.segments.empty();
    compare(hasSteps ? "/part/shaft/segments" : "/part/length_mm",
            hasSteps ? lengthOf(part.shaft) : part.length_mm, "/machine/limits/part_length_mm",
            atMost(limits.part_length_mm));
    compare("/wheel/diameter_mm", wheel.diameter_mm, "/machine/limits/wheel_diameter_mm",
            atMost(limits.wheel_diameter_mm));
    if (const auto& width_mm = limits.wheel_width_mm; width_mm && width_mm->size() == 2) {
        compare("/wheel/width_mm", wheel.width_mm, "/machine/limits/wheel_width_mm",
                {width_mm->front(), width_mm->back()});
    }
    if (const auto& seat_mm = limits.wheel_bore_mm) {
        const auto marking = readWheelMarking(wheel.marking);
        compare("/wheel/marking", marking ? marking->bore_mm.value_or(*seat_mm) : *seat_mm,
                "/machine/limits/wheel_bore_mm", {*seat_mm, *seat_mm});
    }
    return misfits;
}

bool isPartMisfit(const Issue& misfit) {
    return misfit.path.starts_with("/part/");
}

} // namespace sparkout
