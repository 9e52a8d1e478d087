// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/limits/formula.h"

#include <QString>

#include <functional>
#include <vector>

namespace sparkout::report {

/// An expression as its parts, for typesetting; every part knows its value.
struct FormulaNode {
    enum class Kind {
        text,     ///< a symbol ("k_s"), a number or the name of a function
        sign,     ///< between its neighbours, with its spaces: " + ", "·", "−"
        row,      ///< the parts side by side
        fraction, ///< two parts, one above the other
        root,     ///< of the one part
        power,    ///< two parts: what is raised, and to what
        fenced,   ///< the one part in parentheses
    };
    Kind kind = Kind::text;
    QString text;
    int degree = 2; ///< of a root
    double value = 0;
    std::vector<FormulaNode> parts;
};

/// How a term of a formula is written, and the value it is written as.
struct FormulaLeaf {
    QString text;
    double value = 0;
};
using LeafWriter = std::function<FormulaLeaf(const FormulaTerm&)>;

/// The right side of a step; empty where it has none. The text is one of the engine's.
[[nodiscard]] std::vector<FormulaNode> rightSide(const FormulaStep& step, const LeafWriter& leaf);

/// A symbol or number by itself: "√a" is a root.
[[nodiscard]] FormulaNode leafNode(const QString& text, double value);

/// In one line: "2·h/(C + √(C² + 4·A·h))"; indices and powers as "k_s" and "x^(2/3)".
[[nodiscard]] QString inOneLine(const FormulaNode& node);

} // namespace sparkout::report
