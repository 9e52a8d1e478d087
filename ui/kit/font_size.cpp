// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/font_size.h"

#include <QApplication>
#include <QComboBox>
#include <QEvent>
#include <QFont>
#include <QFontMetrics>
#include <QVariant>
#include <QWidget>

#include <algorithm>

namespace sparkout {

namespace {

// Names of dynamic properties of the program, and of widgets that follow the size.
constexpr const char* systemFont = "sparkoutSystemFont";
constexpr const char* percentNow = "sparkoutFontSize";
constexpr const char* widthWanted = "sparkoutTextWidth";
constexpr const char* leastWidth = "sparkoutTextMinimumWidth";
constexpr const char* leastHeight = "sparkoutTextMinimumHeight";
constexpr const char* linesWanted = "sparkoutTextLines";
constexpr const char* pixelsMore = "sparkoutTextLinesMore";
constexpr const char* timesWanted = "sparkoutFontTimes";
constexpr const char* boldWanted = "sparkoutFontBold";

/// Measured like a label: at some sizes a line is a pixel higher than the font's line spacing.
int heightOfLines(int lines) {
    const QFontMetrics metrics{QApplication::font()};
    const QString text = QStringLiteral("X\n").repeated(lines - 1) + u'X';
    return std::max(metrics.lineSpacing() * lines,
                    metrics.boundingRect(QRect(), Qt::AlignLeft | Qt::AlignTop, text).height());
}

void follow(QWidget& widget) {
    if (const QVariant times = widget.property(timesWanted); times.isValid()) {
        QFont font = enlarged(QApplication::font(), times.toDouble());
        font.setBold(widget.property(boldWanted).toBool());
        widget.setFont(font);
    }
    if (const QVariant width = widget.property(widthWanted); width.isValid()) {
        widget.setFixedWidth(atFontSize(width.toInt()));
    }
    if (const QVariant width = widget.property(leastWidth); width.isValid()) {
        widget.setMinimumWidth(atFontSize(width.toInt()));
    }
    if (const QVariant height = widget.property(leastHeight); height.isValid()) {
        widget.setMinimumHeight(atFontSize(height.toInt()));
    }
    if (const QVariant lines = widget.property(linesWanted); lines.isValid()) {
        widget.setFixedHeight(heightOfLines(lines.toInt()) + widget.property(pixelsMore).toInt());
    }
}

} // namespace

QFont enlarged(QFont font, double times) {
    if (font.pointSizeF() > 0) {
        font.setPointSizeF(font.pointSizeF() * times);
    } else {
        font.setPixelSize(qRound(font.pixelSize() * times));
    }
    return font;
}

int fontSizeFrom(int percent) {
    return std::ranges::find(fontSizes, percent) == fontSizes.end() ? usualFontSize : percent;
}

int appliedFontSize() {
    const QVariant percent = qApp->property(percentNow);
    return percent.isValid() ? percent.toInt() : usualFontSize;
}

void applyFontSize(int percent) {
    if (percent == appliedFontSize()) {
        return;
    }
    if (!qApp->property(systemFont).isValid()) {
        qApp->setProperty(systemFont, QApplication::font());
    }
    qApp->setProperty(percentNow, percent);
    QApplication::setFont(
        enlarged(qApp->property(systemFont).value<QFont>(), percent / double(usualFontSize)));
    for (QWidget* widget : QApplication::allWidgets()) {
        follow(*widget);
        if (auto* box = qobject_cast<QComboBox*>(widget)) { // it would keep its old least width
            QEvent anew(QEvent::StyleChange);
            QCoreApplication::sendEvent(box, &anew);
            box->updateGeometry();
        }
    }
}

int atFontSize(int pixels) {
    return pixels * appliedFontSize() / usualFontSize;
}

void setTextWidth(QWidget& widget, int pixels) {
    widget.setProperty(widthWanted, pixels);
    follow(widget);
}

void setTextMinimumWidth(QWidget& widget, int pixels) {
    widget.setProperty(leastWidth, pixels);
    follow(widget);
}

void setTextMinimumHeight(QWidget& widget, int pixels) {
    widget.setProperty(leastHeight, pixels);
    follow(widget);
}

void setTextLines(QWidget& widget, int lines, int more) {
    widget.setProperty(linesWanted, lines);
    widget.setProperty(pixelsMore, more);
    follow(widget);
}

void setRelativeFont(QWidget& widget, double times, bool bold) {
    widget.setProperty(timesWanted, times);
    widget.setProperty(boldWanted, bold);
    follow(widget);
}

} // namespace sparkout
