// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/formula_writer.h"

#include "ui/text/formula_text.h"
#include "ui/text/texts.h"

#include <QRegularExpression>

#include <cmath>

namespace sparkout::report {

namespace {

constexpr int mostDigits = 13;
constexpr int leastResultDigits = 2;
constexpr double noLength_mm = 5e-10; ///< less than that is rounding of radii

/// Removes the rounding errors of a difference of radii.
FormulaTerm settled(FormulaTerm term) {
    const bool length = term.unit && QLatin1StringView(term.unit) == QLatin1StringView("mm");
    if (length && std::abs(term.value) < noLength_mm) {
        term.value = 0;
    }
    return term;
}

QString printed(const FormulaTerm& term, int digits) {
    return formulaNumber(term, digits).replace(u'-', QChar(0x2212));
}

LeafWriter numbersWith(int digits) {
    return [digits](const FormulaTerm& term) {
        const FormulaTerm shown = settled(term);
        return FormulaLeaf{printed(shown, digits), shownValue(shown, digits)};
    };
}

FormulaLeaf symbolLeaf(const FormulaTerm& term) {
    return {isConstant(term) ? printed(term, sheetDigits) : QString::fromUtf8(term.symbol),
            term.value};
}

/// The digits of the inserted numbers that reproduce the result, and those of the result.
struct NeededDigits {
    int putIn, result;
};

/// The least number of digits that reproduces the result; the result loses digits only where its
/// terms cancel.
NeededDigits neededDigits(const FormulaStep& step) {
    const FormulaTerm result = settled(step.result);
    for (int shown = resultDigits; shown >= leastResultDigits; --shown) {
        for (int digits = sheetDigits; digits <= mostDigits; ++digits) {
            const std::vector<FormulaNode> side = rightSide(step, numbersWith(digits));
            FormulaTerm found = result;
            found.value = side.empty() ? result.value : side.front().value;
            if (printed(settled(found), shown) == printed(result, shown)) {
                return {digits, shown};
            }
        }
    }
    return {mostDigits, leastResultDigits};
}

FormulaNode words(const QString& text) {
    return {FormulaNode::Kind::text, text, 2, 0, {}};
}

/// The number of a term and its unit, with raised powers.
FormulaNode quantityNode(const QString& number, const FormulaTerm& term) {
    static const QRegularExpression power(QStringLiteral("(\\p{L}+)\\^([0-9]+(?:[.,][0-9]+)?)"));
    FormulaNode node{FormulaNode::Kind::row, {}, 2, term.value, {words(number)}};
    if (!term.unit || !*term.unit) {
        return node;
    }
    const QString unit = QChar::Nbsp + unitText(term.unit);
    qsizetype from = 0;
    for (auto it = power.globalMatch(unit); it.hasNext();) {
        const auto match = it.next();
        node.parts.push_back(words(unit.mid(from, match.capturedStart() - from)));
        node.parts.push_back({FormulaNode::Kind::power,
                              {},
                              2,
                              0,
                              {words(match.captured(1)), words(match.captured(2))}});
        from = match.capturedEnd();
    }
    node.parts.push_back(words(unit.mid(from)));
    return node;
}

} // namespace

Formula equation(const FormulaStep& step) {
    const FormulaTerm result = settled(step.result);
    const NeededDigits digits = neededDigits(step);
    std::vector<FormulaNode> numbers = rightSide(step, numbersWith(digits.putIn));
    Formula formula;
    formula.sides = rightSide(step, symbolLeaf);
    if (!numbers.empty() && inOneLine(numbers.front()) != inOneLine(formula.sides.front())) {
        formula.sides.push_back(std::move(numbers.front()));
    }
    formula.sides.insert(formula.sides.begin(),
                         leafNode(QString::fromUtf8(result.symbol), result.value));
    const QString text = printed(result, digits.result);
    if (inOneLine(formula.sides.back()) == text) {
        formula.sides.pop_back(); // it states a number
    }
    formula.sides.push_back(quantityNode(text, result));
    return formula;
}

QString blankNumber() {
    return QStringLiteral("______");
}

QSet<QString> computedSymbols(const FormulaSheet& sheet) {
    QSet<QString> symbols;
    for (const FormulaStep& step : sheet.steps) {
        if (!rightSide(step, symbolLeaf).empty()) {
            symbols.insert(QString::fromUtf8(step.result.symbol));
        }
    }
    return symbols;
}

Formula equation(const FormulaStep& step, const LeftOut& leftOut) {
    Formula formula;
    formula.sides = rightSide(step, symbolLeaf);
    if (formula.sides.empty() && !leftOut.symbols.contains(QString::fromUtf8(step.result.symbol))) {
        return equation(step);
    }
    const int digits = neededDigits(step).putIn;
    const LeafWriter leaf = [&](const FormulaTerm& term) {
        const bool isOut =
            !isConstant(term) && leftOut.symbols.contains(QString::fromUtf8(term.symbol));
        return isOut ? FormulaLeaf{blankNumber(), 1} : numbersWith(digits)(term);
    };
    for (FormulaNode& side : rightSide(step, leaf)) {
        formula.sides.push_back(std::move(side));
    }
    formula.sides.insert(formula.sides.begin(), leafNode(QString::fromUtf8(step.result.symbol), 0));
    formula.sides.push_back(quantityNode(blankNumber(), step.result));
    return formula;
}

std::vector<Block> FormulaWriter::write(const FormulaSheet& sheet) {
    std::vector<Block> blocks;
    for (const FormulaStep& step : sheet.steps) {
        const Formula numbered = equation(step);
        QString key; // of the numbers, so that question and key have the same equations
        for (const FormulaNode& side : numbered.sides) {
            key += inOneLine(side) + u'=';
        }
        if (m_written.contains(key)) {
            continue;
        }
        m_written.insert(key);
        Formula formula = m_leftOut ? equation(step, *m_leftOut) : numbered;
        formula.label = QStringLiteral("(%1)").arg(++m_count);
        blocks.emplace_back(std::move(formula));
    }
    return blocks;
}

namespace {

using MarkupKind = FormulaNode::Kind;

QString element(const char* name, const QString& inside) {
    const QString tag = QString::fromLatin1(name);
    return u'<' + tag + u'>' + inside + QStringLiteral("</") + tag + u'>';
}

/// A symbol, a number or words.
QString word(const QString& text) {
    const bool number = !text.isEmpty() && text.front().isDigit();
    return element(number ? "mn" : "mi", text.toHtmlEscaped());
}

QString withIndex(const QString& text) {
    static const QRegularExpression index(QStringLiteral("([^_]*)_(\\w+)"),
                                          QRegularExpression::UseUnicodePropertiesOption);
    QString markup;
    qsizetype from = 0;
    for (auto it = index.globalMatch(text); it.hasNext();) {
        const auto match = it.next();
        markup += element("msub", word(match.captured(1)) + word(match.captured(2)));
        from = match.capturedEnd();
    }
    if (from < text.size()) {
        markup += word(text.mid(from));
    }
    return markup;
}

QString markupOf(const FormulaNode& node) {
    QString inside;
    if (node.kind != MarkupKind::text && node.kind != MarkupKind::sign) {
        for (const FormulaNode& part : node.parts) {
            inside +=
                node.kind == MarkupKind::row ? markupOf(part) : element("mrow", markupOf(part));
        }
    }
    switch (node.kind) {
    case MarkupKind::text: return withIndex(node.text);
    case MarkupKind::sign: return element("mo", node.text.trimmed());
    case MarkupKind::row: return inside;
    case MarkupKind::fraction: return element("mfrac", inside);
    case MarkupKind::root:
        return node.degree == 2
                   ? element("msqrt", inside)
                   : element("mroot", inside + element("mn", QString::number(node.degree)));
    case MarkupKind::power: return element("msup", inside);
    case MarkupKind::fenced:
        return element("mo", QStringLiteral("(")) + inside + element("mo", QStringLiteral(")"));
    }
    return {};
}

} // namespace

QString mathMarkup(const Formula& formula) {
    QStringList sides;
    for (const FormulaNode& side : formula.sides) {
        sides << element("mrow", markupOf(side));
    }
    return QStringLiteral("<math xmlns=\"http://www.w3.org/1998/Math/MathML\" "
                          "display=\"block\">")
           + sides.join(element("mo", QStringLiteral("="))) + QStringLiteral("</math>");
}

QString inOneLine(const Formula& formula) {
    QStringList sides;
    for (const FormulaNode& side : formula.sides) {
        sides << inOneLine(side);
    }
    return sides.join(QStringLiteral(" = "));
}

} // namespace sparkout::report
