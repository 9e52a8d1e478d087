// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

/// Reports the value of a ValueSlider in its own unit to screen readers; call once.
void installSliderAccessibility();

} // namespace sparkout
