// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dressing/worn_parts.h"

namespace sparkout {

WornParts::WornParts(const Setup& setup, const SetupRun& first) : m_wear(setup.wear) {
    for (const SurfaceRun& surface : first.surfaces) {
        m_before.push_back(m_part);
        m_part += surface.removed();
    }
}

} // namespace sparkout
