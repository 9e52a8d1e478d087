// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/theme.h"

#include <QApplication>
#include <QGroupBox>
#include <QPainter>
#include <QProxyStyle>
#include <QStyle>
#include <QStyleFactory>
#include <QStyleOption>
#include <QToolTip>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace sparkout {

namespace {

/// Fusion with visible outlines. Fusion's own are a shade of the window's colour: faint in a light
/// theme, invisible in a dark one.
class ThemeStyle : public QProxyStyle {
public:
    ThemeStyle();

    void drawPrimitive(PrimitiveElement element, const QStyleOption* option, QPainter* painter,
                       const QWidget* widget) const override;
    void drawControl(ControlElement element, const QStyleOption* option, QPainter* painter,
                     const QWidget* widget) const override;
    void drawComplexControl(ComplexControl control, const QStyleOptionComplex* option,
                            QPainter* painter, const QWidget* widget) const override;
    int pixelMetric(PixelMetric metric, const QStyleOption* option,
                    const QWidget* widget) const override;
    int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget,
                  QStyleHintReturn* answer) const override;
};

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

constexpr const char* appliedProperty = "sparkoutTheme";

QString code(const char* text) {
    return QString::fromLatin1(text);
}

/// Colours with which Fusion shades its frames and buttons.
void addShades(QPalette& palette, const ThemeColours& c) {
    const QColor button(c.button);
    const bool dark = isDark(palette);
    palette.setColor(QPalette::Light, dark ? button.lighter(150) : QColor(Qt::white));
    palette.setColor(QPalette::Midlight, button.lighter(dark ? 120 : 103));
    palette.setColor(QPalette::Mid, dark ? button.darker(130) : button.darker(125));
    palette.setColor(QPalette::Dark, dark ? button.darker(160) : button.darker(160));
    palette.setColor(QPalette::Shadow, dark ? QColor(Qt::black) : button.darker(220));
}

/// Whether the desktop is dark: Qt 6.4 shows it only in the initial palette.
bool systemIsDark() {
    QApplication::setPalette(QPalette()); // back to the desktop's
    return QGuiApplication::palette().color(QPalette::Window).lightness() < 128;
}

} // namespace

QString themeCode(Theme theme) {
    switch (theme) {
    case Theme::system: break;
    case Theme::light: return code("light");
    case Theme::dark: return code("dark");
    case Theme::contrast: return code("contrast");
    }
    return code("system");
}

Theme themeFrom(const QString& wanted) {
    for (const Theme theme : allThemes) {
        if (themeCode(theme) == wanted) {
            return theme;
        }
    }
    return Theme::system;
}

bool isThemeCode(const QString& wanted) {
    return themeCode(themeFrom(wanted)) == wanted;
}

QPalette paletteOf(Theme theme) {
    if (theme == Theme::system) {
        return paletteOf(systemIsDark() ? Theme::dark : Theme::light);
    }
    const ThemeColours& c = coloursOf(theme);
    QPalette palette;
    const auto set = [&palette](QPalette::ColorRole role, QRgb colour) {
        palette.setColor(role, QColor(colour)); // in every group
    };
    set(QPalette::Window, c.window);
    set(QPalette::Base, c.base);
    set(QPalette::AlternateBase, c.alternate);
    set(QPalette::Button, c.button);
    for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        set(role, c.text);
        palette.setColor(QPalette::Disabled, role, QColor(c.disabled));
    }
    set(QPalette::BrightText, c.text);
    set(QPalette::PlaceholderText, c.placeholder);
    set(QPalette::Highlight, c.highlight);
    set(QPalette::HighlightedText, c.highlighted);
    palette.setColor(QPalette::Disabled, QPalette::Highlight, QColor(c.disabled));
    palette.setColor(QPalette::Disabled, QPalette::HighlightedText, QColor(c.base));
    set(QPalette::ToolTipBase, c.tip);
    set(QPalette::ToolTipText, c.tipText);
    set(QPalette::Link, c.link);
    set(QPalette::LinkVisited, c.link);
    addShades(palette, c);
    return palette;
}

void applyTheme(Theme theme) {
    if (!dynamic_cast<const ThemeStyle*>(QApplication::style())) {
        QApplication::setStyle(new ThemeStyle);
    }
    const QPalette palette = paletteOf(theme);
    qApp->setProperty(appliedProperty, themeCode(theme));
    QApplication::setPalette(palette);
    QToolTip::setPalette(palette);
}

Theme appliedTheme() {
    return themeFrom(qApp->property(appliedProperty).toString());
}

QColor tone(Tone which, const QPalette& palette) {
    return QColor(coloursFor(palette).tones[std::size_t(which)]);
}

bool isDark(const QPalette& palette) {
    return palette.color(QPalette::Active, QPalette::Base).lightness() < 128;
}

namespace {

/// A tone in the light, the dark and the contrast theme.
struct ToneRow {
    Tone tone;
    std::array<QRgb, 3> colours;
};

constexpr ToneRow toneRows[] = {
    {Tone::error, {0xb31d1d, 0xff8f86, 0xffa39c}},
    {Tone::warning, {0x8a5a00, 0xe3b341, 0xffd84d}},
    {Tone::outline, {0x868d96, 0x87919d, 0xd8d8d8}},
    {Tone::blue, {0x0072b2, 0x56b4e9, 0x6cc8ff}},
    {Tone::sky, {0x56b4e9, 0x56b4e9, 0x6cc8ff}},
    {Tone::vermilion, {0xd55e00, 0xff7f3a, 0xff9457}},
    {Tone::orange, {0xb07900, 0xe69f00, 0xffb81a}},
    {Tone::green, {0x009e73, 0x2cc89b, 0x3de0b0}},
    {Tone::purple, {0xb4578c, 0xe39ac6, 0xf5acd8}},
    {Tone::yellow, {0xf0e442, 0xf0e442, 0xfff25c}},
    {Tone::ink, {0x3b4754, 0xc9d1d9, 0xffffff}},
    {Tone::paper, {0xffffff, 0x1b1f24, 0x000000}},
    {Tone::steel, {0xcfe0f2, 0x3f5b79, 0x2a4a6c}},
    {Tone::abrasive, {0xf3d9c2, 0x6d5340, 0x5c4330}},
    {Tone::grain, {0xc06a1e, 0xf0a35e, 0xffb36b}},
    {Tone::sand, {0xfbe6b4, 0x6f5d2c, 0x5f4e1a}},
    {Tone::accent, {0x2f6fb0, 0x6cb0f0, 0x8cd0ff}},
    {Tone::add, {0x3c8f4e, 0x5fc27e, 0x7ee89c}},
    {Tone::remove, {0xb31d1d, 0xff7b72, 0xff8f86}},
    {Tone::amber, {0xf2b632, 0xf2b632, 0xffd84d}},
    {Tone::amberInk, {0x4a3200, 0x4a3200, 0x000000}},
};

constexpr bool isWhole() {
    std::size_t next = 0;
    for (const ToneRow& row : toneRows) {
        if (row.tone != static_cast<Tone>(next++)) {
            return false;
        }
    }
    return next == static_cast<std::size_t>(Tone::count_);
}
static_assert(isWhole(), "a row for each tone, in the order of the enumeration");

constexpr auto column(std::size_t theme) {
    std::array<QRgb, std::size(toneRows)> colours{};
    for (std::size_t i = 0; i < colours.size(); ++i) {
        colours[i] = toneRows[i].colours[theme];
    }
    return colours;
}

constexpr ThemeColours table[] = {
    {.theme = Theme::light,
     .window = 0xf3f4f6,
     .base = 0xffffff,
     .alternate = 0xf7f8fa,
     .button = 0xeff0f2,
     .text = 0x000000,
     .placeholder = 0x626973,
     .disabled = 0x868c95,
     .highlight = 0x2f6fb0,
     .highlighted = 0xffffff,
     .tip = 0xffffe1,
     .tipText = 0x000000,
     .link = 0x1a5fa8,
     .tones = column(0)},
    {.theme = Theme::dark,
     .window = 0x252a30,
     .base = 0x1b1f24,
     .alternate = 0x20252a,
     .button = 0x30363d,
     .text = 0xe6e9ed,
     .placeholder = 0xa3adb9,
     .disabled = 0x838c97,
     .highlight = 0x3877bb,
     .highlighted = 0xffffff,
     .tip = 0x3d444d,
     .tipText = 0xf0f3f6,
     .link = 0x7db8f2,
     .tones = column(1)},
    {.theme = Theme::contrast,
     .window = 0x000000,
     .base = 0x000000,
     .alternate = 0x141414,
     .button = 0x1c1c1c,
     .text = 0xffffff,
     .placeholder = 0xd0d0d0,
     .disabled = 0x9a9a9a,
     .highlight = 0xffe14d,
     .highlighted = 0x000000,
     .tip = 0x000000,
     .tipText = 0xffffff,
     .link = 0x8cd0ff,
     .tones = column(2)},
};

} // namespace

const ThemeColours& coloursOf(Theme theme) {
    for (const ThemeColours& row : table) {
        if (row.theme == theme) {
            return row;
        }
    }
    return table[0];
}

const ThemeColours& coloursFor(const QPalette& palette) {
    const QColor base = palette.color(QPalette::Active, QPalette::Base);
    for (const ThemeColours& row : table) {
        if (base == QColor(row.base)) {
            return row;
        }
    }
    return coloursOf(base.lightness() < 128 ? Theme::dark : Theme::light);
}

namespace {

constexpr double hatchSpacing = 6; ///< distance of the lines along the axes
constexpr double hatchWidth = 1.2;
constexpr std::array hatchOrder{Hatch::none,    Hatch::rising,  Hatch::falling, Hatch::level,
                                Hatch::crossed, Hatch::upright, Hatch::squared};

/// Draws lines x + y = c or x − y = c, one through the origin, so that the hatching of adjacent
/// areas matches.
void paintSlanting(QPainter& painter, const QRectF& area, bool rising) {
    const double sign = rising ? 1 : -1; // y grows downwards
    const double low = std::min(area.top() * sign, area.bottom() * sign) + area.left();
    const double high = std::max(area.top() * sign, area.bottom() * sign) + area.right();
    for (double c = std::ceil(low / hatchSpacing) * hatchSpacing; c <= high; c += hatchSpacing) {
        const double atTop = c - sign * area.top(), atBottom = c - sign * area.bottom();
        const double from = std::max(area.left(), std::min(atTop, atBottom));
        const double to = std::min(area.right(), std::max(atTop, atBottom));
        if (from < to) {
            painter.drawLine(QLineF(from, sign * (c - from), to, sign * (c - to)));
        }
    }
}

void paintStraight(QPainter& painter, const QRectF& area, bool level) {
    const double low = level ? area.top() : area.left(),
                 high = low + (level ? area.height() : area.width());
    for (double at = std::ceil(low / hatchSpacing) * hatchSpacing; at < high; at += hatchSpacing) {
        painter.drawLine(level ? QLineF(area.left(), at, area.right(), at)
                               : QLineF(at, area.top(), at, area.bottom()));
    }
}

} // namespace

Hatch hatchAt(std::size_t index) {
    return hatchOrder[index % hatchOrder.size()];
}

void paintHatch(QPainter& painter, const QRectF& area, Hatch hatch, const QColor& line) {
    if (hatch == Hatch::none || area.isEmpty()) {
        return;
    }
    painter.save();
    painter.setPen(QPen(line, hatchWidth, Qt::SolidLine, Qt::FlatCap));
    if (hatch == Hatch::rising || hatch == Hatch::crossed) {
        paintSlanting(painter, area, true);
    }
    if (hatch == Hatch::falling || hatch == Hatch::crossed) {
        paintSlanting(painter, area, false);
    }
    if (hatch == Hatch::level || hatch == Hatch::squared) {
        paintStraight(painter, area, true);
    }
    if (hatch == Hatch::upright || hatch == Hatch::squared) {
        paintStraight(painter, area, false);
    }
    painter.restore();
}

} // namespace sparkout
