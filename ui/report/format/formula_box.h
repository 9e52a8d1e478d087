// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/formula_node.h"

#include <functional>

class QPainter;

namespace sparkout::report {

/// A typeset expression relative to its base line [units of the page].
struct FormulaBox {
    double width = 0;
    double ascent = 0; ///< above the base line
    double descent = 0;
    std::function<void(QPainter&, double x, double base)> paint;
};

/// In a font of this size in points: fractions with a bar, roots with a roof, lowered indices.
[[nodiscard]] FormulaBox formulaBox(const FormulaNode& node, double points);

} // namespace sparkout::report
