// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/status_text.h"

#include "core/quality/light.h"
#include "ui/charts/light_icon.h"
#include "ui/kit/theme.h"
#include "ui/text/judgement_text.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QPainter>

#include <optional>

namespace sparkout {

namespace {

struct StatusText {
    Q_DECLARE_TR_FUNCTIONS(StatusText)
};

} // namespace

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
