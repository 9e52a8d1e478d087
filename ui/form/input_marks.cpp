// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/form/input_marks.h"

#include "ui/kit/theme.h"

#include <QPainter>

namespace sparkout {

namespace {

constexpr int rulerWidth = 16, rulerHeight = 10;
constexpr int divisions = 5;

} // namespace

CalibratedMark::CalibratedMark(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setVisible(false);
}

void CalibratedMark::showCalibration(bool holds, const QString& details) {
    m_holds = holds;
    setToolTip(details);
    setAccessibleName(details.section(u'\n', 0, 0));
    setAccessibleDescription(details);
    setVisible(!details.isEmpty());
    update();
}

QSize CalibratedMark::sizeHint() const {
    return {rulerWidth, rulerHeight};
}

void CalibratedMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const QColor colour = tone(m_holds ? Tone::green : Tone::warning, palette());
    constexpr double line = 1.3, half = 0.5;
    painter.setPen(QPen(colour, line));
    const QRectF body = QRectF(rect()).adjusted(half, half, -half, -half);
    painter.drawRect(body);
    for (int i = 1; i < divisions; ++i) {
        const double x = body.left() + body.width() * i / divisions;
        painter.drawLine(QPointF(x, body.top()),
                         QPointF(x, body.top() + body.height() * (i % 2 == 0 ? 0.65 : 0.4)));
    }
    if (!m_holds) {
        painter.drawLine(body.bottomLeft(), body.topRight());
    }
}

namespace {

constexpr int sharedMarkWidth = 15, sharedMarkHeight = 10;
constexpr double ringDiameter = 7; ///< diameter of the ring

} // namespace

SharedMark::SharedMark(QWidget* parent) : QWidget(parent) {
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    setVisible(false);
    retranslate();
}

QString SharedMark::text() {
    return tr("for all surfaces");
}

void SharedMark::retranslate() {
    setToolTip(text());
    setAccessibleName(text());
}

QSize SharedMark::sizeHint() const {
    return {sharedMarkWidth, sharedMarkHeight};
}

void SharedMark::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    constexpr double line = 1.5;
    painter.setPen(QPen(palette().color(QPalette::Highlight), line));
    const double top = (height() - ringDiameter) / 2.0;
    painter.drawEllipse(QRectF(line, top, ringDiameter, ringDiameter));
    painter.drawEllipse(QRectF(width() - line - ringDiameter, top, ringDiameter, ringDiameter));
}

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
