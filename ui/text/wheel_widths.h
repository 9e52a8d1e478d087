// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/issue.h"

#include <QCoreApplication>
#include <QString>

namespace sparkout {

/// Wheels for a ground length that can be neither plunged nor traversed with the one there is.
class WheelWidths {
    Q_DECLARE_TR_FUNCTIONS(WheelWidths)
public:
    /// Widths of the shipped catalogue that would be valid, after a refusal of length or width;
    /// empty for other issues. To traverse a length L a wheel B with overruns of B/3 needs 4/3·B <
    /// L, a plunge B ≥ L.
    [[nodiscard]] static QString hint(const Issue& issue);
};

} // namespace sparkout
