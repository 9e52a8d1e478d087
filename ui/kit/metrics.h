// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

/// The window's one scale of distances, icon sizes and fonts, so that all layouts match.
namespace sparkout::metrics {

// Distances, in device-independent pixels.
constexpr int hair = 2;   ///< between parts of one control
constexpr int row = 3;    ///< between the rows of a form
constexpr int tight = 4;  ///< between controls of one bar
constexpr int gap = 6;    ///< between related controls
constexpr int margin = 8; ///< around a page or a box, and between groups
constexpr int wide = 16;  ///< between unrelated controls

// Icons, in device-independent pixels.
constexpr int iconSmall = 13; ///< within a line of text
constexpr int icon = 22;      ///< tool bars, page buttons
constexpr int iconLarge = 28; ///< lists of things to choose from
constexpr int iconProgram = 64;

// Widths of the controls of the forms, in device-independent pixels.
constexpr int field = 104;     ///< a number
constexpr int fieldWide = 176; ///< a choice or a text
constexpr int unit = 52;       ///< the unit after a number

// Font sizes, as multiples of the usual size.
constexpr double headline = 1.6; ///< the one number of a panel

} // namespace sparkout::metrics
