// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

#include <QSet>

#include <vector>

namespace sparkout::report {

/// Significant digits of a result; what is put in carries as many as it takes to get them.
inline constexpr int resultDigits = 4;

/// Writes the engine's formulas as equations that are numbered on. What has been written once, with
/// the same numbers, is not written again.
class FormulaWriter {
public:
    [[nodiscard]] std::vector<Block> write(const FormulaSheet& sheet);

private:
    QSet<QString> m_written;
    int m_count = 0;
};

/// One step: symbols = numbers = result. The numbers, worked out as they are printed, give the
/// result as it is printed.
[[nodiscard]] Formula equation(const FormulaStep& step);

} // namespace sparkout::report
