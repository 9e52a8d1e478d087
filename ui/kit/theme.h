// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

#include <array>
#include <cstddef>

class QColor;
class QPainter;
class QRectF;

/// The looks of the window: themes, each one row of a table. All painting takes its colours from
/// here, by the palette.
namespace sparkout {

enum class Theme { system, light, dark, contrast };

inline constexpr std::array allThemes{Theme::system, Theme::light, Theme::dark, Theme::contrast};

[[nodiscard]] QString themeCode(Theme theme);       ///< "system", "light", …: for settings
[[nodiscard]] Theme themeFrom(const QString& code); ///< system for any other code
[[nodiscard]] bool isThemeCode(const QString& code);
[[nodiscard]] QPalette paletteOf(Theme theme); ///< for the system theme: the light or dark one

/// Sets the theme of the whole program; may be called again. appliedTheme() returns it.
void applyTheme(Theme theme);
[[nodiscard]] Theme appliedTheme();

/// The purpose of a colour, in addition to the roles of QPalette.
enum class Tone {
    error,   ///< a refused value: text and frame
    warning, ///< an unusual value: text and frame
    outline, ///< fields, buttons and boxes
    // Curves and lights, Okabe and Ito's set, distinguishable by colour-blind readers.
    blue,
    sky,
    vermilion,
    orange,
    green,
    purple,
    yellow,
    // Icons.
    ink,      ///< outlines
    paper,    ///< white surfaces
    steel,    ///< the workpiece, things of metal
    abrasive, ///< the wheel
    grain,    ///< grains of the wheel, pointers
    sand,     ///< folders
    accent,   ///< arrows, curves
    add,
    remove,
    amber,
    amberInk, ///< warning sign and texts on amber
    count_
};

/// A colour of the theme to which a palette belongs, or which is nearest to it.
[[nodiscard]] QColor tone(Tone which, const QPalette& palette);
[[nodiscard]] bool isDark(const QPalette& palette);

/// Colours drawn over a colour map, which is the same in every theme.
namespace onMap {
inline constexpr QColor dark(0, 0, 0), light(255, 255, 255), accent(0xff, 0x9d, 0x5c);
}

/// One theme: a colour for each role of the palette and each tone.
struct ThemeColours {
    Theme theme;
    QRgb window, base, alternate, button, text, placeholder, disabled;
    QRgb highlight, highlighted, tip, tipText, link;
    std::array<QRgb, std::size_t(Tone::count_)> tones;
};

[[nodiscard]] const ThemeColours& coloursOf(Theme theme); ///< not for the system theme
/// The theme from which a palette was made; for other palettes, one with a similar background.
[[nodiscard]] const ThemeColours& coloursFor(const QPalette& palette);

/// A hatching that distinguishes coloured areas without colour.
enum class Hatch { none, rising, falling, level, crossed, upright, squared };

/// The hatching of one of several adjacent areas, by index: the first has none; they repeat.
[[nodiscard]] Hatch hatchAt(std::size_t index);

/// Draws single lines instead of a brush pattern, which would have another size on paper and not be
/// vectors in SVG.
void paintHatch(QPainter& painter, const QRectF& area, Hatch hatch, const QColor& line);

} // namespace sparkout
