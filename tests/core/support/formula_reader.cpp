// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/support/formula_reader.h"

#include "core/surface/burn.h"

#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <string_view>

namespace sparkout::fixtures {

namespace {

using sparkout::FormulaStep;
using sparkout::FormulaTerm;
using Dimension = std::array<double, 4>;

const std::map<std::string, Dimension>& dimensions() {
    static const std::map<std::string, Dimension> known{
        {"", {}},
        {"°", {}},
        {"mm", {1}},
        {"mm²", {2}},
        {"mm^1.5", {1.5}},
        {"mm^0.75", {0.75}},
        {"mm^0.5", {0.5}},
        {"mm^0.25", {0.25}},
        {"1/mm", {-1}},
        {"1/mm²", {-2}},
        {"mm²/s", {2, 0, -1}},
        {"mm/s", {1, 0, -1}},
        {"mm/min", {1, 0, -1}},
        {"rev/min", {0, 0, -1}},
        {"s", {0, 0, 1}},
        {"N", {0, 1}},
        {"N/mm", {-1, 1}},
        {"mm/N", {1, -1}},
        {"MPa", {-2, 1}},
        {"N/mm^0.5", {-0.5, 1}},
        {"N/mm^1.5", {-1.5, 1}},
        {"mW", {1, 1, -1}},
        {"mW/mm²", {-1, 1, -1}},
        {"mJ/mm³", {-2, 1}},
        {"K", {0, 0, 0, 1}},
        {"W/(m·K)", {0, 1, -1, -1}},
        {"K·mm^1.25/N", {1.25, -1, 0, 1}},
    };
    return known;
}

bool equal(const Dimension& a, const Dimension& b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (std::abs(a[i] - b[i]) > 1e-9) {
            return false;
        }
    }
    return true;
}

/// A few roundings: of the number itself and of the step that made it.
constexpr double rounding = 8 * std::numeric_limits<double>::epsilon();

Quantity exact(double value, const Dimension& dimension = {}) {
    return {value, dimension, rounding * std::abs(value)};
}

/// f at an argument without a unit, of which the slope there is known.
Quantity mapped(const Quantity& argument, double value, double slope) {
    return {value, {}, rounding * std::abs(value) + std::abs(slope) * argument.uncertainty};
}

Quantity power(const Quantity& base, double exponent) {
    Quantity result{std::pow(base.value, exponent), base.dimension};
    const double relative = base.value != 0 ? base.uncertainty / std::abs(base.value) : 0;
    result.uncertainty = (rounding + std::abs(exponent) * relative) * std::abs(result.value);
    for (double& d : result.dimension) {
        d *= exponent;
    }
    return result;
}

Quantity times(const Quantity& a, const Quantity& b) {
    Quantity result{a.value * b.value, a.dimension};
    result.uncertainty = rounding * std::abs(result.value) + std::abs(a.value) * b.uncertainty
                         + std::abs(b.value) * a.uncertainty;
    for (std::size_t i = 0; i < a.dimension.size(); ++i) {
        result.dimension[i] += b.dimension[i];
    }
    return result;
}

/// Recursive descent over sums, products and powers.
class Reader {
public:
    explicit Reader(const FormulaStep& step) : m_step(step), m_text(step.text) {}

    Quantity read() {
        expect("{" + std::string(m_step.result.symbol) + "} = ");
        const Quantity result = sum();
        if (!m_text.empty()) {
            fail("cannot read");
        }
        for (const FormulaTerm& term : m_step.terms) {
            if (!m_used.contains(term.symbol)) {
                fail(std::string("unused ") + term.symbol);
            }
        }
        const bool nothing = result.value == 0 && equal(result.dimension, {}); // "= 0" of any unit
        if (!nothing && !equal(result.dimension, dimensionOf(m_step.result.unit))) {
            fail("unit of the result");
        }
        return result;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw FormulaError(what + ": " + m_step.text + " at \"" + std::string(m_text) + "\"");
    }
    bool take(std::string_view token) {
        if (!m_text.starts_with(token)) {
            return false;
        }
        m_text.remove_prefix(token.size());
        return true;
    }
    void expect(std::string_view token) {
        if (!take(token)) {
            fail("expected " + std::string(token));
        }
    }

    Quantity sum() {
        Quantity result = product();
        while (true) {
            const double sign = take(" + ") ? 1 : take(" − ") ? -1 : 0;
            if (sign == 0) {
                return result;
            }
            const Quantity next = product();
            if (!equal(result.dimension, next.dimension)) {
                fail("units of a sum");
            }
            result.value += sign * next.value;
            result.uncertainty += next.uncertainty + rounding * std::abs(result.value);
        }
    }

    Quantity product() {
        Quantity result = raised();
        while (true) {
            if (take("·")) {
                result = times(result, raised());
            } else if (take("/")) {
                result = times(result, power(raised(), -1));
            } else {
                return result;
            }
        }
    }

    Quantity raised() {
        if (take("−")) {
            Quantity negative = raised();
            negative.value = -negative.value;
            return negative;
        }
        const Quantity base = primary();
        if (take("²")) {
            return power(base, 2);
        }
        if (take("³")) {
            return power(base, 3);
        }
        if (take("⁴")) {
            return power(base, 4);
        }
        if (take("^(")) {
            return power(base, closed().value);
        }
        return base;
    }

    Quantity closed() {
        const Quantity inside = sum();
        expect(")");
        return inside;
    }

    Quantity number() {
        const Quantity argument = closed();
        if (!equal(argument.dimension, {})) {
            fail("argument with a unit");
        }
        return argument;
    }

    Quantity primary() {
        if (take("π")) {
            return exact(std::numbers::pi);
        }
        if (take("√(")) {
            return power(closed(), 0.5);
        }
        if (take("∛(")) {
            const Quantity inside = closed();
            Quantity root = power(inside, 1.0 / 3);
            root.value = std::cbrt(inside.value);
            return root;
        }
        if (take("exp(")) {
            const Quantity x = number();
            return mapped(x, std::exp(x.value), std::exp(x.value));
        }
        if (take("ierfc⁻¹(")) {
            const Quantity y = number();
            const double x = sparkout::inverseIerfc(y.value);
            return mapped(y, x, 1 / std::erfc(x));
        }
        if (take("ierfc(")) {
            const Quantity x = number();
            return mapped(x, sparkout::ierfc(x.value), std::erfc(x.value));
        }
        if (take("tg(")) {
            Quantity x = number();
            x.value *= std::numbers::pi / 180;
            x.uncertainty *= std::numbers::pi / 180;
            const double t = std::tan(x.value);
            return mapped(x, t, 1 + t * t);
        }
        if (take("(")) {
            return closed();
        }
        return take("{") ? quantity() : digits();
    }

    Quantity digits() {
        double value = 0;
        const char* const begin = m_text.data();
        const auto read = std::from_chars(begin, begin + m_text.size(), value);
        m_text.remove_prefix(static_cast<std::size_t>(read.ptr - begin));
        return exact(value);
    }

    Quantity quantity() {
        const std::size_t end = m_text.find('}');
        const std::string symbol(m_text.substr(0, end));
        m_text.remove_prefix(end + 1);
        for (const FormulaTerm& term : m_step.terms) {
            if (symbol == term.symbol) {
                m_used.insert(symbol);
                return exact(term.value, isConstant(term) ? Dimension{} : dimensionOf(term.unit));
            }
        }
        fail("no term for " + symbol);
    }

    const FormulaStep& m_step;
    std::string_view m_text;
    std::set<std::string> m_used;
};

} // namespace

Dimension dimensionOf(const std::string& unit) {
    const auto found = dimensions().find(unit);
    if (found == dimensions().end()) {
        throw FormulaError("unknown unit " + unit);
    }
    return found->second;
}

Quantity workOut(const FormulaStep& step) {
    return Reader(step).read();
}

} // namespace sparkout::fixtures
