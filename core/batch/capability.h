// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_summary.h"

namespace sparkout {

/// Adds P_p, P_pk and the expected share outside to a summary, from its mean, deviation and count.
/// Nothing is added where the characteristic has no capability or negligible scatter.
void addCapability(CharacteristicSummary& summary);

} // namespace sparkout
