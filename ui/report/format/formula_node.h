// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/surface/formula.h"

#include <QString>

#include <functional>
#include <vector>

namespace sparkout::report {

/// An expression as a tree for typesetting; every node knows its value.
struct FormulaNode {
    enum class Kind {
        text,     ///< a symbol ("k_s"), a number or the name of a function
        sign,     ///< between its neighbours, with its spaces: " + ", "·", "−"
        row,      ///< the parts side by side
        fraction, ///< two parts, one above the other
        root,     ///< root of its one part
        power,    ///< two parts: base and exponent
        fenced,   ///< the one part in parentheses
    };
    Kind kind = Kind::text;
    QString text;
    int degree = 2; ///< degree of a root
    double value = 0;
    std::vector<FormulaNode> parts;
};

/// The text of a formula's term, and its value as written.
struct FormulaLeaf {
    QString text;
    double value = 0;
};
using LeafWriter = std::function<FormulaLeaf(const FormulaTerm&)>;

/// The right side of a step; empty if it has none. The text must come from the engine.
[[nodiscard]] std::vector<FormulaNode> rightSide(const FormulaStep& step, const LeafWriter& leaf);

/// A single symbol or number: "√a" is a root.
[[nodiscard]] FormulaNode leafNode(const QString& text, double value);

/// On one line: "2·h/(C + √(C² + 4·A·h))"; indices and powers as "k_s" and "x^(2/3)".
[[nodiscard]] QString inOneLine(const FormulaNode& node);

} // namespace sparkout::report
