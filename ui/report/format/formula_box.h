// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/formula_node.h"

#include <functional>

class QPainter;

namespace sparkout::report {

/// An expression laid out about its base line [units of the page].
struct FormulaBox {
    double width = 0;
    double ascent = 0; ///< above the base line
    double descent = 0;
    std::function<void(QPainter&, double x, double base)> paint;
};

/// With a font so many points high: fractions with a bar, roots with a roof, indices below.
[[nodiscard]] FormulaBox formulaBox(const FormulaNode& node, double points);

} // namespace sparkout::report
