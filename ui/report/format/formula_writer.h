// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

#include <QSet>

#include <optional>
#include <utility>
#include <vector>

namespace sparkout::report {

/// Significant digits of a result; the inserted numbers have as many as needed.
inline constexpr int resultDigits = 4;

/// The parts of equations left out for the reader: their results, and the numbers of these symbols.
struct LeftOut {
    QSet<QString> symbols;
};
/// The symbols that equations of a sheet compute.
[[nodiscard]] QSet<QString> computedSymbols(const FormulaSheet& sheet);
/// A place to write a number.
[[nodiscard]] QString blankNumber();

/// Writes the engine's formulas as numbered equations. A formula with the same numbers is written
/// only once.
class FormulaWriter {
public:
    explicit FormulaWriter(std::optional<LeftOut> leftOut = {}) : m_leftOut(std::move(leftOut)) {}

    [[nodiscard]] std::vector<Block> write(const FormulaSheet& sheet);

private:
    std::optional<LeftOut> m_leftOut;
    QSet<QString> m_written;
    int m_count = 0;
};

/// One step: symbols = numbers = result. The printed numbers reproduce the printed result.
[[nodiscard]] Formula equation(const FormulaStep& step);
/// An equation with places to write what is left out. A given value without a right side is written
/// in full.
[[nodiscard]] Formula equation(const FormulaStep& step, const LeftOut& leftOut);

/// An equation as MathML, which browsers typeset and read aloud.
[[nodiscard]] QString mathMarkup(const Formula& formula);

/// On one line: "a = 2·h/C = 2·3/4 = 1.5 mm"; only indices and powers are marked up.
[[nodiscard]] QString inOneLine(const Formula& formula);

} // namespace sparkout::report
