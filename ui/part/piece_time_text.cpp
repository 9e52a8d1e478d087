// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/piece_time_text.h"

#include "ui/text/number_text.h"

#include <QCoreApplication>
#include <QStringList>

namespace sparkout {

namespace {

struct PieceTimeText {
    Q_DECLARE_TR_FUNCTIONS(PieceTimeText)
};

constexpr int timeTextDigits = 4;

QString shownTime(double value) {
    return printedNumber(value, timeTextDigits);
}

/// A short sum of seconds; the time itself is in minutes.
QString auxiliaryLine(const SetupTimes& times, std::size_t surfaces, const PieceTime& piece) {
    if (times.auxiliary_min) {
        return PieceTimeText::tr("T_a = %1 min, as given").arg(shownTime(piece.auxiliary_min));
    }
    return PieceTimeText::tr("T_a = n·(approach + retreat + gauging) + (n − 1)·positioning + "
                             "handling = %1·(%2 + %3 + %4) + %5·%6 + %7 s = %8 min")
        .arg(surfaces)
        .arg(shownTime(times.approach_s), shownTime(times.retreat_s), shownTime(times.gauging_s))
        .arg(surfaces - 1)
        .arg(shownTime(times.positioning_s), shownTime(times.handling_s),
             shownTime(piece.auxiliary_min));
}

} // namespace

QString pieceTimeText(const SetupTimes& times, std::size_t surfaces,
                      std::optional<double> cycles_min) {
    QStringList lines;
    const bool isMainKnown = times.main_min || cycles_min;
    const PieceTime piece = pieceTime(times, surfaces, cycles_min.value_or(0));
    if (times.main_min) {
        lines += PieceTimeText::tr("T_o = %1 min, as given").arg(shownTime(piece.main_min));
    } else if (cycles_min) {
        lines += PieceTimeText::tr("T_o = sum of the cycles = %1 min").arg(shownTime(*cycles_min));
    } else {
        lines += PieceTimeText::tr("T_o: not known, not every cycle ends at size");
    }
    if (!piece.isPieceEntered) {
        lines += PieceTimeText::tr("T_a is not entered, so no piece time is stated");
        return lines.join(u'\n');
    }
    lines += auxiliaryLine(times, surfaces, piece);
    if (times.piece_min) {
        lines += PieceTimeText::tr("T_1 = %1 min, as given").arg(shownTime(piece.piece_min));
    } else if (isMainKnown) {
        lines += PieceTimeText::tr("T_1 = (T_o + T_a)·(1 + service/100) = (%1 + %2)·(1 + %3/100) "
                                   "= %4 min")
                     .arg(shownTime(piece.main_min), shownTime(piece.auxiliary_min),
                          shownTime(times.service_percent), shownTime(piece.piece_min));
    }
    if (times.piece_min || isMainKnown) {
        lines += PieceTimeText::tr("T_1 + T_p/N = %1 + %2/%3 = %4 min")
                     .arg(shownTime(piece.piece_min), shownTime(times.preparation_min))
                     .arg(times.batch_size)
                     .arg(shownTime(piece.calculation_min));
    }
    return lines.join(u'\n');
}

} // namespace sparkout
