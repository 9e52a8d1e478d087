// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/kit/theme.h"

#include "ui/kit/theme_style.h"
#include "ui/kit/theme_table.h"

#include <QApplication>
#include <QStyle>
#include <QToolTip>

namespace sparkout {

namespace {

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
    if (!qobject_cast<const ThemeStyle*>(QApplication::style())) {
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

} // namespace sparkout
