// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/setup/setup_times.h"

#include <cstddef>

namespace sparkout {

/// The standard times of a part in one set-up, in minutes.
struct PieceTime {
    double main_min = 0;        ///< T_o, as given or the sum of the cycles
    double auxiliary_min = 0;   ///< T_a, as given or n·(approach + retreat + gauging)
                                ///< + (n − 1)·positioning + handling for n surfaces
    double piece_min = 0;       ///< T_1, as given or (T_o + T_a)·(1 + service/100)
    double preparation_min = 0; ///< T_p, as given
    double calculation_min = 0; ///< T_1 + T_p/N, including the part's share of the set-up time
    /// T_1, T_a, one of its times or the service is entered; otherwise T_1 is the time of the
    /// cycles alone.
    bool isPieceEntered = false;
};

/// The time of a piece with so many surfaces whose cycles take `cycles_min` together.
[[nodiscard]] PieceTime pieceTime(const SetupTimes& times, std::size_t surfaces, double cycles_min);

} // namespace sparkout
