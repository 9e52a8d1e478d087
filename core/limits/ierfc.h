// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

/// ierfc(x) = ∫ₓ^∞ erfc(t) dt = e^(−x²)/√π − x·erfc(x), x ≥ 0, to 1e-15 of its value for every x
/// where it is a normal number (x < 26). 1/√π at 0, falling, log-concave.
[[nodiscard]] double ierfc(double x);

/// The x ≥ 0 with ierfc(x) = value; 0 for values from 1/√π up. value > 0.
[[nodiscard]] double inverseIerfc(double value);

} // namespace sparkout
