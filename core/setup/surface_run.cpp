// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/surface_run.h"

#include "core/quality/shop_numbers.h"
#include "core/simulation/simulate.h"

#include <algorithm>

namespace sparkout {

bool SurfaceRun::holds() const {
    return isCompleted() && std::ranges::all_of(constraints, &ConstraintResult::holds);
}

SurfaceRun runSurface(const std::string& name, const Project& project,
                      const std::stop_token& stop) {
    SurfaceRun run{name, simulate(project, nullptr, stop), {}, 0};
    run.constraints = evaluateConstraints(run.result);
    run.removed_mm3 = removedVolume_mm3(run.result);
    return run;
}

} // namespace sparkout
