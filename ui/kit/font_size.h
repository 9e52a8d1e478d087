// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

class QFont;
class QWidget;

/// The font size of the whole program, in per cent of the system's, and the sizes that depend on
/// it.
namespace sparkout {

inline constexpr int usualFontSize = 100;
inline constexpr std::array fontSizes{90, usualFontSize, 115, 130};

[[nodiscard]] int fontSizeFrom(int percent); ///< the usual size for any other value

/// Sets the size of the whole program; may be called again.
void applyFontSize(int percent);
[[nodiscard]] int appliedFontSize();

/// A font scaled by a factor; a system may give its size in points or in pixels.
[[nodiscard]] QFont enlarged(QFont font, double times);

/// A width at the usual size, scaled to the current one.
[[nodiscard]] int atFontSize(int pixels);
void setTextWidth(QWidget& widget, int pixels); ///< fixed
void setTextMinimumWidth(QWidget& widget, int pixels);
void setTextMinimumHeight(QWidget& widget, int pixels);
/// Fixes the height to a number of lines of the program's font plus some pixels.
void setTextLines(QWidget& widget, int lines, int more);
/// Sets a font: a multiple of the program's size, optionally bold.
void setRelativeFont(QWidget& widget, double times, bool bold = false);

} // namespace sparkout
