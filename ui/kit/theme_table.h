// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/theme.h"

namespace sparkout {

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

} // namespace sparkout
