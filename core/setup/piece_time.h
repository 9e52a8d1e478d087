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
    double calculation_min = 0; ///< T_1 + T_p/N, with the part's share of the preparation
    /// T_1, T_a, one of its times or the service is entered; else T_1 is nothing but the cycles.
    bool isPieceEntered = false;
};

/// Of so many surfaces whose cycles take that long together.
[[nodiscard]] PieceTime pieceTime(const SetupTimes& times, std::size_t surfaces, double cycles_min);

} // namespace sparkout
