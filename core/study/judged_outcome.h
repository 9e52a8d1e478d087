// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/judgement/judgement.h"
#include "core/study/outcome.h"
#include "core/study/whole_batch.h"

#include <stop_token>

namespace sparkout {

/// Judges an outcome for every stock within one infeed, which is decided here, and for a batch of
/// the same inputs, which may be null. Used by reports, which wait for the decision.
[[nodiscard]] Judgement judgementOf(const Outcome& outcome, const BatchOutcome* batch = nullptr,
                                    const std::stop_token& stop = {});

} // namespace sparkout
