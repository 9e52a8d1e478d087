// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/kit/font_size.h"
#include "ui/kit/metrics.h"

#include <algorithm>

/// The metrics that the rows of all pages share, in addition to those of the window.
namespace sparkout {

constexpr int unitColumn = metrics::unit + metrics::margin;           ///< unit and spacing
constexpr int wideField = metrics::field + metrics::gap + unitColumn; ///< a field over both
constexpr int usualPanel = 347;  ///< width of all pages at the usual size of type
constexpr int leastPanel = 336;  ///< for smaller fonts: frames and gaps do not shrink
constexpr double noteType = 0.9; ///< shares, headings and hints, to the usual size

/// The width that a page of one column is laid out for.
inline int panelWidth() {
    return std::max(atFontSize(usualPanel), leastPanel);
}

} // namespace sparkout
