// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/shop_numbers.h"
#include "tests/core/support/project_fixtures.h"
#include "tests/core/support/random_project.h"

#include <QtGlobal>

#include <cstdint>
#include <numbers>
#include <vector>

/// Cycles whose numbers for the shop are known otherwise.
namespace sparkout::shop_cycles {

/// Random cycles of every kind; fewer under the sanitizers.
inline int seeds() {
    return qEnvironmentVariableIsSet("SPARKOUT_QUICK") ? 30 : 300;
}

inline Project random(int seed) {
    return fixtures::read(randomProject(std::uint64_t(seed)));
}

inline double workSpeed(const Project& p) { // [mm/s]
    return std::numbers::pi * p.part->diameter_mm * p.machine->work_speed_rpm / 60;
}

/// Two rigid plunge stages of whole revolutions, one section, 4 radii, a round blank: from the
/// second revolution on every radius is cut exactly the feed of a revolution deep.
inline Project rigidPlunge() {
    Project p = fixtures::plunge();
    p.gauge->control = Control::position;
    p.machine->compliance_mm_per_n = std::vector<double>{1e-15};
    p.part->stock_mm = 0.12;
    p.cycle->stages = {fixtures::plungeStage(0.9, 0.1), fixtures::plungeStage(0.18, 0.02)};
    return p;
}

} // namespace sparkout::shop_cycles
