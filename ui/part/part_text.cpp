// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/part_text.h"

#include "core/quality/light.h"
#include "ui/charts/light_icon.h"
#include "ui/kit/theme.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QPainter>
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

struct StatusText {
    Q_DECLARE_TR_FUNCTIONS(StatusText)
};

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

QString statusText(const SurfaceStatus& status) {
    switch (status.state) {
    case SurfaceStatus::State::notRun: return StatusText::tr("not run");
    case SurfaceStatus::State::refused: return StatusText::tr("inputs refused");
    case SurfaceStatus::State::ran: break;
    }
    return JudgementText::headline(status.judgement);
}

QString worstText(const SurfaceStatus& status) {
    const std::optional<ConstraintResult>& worst = status.judgement.worst;
    if (!status.ran() || !worst) {
        return {};
    }
    const char* const unit = requirementOf(worst->kind).unit;
    const QString margin = Names::margin(*worst);
    return QStringLiteral("%1 %2").arg(
        Names::constraintBrief(worst->kind),
        *unit && !Names::isRange(worst->kind) && marginKnown(*worst) != MarginKnown::no
            ? QStringLiteral("%1\u00a0%2").arg(margin, unitText(unit))
            : margin);
}

QPixmap statusPixmap(const SurfaceStatus& status, int size, qreal ratio) {
    if (status.ran()) {
        return judgedPixmap(status.judgement.state, size, ratio, status.areStocksComing);
    }
    QPixmap pixmap(QSize(size, size) * ratio);
    pixmap.setDevicePixelRatio(ratio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    painter.setRenderHint(QPainter::Antialiasing);
    const QPalette palette = QGuiApplication::palette();
    const QRectF box(2, 2, size - 4, size - 4);
    if (status.state == SurfaceStatus::State::refused) {
        painter.setPen(QPen(tone(Tone::error, palette), 2));
        painter.drawLine(box.topLeft(), box.bottomRight());
        painter.drawLine(box.topRight(), box.bottomLeft());
    } else {
        painter.setPen(QPen(palette.color(QPalette::PlaceholderText), 1));
        painter.drawEllipse(box);
    }
    return pixmap;
}

} // namespace sparkout
