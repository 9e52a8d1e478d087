// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/calculation.h"

#include "ui/text/number_text.h"

#include <boost/multiprecision/cpp_int.hpp>

#include <QByteArray>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>
#include <string>
#include <utility>

namespace sparkout {

namespace {

using boost::multiprecision::cpp_int;
using boost::multiprecision::cpp_rational;

constexpr qsizetype longestText = 400;
constexpr int largestExponent = 400;
/// More digits than the midpoint of two doubles can have: a fraction cut there is rounded
/// correctly.
constexpr int sureDigits = 800;

cpp_int powerOfTen(int exponent) {
    return boost::multiprecision::pow(cpp_int(10), static_cast<unsigned>(exponent));
}

int digitsOf(const cpp_int& value) {
    return static_cast<int>(double(boost::multiprecision::msb(value)) * std::log10(2.0)) + 1;
}

/// The double nearest to a fraction; empty beyond the largest and below the smallest.
std::optional<double> nearest(const cpp_rational& exact) {
    if (exact == 0) {
        return 0.0;
    }
    cpp_int over = abs(numerator(exact));
    cpp_int under = denominator(exact);
    const int shift = sureDigits - digitsOf(over) + digitsOf(under);
    (shift > 0 ? over : under) *= powerOfTen(std::abs(shift));
    cpp_int rest;
    cpp_int digits;
    divide_qr(over, under, digits, rest);
    const std::string text =
        digits.str() + (rest == 0 ? "0" : "1") + "e" + std::to_string(-shift - 1);
    double value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || !std::isfinite(value)) {
        return {};
    }
    return exact < 0 ? -value : value;
}

bool isDigit(QChar c) {
    return c >= u'0' && c <= u'9';
}

bool isExponentLetter(QChar c) {
    return c == u'e' || c == u'E' || c == u'\u0435' || c == u'\u0415'; // including Cyrillic
}

/// The ASCII form of an operator or bracket; null for any other character.
char signOf(QChar c) {
    switch (c.unicode()) {
    case u'+': return '+';
    case u'-':
    case u'\u2212':
    case u'\u2013': return '-';
    case u'*':
    case u'\u00d7':
    case u'\u00b7':
    case u'\u22c5': return '*';
    case u'/':
    case u'\u00f7': return '/';
    case u'(': return '(';
    case u')': return ')';
    default: return 0;
    }
}

/// Whether the text has operators besides the signs of a number and its exponent.
bool hasOperator(const QString& text) {
    for (qsizetype i = 0; i < text.size(); ++i) {
        const char sign = signOf(text[i]);
        const bool plusOrMinus = sign == '+' || sign == '-';
        const bool ofExponent =
            plusOrMinus && i > 1 && isExponentLetter(text[i - 1])
            && (isDigit(text[i - 2]) || text[i - 2] == u'.' || text[i - 2] == u',');
        if (sign != 0 && !(plusOrMinus && i == 0) && !ofExponent) {
            return true;
        }
    }
    return false;
}

} // namespace

/// Reads by recursive descent; the first fault ends it.
class Calculation::Reader {
public:
    explicit Reader(const QString& text) : m_text(text) {}

    Calculation read() {
        const cpp_rational exact = sum();
        if (m_fault.isEmpty() && sign() == ')') {
            fail(Calculation::tr("a closing bracket has no opening one"));
        } else if (m_fault.isEmpty() && m_at < m_text.size()) {
            fail(Calculation::tr("an operator is missing before “%1”").arg(m_text.mid(m_at)));
        }
        const std::optional<double> value = m_fault.isEmpty() ? nearest(exact) : std::nullopt;
        if (!value && m_fault.isEmpty()) {
            fail(Calculation::tr("the result is too large or too small"));
        }
        return {value, m_fault};
    }

private:
    void fail(const QString& fault) {
        if (m_fault.isEmpty()) {
            m_fault = fault;
        }
    }

    /// The next operator after any spaces.
    char sign() {
        while (m_at < m_text.size() && m_text[m_at].isSpace()) {
            ++m_at;
        }
        return m_at < m_text.size() ? signOf(m_text[m_at]) : char(0);
    }

    cpp_rational sum() {
        cpp_rational value = product();
        for (char next = sign(); m_fault.isEmpty() && (next == '+' || next == '-'); next = sign()) {
            ++m_at;
            const cpp_rational other = product();
            value = next == '+' ? cpp_rational(value + other) : cpp_rational(value - other);
        }
        return value;
    }

    cpp_rational product() {
        cpp_rational value = signedValue();
        for (char next = sign(); m_fault.isEmpty() && (next == '*' || next == '/'); next = sign()) {
            ++m_at;
            const cpp_rational other = signedValue();
            if (next == '*') {
                value *= other;
            } else if (other == 0) {
                fail(Calculation::tr("division by zero"));
            } else {
                value /= other;
            }
        }
        return value;
    }

    cpp_rational signedValue() {
        const char first = sign();
        if (first == '+' || first == '-') {
            ++m_at;
            const cpp_rational value = primary();
            return first == '-' ? cpp_rational(-value) : value;
        }
        return primary();
    }

    cpp_rational primary() {
        if (sign() == '(') {
            ++m_at;
            cpp_rational value = sum();
            if (m_fault.isEmpty() && sign() != ')') {
                m_at < m_text.size() ? fail(
                    Calculation::tr("an operator is missing before “%1”").arg(m_text.mid(m_at)))
                                     : fail(Calculation::tr("a bracket is not closed"));
            }
            ++m_at;
            return value;
        }
        return number();
    }

    cpp_rational number() {
        const qsizetype from = m_at;
        while (m_at < m_text.size() && !m_text[m_at].isSpace() && !endsNumber(from)) {
            ++m_at;
        }
        const QString text = m_text.mid(from, m_at - from);
        if (text.isEmpty()) {
            fail(m_at < m_text.size()
                     ? Calculation::tr("a number is missing before “%1”").arg(m_text.mid(m_at))
                     : Calculation::tr("a number is missing at the end"));
            return 0;
        }
        if (!parseNumber(text)) {
            fail(Calculation::tr("“%1” is not a number").arg(text));
            return 0;
        }
        return exactly(text);
    }

    /// Whether the next character does not belong to the number that begins at `from`.
    [[nodiscard]] bool endsNumber(qsizetype from) const {
        const char sign = signOf(m_text[m_at]);
        const bool ofExponent =
            (sign == '+' || sign == '-') && m_at > from + 1 && isExponentLetter(m_text[m_at - 1]);
        return sign != 0 && !ofExponent;
    }

    /// A text that parseNumber() reads, without rounding.
    cpp_rational exactly(const QString& text) {
        std::string digits;
        int exponent = 0;
        bool behindPoint = false;
        bool isShort = true; // the exponent
        for (qsizetype i = 0; i < text.size(); ++i) {
            if (isExponentLetter(text[i])) {
                const int written = text.mid(i + 1)
                                        .replace(u'\u2212', u'-')
                                        .replace(u'\u2013', u'-')
                                        .toInt(&isShort);
                isShort = isShort && std::abs(long{written}) <= 2 * largestExponent;
                exponent += isShort ? written : 0;
                break;
            }
            if (isDigit(text[i])) {
                digits += char(text[i].unicode());
                exponent -= behindPoint ? 1 : 0;
            } else {
                behindPoint = true;
            }
        }
        if (digits.find_first_not_of('0') == std::string::npos) {
            return 0; // for any exponent
        }
        if (!isShort || std::abs(exponent) > 2 * largestExponent) {
            fail(Calculation::tr("“%1” is not a number").arg(text));
            return 0;
        }
        digits.erase(0, std::min(digits.find_first_not_of('0'), digits.size() - 1)); // 012 is octal
        const cpp_rational whole{cpp_int(digits)};
        const cpp_rational power{powerOfTen(std::abs(exponent))};
        return exponent < 0 ? cpp_rational(whole / power) : cpp_rational(whole * power);
    }

    QString m_text;
    qsizetype m_at = 0;
    QString m_fault;
};

std::optional<Calculation> Calculation::of(const QString& text) {
    const QString trimmed = text.trimmed();
    if (trimmed.size() > longestText || !hasOperator(trimmed)) {
        return std::nullopt;
    }
    return Reader(trimmed).read();
}

} // namespace sparkout
