// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/dressing/worn_parts.h"

namespace sparkout {

WornParts::WornParts(const Setup& setup, const SetupRun& first) {
    double before_mm3 = 0;
    for (std::size_t i = 0; i < setup.surfaces.size(); ++i) {
        m_surfaces.push_back(surfaceWear(setup, i, before_mm3));
        before_mm3 += i < first.surfaces.size() ? first.surfaces[i].removed_mm3 : 0;
    }
}

} // namespace sparkout
