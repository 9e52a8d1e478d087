// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace sparkout {
struct Part;
} // namespace sparkout

namespace sparkout::report {

/// A diameter as on a drawing: ⌀30h6 and its deviations in millimetres, one above the other at half
/// height. A deviation of 0 is not written.
struct DrawnDimension {
    QString nominal; ///< "⌀30h6"
    QString upper, lower;
    bool isSymmetric = false; ///< "±0.008", in full height, for both

    [[nodiscard]] static DrawnDimension of(const Part& part);
};

} // namespace sparkout::report
