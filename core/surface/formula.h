// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

/// Formulas with the numbers of one case. The computing function fills the sheet, so that the
/// displayed values are the computed ones. Texts name their quantities as {symbol}; window, report
/// and command line format numbers and units.
namespace sparkout {

/// A quantity of a formula: its symbol, its value and unit.
struct FormulaTerm {
    const char* symbol = "";
    double value = 0;
    const char* unit = "";
};

/// A number that is part of the formula: shown as a number even with symbols.
[[nodiscard]] constexpr FormulaTerm constantTerm(const char* name, double value) {
    return {name, value, nullptr};
}
[[nodiscard]] constexpr bool isConstant(const FormulaTerm& term) {
    return term.unit == nullptr;
}

/// One equation: "{L} = √({a}·{D_e})", the terms of its right side, and the result.
struct FormulaStep {
    const char* text = "";
    FormulaTerm result;
    std::vector<FormulaTerm> terms;
};

/// A formula with its numbers, step by step; the last step gives the result.
struct FormulaSheet {
    const char* name = "";   ///< translated in the context "Formula"
    const char* source = ""; ///< key of core/SOURCES.md
    std::vector<FormulaStep> steps;

    [[nodiscard]] const FormulaTerm& result() const { return steps.back().result; }
};

/// Writes an equation into the sheet, if there is one.
inline void state(FormulaSheet* sheet, const char* text, const FormulaTerm& result,
                  std::initializer_list<FormulaTerm> terms) {
    if (sheet) {
        sheet->steps.push_back({text, result, terms});
    }
}

/// Formats a term: its symbol, its number, or its number with the unit.
using TermWriter = std::function<std::string(const FormulaTerm&)>;

/// Replaces each {symbol} of a step's text by the writer's text for its term; a symbol without a
/// term is unchanged.
[[nodiscard]] std::string fillFormula(const FormulaStep& step, const TermWriter& writer);

/// The equation in symbols, with its constants formatted by `number`: "L = √(a·D_e)".
[[nodiscard]] std::string formulaInSymbols(const FormulaStep& step, const TermWriter& number);

/// The right side with numbers in place of all symbols: "√(0.005·28.57)".
[[nodiscard]] std::string formulaInNumbers(const FormulaStep& step, const TermWriter& number);

} // namespace sparkout
