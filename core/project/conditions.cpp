// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/conditions.h"

#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/part.h"
#include "core/project/wheel.h"

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

bool wheelRunout(const Project& p, const void*) {
    return p.wheel->runout.has_value();
}

bool unbalanced(const Project& p, const void*) {
    return p.wheel->runout && p.wheel->runout->isForced();
}

} // namespace sparkout::conditions
