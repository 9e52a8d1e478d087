// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/conditions.h"

#include "core/project/gauge.h"
#include "core/project/part.h"

namespace sparkout::conditions {

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
