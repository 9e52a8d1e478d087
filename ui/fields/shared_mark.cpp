// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fields/shared_mark.h"

#include <QPainter>

namespace sparkout {

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

} // namespace sparkout
