// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace sparkout {

/// How the part is held: between two centres, or overhanging from a chuck that clamps the end x =
/// 0.
enum class Mounting { centres, chuck };

} // namespace sparkout
