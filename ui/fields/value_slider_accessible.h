// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

/// Tells screen readers the value of a ValueSlider in its own unit, once for the program.
void installSliderAccessibility();

} // namespace sparkout
