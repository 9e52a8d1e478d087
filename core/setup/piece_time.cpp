// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/setup/piece_time.h"

#include "core/units.h"

namespace sparkout {

PieceTime pieceTime(const SetupTimes& times, std::size_t surfaces, double cycles_min) {
    const auto n = static_cast<double>(surfaces);
    const double auxiliary_s = n * (times.approach_s + times.retreat_s + times.gauging_s)
                               + (n - 1) * times.positioning_s + times.handling_s;
    PieceTime piece;
    piece.main_min = times.main_min.value_or(cycles_min);
    piece.auxiliary_min = times.auxiliary_min.value_or(auxiliary_s / units::secondsPerMinute);
    piece.piece_min = times.piece_min.value_or((piece.main_min + piece.auxiliary_min)
                                               * (1 + times.service_percent / 100));
    piece.preparation_min = times.preparation_min;
    piece.isPieceEntered =
        times.piece_min || times.auxiliary_min || auxiliary_s > 0 || times.service_percent > 0;
    piece.calculation_min = piece.piece_min + times.preparation_min / times.batch_size;
    return piece;
}

} // namespace sparkout
