// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/views/sweep/sweep_shown.h"

namespace sparkout {

/// A sweep over two inputs: a coloured cell for each point, the worst of several zones; with lines
/// where the quantity meets its limit and around the cells in which every requirement is met.
class SweepMap {
    Q_DECLARE_TR_FUNCTIONS(SweepMap)
public:
    static LineChart chart(const SweepShown& shown);

private:
    static void addContours(LineChart& chart, const SweepShown& shown);
    static void addMarks(LineChart& chart, const SweepShown& shown);
};

} // namespace sparkout
