// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/form/accuracy.h"
#include "core/result.h"

#include <span>

namespace sparkout {

/// The form of a zone that holds several sections.
struct ZoneFormFigures {
    const SectionAccuracy* worst = nullptr; ///< of its least round section
    const ZoneForm* form = nullptr;
    bool isKnown = true; ///< not where strips stay uncut
};

[[nodiscard]] std::span<const Output<ZoneFormFigures>> zoneFormOutputs();

} // namespace sparkout
