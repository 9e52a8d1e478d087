// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/phases/phase_decision.h"

#include <optional>
#include <stop_token>

namespace sparkout {

/// A stock of the range [mm] for which the project's cycle fails, near where it does by most;
/// nothing: it holds for each of them. Of a valid project whose phases can be decided. A stop ends
/// it with nothing.
///
/// The answer is that of decidePhases(), at a fraction of its cost. The pieces share the runs of
/// visitPhasePieces(), on the blank of the least stock of the range. What these leave differs from
/// what the cycle leaves of another stock Π of the piece by no more than
///
/// * 2·(Π − Π_from) of each diameter, in the sense that a greater stock leaves more of it,
/// * formChange_mm() of each radius and depth of cut,
/// * more stock left below each cut, which never brings it nearer to burning.
///
/// So a requirement that holds or fails there by more than a form change below a nanometre can
/// undo, 10 nm of what is stated in µm and 1 % of what follows from depths of cut, does so for all
/// of the piece. Burning that the shared run shows is decided by a run on the piece's own least
/// stock, which is the nearest to it. What else is nearer, and all where the form changes by more,
/// is decided by two runs on the piece's own ends.
[[nodiscard]] std::optional<double> failingStock_mm(const Project& project, StockRange range,
                                                    const std::stop_token& stop = {});

} // namespace sparkout
