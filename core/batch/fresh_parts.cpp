// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/batch/fresh_parts.h"

#include "core/project/batch.h"

#include <limits>

namespace sparkout {

Project withFreshParts(Project project, int draw, int count) {
    constexpr unsigned mostSeed = std::numeric_limits<int>::max(), apart = 1'000'003;
    Batch& batch = *project.batch;
    const unsigned seed = static_cast<unsigned>(batch.seed) + apart * static_cast<unsigned>(draw);
    batch.seed = static_cast<int>(seed & mostSeed);
    batch.scenarios = Scenarios::random;
    batch.parts = count;
    return project;
}

} // namespace sparkout
