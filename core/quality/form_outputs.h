// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/form/accuracy.h"
#include "core/result.h"

#include <span>

namespace sparkout {

/// The form of a zone with several sections.
struct ZoneFormFigures {
    const SectionAccuracy* worst = nullptr; ///< its least round section
    const ZoneForm* form = nullptr;
    bool isKnown = true; ///< false where strips stay uncut
};

[[nodiscard]] std::span<const Output<ZoneFormFigures>> zoneFormOutputs();

} // namespace sparkout
