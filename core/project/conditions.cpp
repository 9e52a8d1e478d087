// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/conditions.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/part.h"

namespace sparkout::conditions {

bool gaugeEndsAStage(const Project& p, const void*) {
    const auto& stages = p.cycle->stages;
    return p.gauge->control == Control::gauge || (!stages.empty() && stages.back().waitsForSize());
}

bool byPosition(const Project& p, const void*) {
    return p.gauge->control == Control::position;
}

bool external(const Project& p, const void*) {
    return p.part->surface == Surface::external;
}

bool internal(const Project& p, const void*) {
    return p.part->surface == Surface::internal;
}

} // namespace sparkout::conditions
