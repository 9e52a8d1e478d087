// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/run_dash.h"

#include <QPainter>

#include <array>

namespace sparkout {

namespace {

constexpr double dashWidth = 1.6;
constexpr double thicker = 1.2; ///< factor on the width for each repetition of the patterns

const std::array<QVector<qreal>, 6>& runDashes() {
    static const std::array<QVector<qreal>, 6> all{
        QVector<qreal>{4, 2}, QVector<qreal>{1, 1.5}, QVector<qreal>{6, 1.5, 1, 1.5},
        QVector<qreal>{8, 3}, QVector<qreal>{2, 2},   QVector<qreal>{6, 1.5, 1, 1.5, 1, 1.5}};
    return all;
}

} // namespace

QVector<qreal> runDash(int number) {
    return number > 0 ? runDashes()[static_cast<std::size_t>(number - 1) % runDashes().size()]
                      : QVector<qreal>();
}

QPen runPen(int number, const QColor& colour) {
    const int round = number > 0 ? (number - 1) / static_cast<int>(runDashes().size()) : 0;
    QPen pen(colour, dashWidth + thicker * round, Qt::SolidLine, Qt::FlatCap);
    if (const QVector<qreal> dash = runDash(number); !dash.isEmpty()) {
        pen.setDashPattern(dash);
    }
    return pen;
}

QPixmap runSample(int number, const QColor& colour, const QSize& size, qreal ratio) {
    QPixmap sample((QSizeF(size) * ratio).toSize());
    sample.setDevicePixelRatio(ratio);
    sample.fill(Qt::transparent);
    QPainter painter(&sample);
    painter.setPen(runPen(number, colour));
    const double middle = size.height() / 2.0;
    painter.drawLine(QLineF(0, middle, size.width(), middle));
    return sample;
}

} // namespace sparkout
