// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/part/status_text.h"

#include "ui/charts/light_icon.h"
#include "ui/charts/verdict_table.h"
#include "ui/kit/theme.h"
#include "ui/text/names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QGuiApplication>
#include <QPainter>

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
    return status.isCompleted ? lightName(status.light) : StatusText::tr("cannot reach size");
}

QString worstText(const SurfaceStatus& status) {
    if (!status.ran() || !status.worst) {
        return {};
    }
    const char* const unit = requirementOf(status.worst->kind).unit;
    const QString margin = Names::margin(*status.worst);
    return QStringLiteral("%1 %2").arg(
        Names::constraintBrief(status.worst->kind),
        *unit && !Names::isRange(status.worst->kind)
            ? QStringLiteral("%1\u00a0%2").arg(margin, unitText(unit))
            : margin);
}

QPixmap statusPixmap(const SurfaceStatus& status, int size, qreal ratio) {
    if (status.ran()) {
        return lightPixmap(status.light, size, ratio, false);
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
