// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/reset_mark.h"

#include <QPainter>

namespace sparkout {

namespace {

constexpr int side = 12;
constexpr double dotRadius = 3;

} // namespace

ResetMark::ResetMark(QWidget* parent) : QAbstractButton(parent) {
    setFocusPolicy(Qt::NoFocus); // by keys: the context menu of its field
    setCursor(Qt::PointingHandCursor);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setAttribute(Qt::WA_Hover);
    QSizePolicy keepsPlace = sizePolicy(); // labels are not wrapped again after each change
    keepsPlace.setRetainSizeWhenHidden(true);
    setSizePolicy(keepsPlace);
    setVisible(false);
}

QSize ResetMark::sizeHint() const {
    return {side, side};
}

void ResetMark::showChanged(bool changed) {
    setVisible(changed);
}

void ResetMark::showDefault(const QString& label, const QString& defaultText) {
    m_default = defaultText;
    setToolTip(tr("Changed; the default is: %1. Click to go back to it.").arg(defaultText));
    setAccessibleName(tr("%1: reset to the default").arg(label));
    setAccessibleDescription(toolTip());
}

QString ResetMark::menuText() const {
    return tr("&Reset to the default (%1)")
        .arg(QString(m_default).replace(u'&', QStringLiteral("&&")));
}

void ResetMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor color =
        palette().color(isEnabled() ? QPalette::Active : QPalette::Disabled, QPalette::Highlight);
    const QPointF middle = QRectF(rect()).center();
    painter.setPen(Qt::NoPen);
    painter.setBrush(color);
    painter.drawEllipse(middle, dotRadius, dotRadius);
    if (underMouse() || isDown()) {
        painter.setBrush(Qt::NoBrush);
        painter.setPen(QPen(color, 1));
        painter.drawEllipse(middle, dotRadius + 2, dotRadius + 2);
    }
}

} // namespace sparkout
