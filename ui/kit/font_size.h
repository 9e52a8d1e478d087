// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

class QFont;
class QWidget;

/// How large the type of the whole program is, in per cent of the system's, and
/// what follows it beyond the fonts themselves.
namespace sparkout {

inline constexpr int usualFontSize = 100;
inline constexpr std::array fontSizes{90, usualFontSize, 115, 130};

[[nodiscard]] int fontSizeFrom(int percent); ///< the usual one when it is none of them

/// Gives the whole program a size; may be called again at any time.
void applyFontSize(int percent);
[[nodiscard]] int appliedFontSize();

/// A font as large so many times; a system may give its size in points or in pixels.
[[nodiscard]] QFont enlarged(QFont font, double times);

/// What holds text and is this wide at the usual size.
[[nodiscard]] int atFontSize(int pixels);
void setTextWidth(QWidget& widget, int pixels); ///< fixed
void setTextMinimumWidth(QWidget& widget, int pixels);
void setTextMinimumHeight(QWidget& widget, int pixels);
/// A fixed height: lines of the program's type, and some pixels more.
void setTextLines(QWidget& widget, int lines, int more);
/// A font of its own: a multiple of the program's size, maybe bold.
void setRelativeFont(QWidget& widget, double times, bool bold = false);

} // namespace sparkout
