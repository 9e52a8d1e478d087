// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"

#include <optional>
#include <stop_token>

namespace sparkout {

/// Returns the project with a stock of the range for which its cycle fails, near the worst one, and
/// of a wheel out of true with its angle; nullopt if the cycle is fit for every stock, or after a
/// stop. The project must be valid and its
/// phases decidable.
///
/// The answer is that of decidePhases(), at a fraction of its cost. The pieces share the runs of
/// visitPhasePieces(), on the blank of the least stock of the range. The result of a shared run
/// differs from that of the cycle with another stock Π of the piece by at most
///
/// * 2·(Π − Π_from) in each diameter, which is larger for a greater stock,
/// * formChange_mm() in each radius and depth of cut,
/// * more stock left below each cut, which never increases the risk of burning.
///
/// So a requirement that is met or violated there by more than a form change below a nanometre can
/// alter (10 nm for values stated in µm, 1 % for values that follow from depths of cut) is so for
/// the whole piece. Burning in the shared run is decided by a run on the piece's own least stock,
/// which is nearest to it. All requirements nearer to their limits, and all requirements where the
/// form changes by more, are decided by two runs at the piece's own ends.
[[nodiscard]] std::optional<Project> failingStock(const Project& project, StockRange range,
                                                  const std::stop_token& stop = {});

} // namespace sparkout
