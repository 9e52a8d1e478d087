// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QPalette>
#include <QString>

#include <array>

/// How the window looks: themes, each one row of a table. Everything painted takes its colours from
/// here, by the palette it is painted on.
namespace sparkout {

enum class Theme { system, light, dark, contrast };

inline constexpr std::array allThemes{Theme::system, Theme::light, Theme::dark, Theme::contrast};

[[nodiscard]] QString themeCode(Theme theme);       ///< "system", "light", …: for settings
[[nodiscard]] Theme themeFrom(const QString& code); ///< system when it is none of them
[[nodiscard]] bool isThemeCode(const QString& code);
[[nodiscard]] QPalette paletteOf(Theme theme); ///< of the system's, light or dark

/// Gives the whole program a theme; may be called again at any time. The present one is shown by
/// appliedTheme().
void applyTheme(Theme theme);
[[nodiscard]] Theme appliedTheme();

/// What a colour is for, beside the roles of QPalette.
enum class Tone {
    error,   ///< a refused value: text and frame
    warning, ///< an unusual value: text and frame
    outline, ///< of fields, buttons and boxes
    // Curves and lights, Okabe and Ito's set: told apart by colour-blind readers too.
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
    grain,    ///< on the wheel, pointers
    sand,     ///< folders
    accent,   ///< arrows, curves
    add,
    remove,
    amber,
    amberInk, ///< the warning sign and what stands on it
    count_
};

/// A colour of the theme a palette belongs to, or comes closest to.
[[nodiscard]] QColor tone(Tone which, const QPalette& palette);
[[nodiscard]] bool isDark(const QPalette& palette);

/// What is drawn over a map of colours, which is the same in every theme.
namespace onMap {
inline constexpr QColor dark(0, 0, 0), light(255, 255, 255), accent(0xff, 0x9d, 0x5c);
}

} // namespace sparkout
