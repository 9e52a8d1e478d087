// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

#include <QSet>

#include <optional>
#include <utility>
#include <vector>

namespace sparkout::report {

/// Significant digits of a result; what is put in carries as many as it takes to get them.
inline constexpr int resultDigits = 4;

/// What equations leave for their reader to find: their results, and the numbers of these symbols
/// where they are put in.
struct LeftOut {
    QSet<QString> symbols;
};
/// The symbols that equations of a sheet compute.
[[nodiscard]] QSet<QString> computedSymbols(const FormulaSheet& sheet);
/// A place to write a number.
[[nodiscard]] QString blankNumber();

/// Writes the engine's formulas as equations that are numbered on. What has been written once, with
/// the same numbers, is not written again.
class FormulaWriter {
public:
    explicit FormulaWriter(std::optional<LeftOut> leftOut = {}) : m_leftOut(std::move(leftOut)) {}

    [[nodiscard]] std::vector<Block> write(const FormulaSheet& sheet);

private:
    std::optional<LeftOut> m_leftOut;
    QSet<QString> m_written;
    int m_count = 0;
};

/// One step: symbols = numbers = result. The numbers, worked out as they are printed, give the
/// result as it is printed.
[[nodiscard]] Formula equation(const FormulaStep& step);
/// The same with places to write what is left out. What has no right side is given, and stands.
[[nodiscard]] Formula equation(const FormulaStep& step, const LeftOut& leftOut);

} // namespace sparkout::report
