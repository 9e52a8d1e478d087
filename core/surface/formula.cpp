// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/formula.h"

#include <algorithm>
#include <string_view>

namespace sparkout {

namespace {

const FormulaTerm* findTerm(const FormulaStep& step, std::string_view symbol) {
    if (symbol == step.result.symbol) {
        return &step.result;
    }
    const auto found = std::find_if(step.terms.begin(), step.terms.end(),
                                    [&](const FormulaTerm& term) { return symbol == term.symbol; });
    return found == step.terms.end() ? nullptr : &*found;
}

std::string fill(const FormulaStep& step, std::string_view text, const TermWriter& writer) {
    std::string filled;
    while (!text.empty()) {
        const std::size_t open = text.find('{');
        const std::size_t close = text.find('}', open);
        if (open == std::string_view::npos || close == std::string_view::npos) {
            return filled.append(text);
        }
        const std::string_view symbol = text.substr(open + 1, close - open - 1);
        const FormulaTerm* term = findTerm(step, symbol);
        filled.append(text.substr(0, open));
        filled.append(term ? writer(*term) : std::string(symbol));
        text.remove_prefix(close + 1);
    }
    return filled;
}

} // namespace

std::string fillFormula(const FormulaStep& step, const TermWriter& writer) {
    return fill(step, step.text, writer);
}

std::string formulaInSymbols(const FormulaStep& step, const TermWriter& number) {
    return fill(step, step.text, [&](const FormulaTerm& term) {
        return isConstant(term) ? number(term) : std::string(term.symbol);
    });
}

std::string formulaInNumbers(const FormulaStep& step, const TermWriter& number) {
    const std::string_view text = step.text;
    const std::size_t equals = text.find(" = ");
    return fill(step, equals == std::string_view::npos ? text : text.substr(equals + 3), number);
}

} // namespace sparkout
