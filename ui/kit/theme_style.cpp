// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/theme_style.h"

#include "ui/kit/theme.h"

#include <QGroupBox>
#include <QPainter>
#include <QStyleFactory>
#include <QStyleOption>

#include <algorithm>

namespace sparkout {

namespace {

constexpr double corner = 2;
constexpr int groupBoxMargin = 3; ///< Fusion's, between the title of a box and its frame
constexpr double disabledOpacity = 0.5;

/// Draws a frame just inside a rectangle.
void outline(QPainter& painter, const QRect& rect, const QStyleOption& option) {
    if (rect.isEmpty()) {
        return;
    }
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setOpacity(option.state & QStyle::State_Enabled ? 1 : disabledOpacity);
    painter.setPen(QPen(tone(Tone::outline, option.palette), 1));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect).adjusted(0.5, 0.5, -0.5, -0.5), corner, corner);
    painter.restore();
}

/// Draws a line along the outer edge of the current tab.
void markTab(QPainter& painter, const QStyleOptionTab& tab) {
    constexpr int high = 2, beside = 2;
    if (!(tab.state & QStyle::State_Selected)) {
        return;
    }
    QRect line = tab.rect.adjusted(beside, 0, -beside, 0);
    switch (tab.shape) {
    case QTabBar::RoundedNorth: line.setHeight(high); break;
    case QTabBar::RoundedSouth: line.setTop(line.bottom() - high + 1); break;
    default: return; // vertical tabs are not used
    }
    painter.fillRect(line, tone(Tone::accent, tab.palette));
}

QRect frameOfBox(const QStyle& style, const QStyleOption& option, const QWidget* widget) {
    const auto* box = qobject_cast<const QGroupBox*>(widget);
    const bool bare = box && !box->isCheckable() && box->title().isEmpty();
    const int title = bare
                          ? 0
                          : std::max(style.pixelMetric(QStyle::PM_IndicatorHeight, &option, widget),
                                     option.fontMetrics.height());
    return option.rect.adjusted(0, title + groupBoxMargin, 0, 0);
}

} // namespace

ThemeStyle::ThemeStyle() : QProxyStyle(QStyleFactory::create(QStringLiteral("Fusion"))) {}

int ThemeStyle::pixelMetric(PixelMetric metric, const QStyleOption* option,
                            const QWidget* widget) const {
    // Padding that lets all tabs of the views fit on a small screen.
    constexpr int besideTabText = 8, besideNarrowText = 6;
    if (metric == PM_TabBarTabHSpace) {
        const bool isNarrow = widget && widget->font().stretch() != QFont::AnyStretch
                              && widget->font().stretch() < QFont::Unstretched;
        return isNarrow ? besideNarrowText : besideTabText;
    }
    return QProxyStyle::pixelMetric(metric, option, widget);
}

void ThemeStyle::drawPrimitive(PrimitiveElement element, const QStyleOption* option,
                               QPainter* painter, const QWidget* widget) const {
    QProxyStyle::drawPrimitive(element, option, painter, widget);
    const bool focused =
        option->state & State_HasFocus && option->state & State_KeyboardFocusChange;
    switch (element) {
    case PE_FrameLineEdit:
        if (!(option->state & State_HasFocus)) { // with the focus, Fusion highlights it
            outline(*painter, option->rect, *option);
        }
        break;
    case PE_PanelButtonCommand:
        if (!focused) {
            outline(*painter, option->rect, *option);
        }
        break;
    case PE_Frame: outline(*painter, option->rect, *option); break;
    case PE_IndicatorCheckBox: outline(*painter, option->rect, *option); break;
    case PE_FrameGroupBox: outline(*painter, frameOfBox(*this, *option, widget), *option); break;
    default: break;
    }
}

/// Draws the title of a dock in its current font: Qt 6.4 keeps the font from its creation.
void ThemeStyle::drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                             const QWidget* widget) const {
    if (element != CE_DockWidgetTitle || !widget) {
        QProxyStyle::drawControl(element, option, painter, widget);
        if (element == CE_TabBarTabShape) {
            if (const auto* tab = qstyleoption_cast<const QStyleOptionTab*>(option)) {
                markTab(*painter, *tab);
            }
        }
        return;
    }
    painter->save();
    painter->setFont(widget->font());
    QProxyStyle::drawControl(element, option, painter, widget);
    painter->restore();
}

void ThemeStyle::drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                                    QPainter* painter, const QWidget* widget) const {
    QProxyStyle::drawComplexControl(control, option, painter, widget);
    const auto part = [&](SubControl which) {
        return subControlRect(control, option, which, widget);
    };
    switch (control) {
    case CC_SpinBox:
        if (!(option->state & State_HasFocus)) {
            outline(*painter, option->rect, *option);
        }
        break;
    case CC_Slider: outline(*painter, part(SC_SliderHandle), *option); break;
    case CC_ScrollBar: outline(*painter, part(SC_ScrollBarSlider), *option); break;
    default: break;
    }
}

int ThemeStyle::styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                          QStyleHintReturn* answer) const {
    if (hint == SH_Table_GridLineColor && option) {
        const QColor line = tone(Tone::outline, option->palette);
        const QColor ground = option->palette.color(QPalette::Base);
        const auto mean = [](int a, int b) { return (a + 2 * b) / 3; };
        return static_cast<int>(QColor(mean(line.red(), ground.red()),
                                       mean(line.green(), ground.green()),
                                       mean(line.blue(), ground.blue()))
                                    .rgba());
    }
    return QProxyStyle::styleHint(hint, option, widget, answer);
}

} // namespace sparkout
