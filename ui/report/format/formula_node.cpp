// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/formula_node.h"

#include "core/surface/burn.h"

#include <QStringList>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace sparkout::report {

namespace {

using NodeKind = FormulaNode::Kind;

FormulaNode makeNode(NodeKind kind, double value, std::vector<FormulaNode> parts) {
    FormulaNode made;
    made.kind = kind;
    made.value = value;
    made.parts = std::move(parts);
    return made;
}

FormulaNode textNode(NodeKind kind, const QString& text, double value = 0) {
    FormulaNode made;
    made.kind = kind;
    made.text = text;
    made.value = value;
    return made;
}

FormulaNode rootOf(FormulaNode inside, int degree, double value) {
    FormulaNode made = makeNode(NodeKind::root, value, {std::move(inside)});
    made.degree = degree;
    return made;
}

/// Adds parts to a row, or makes a row of a node.
FormulaNode joined(FormulaNode left, const QString& sign, FormulaNode right, double value) {
    if (left.kind != NodeKind::row) {
        left = makeNode(NodeKind::row, left.value, {std::move(left)});
    }
    left.parts.push_back(textNode(NodeKind::sign, sign));
    left.parts.push_back(std::move(right));
    left.value = value;
    return left;
}

FormulaNode unfenced(FormulaNode of) {
    if (of.kind != NodeKind::fenced) {
        return of;
    }
    FormulaNode inside = std::move(of.parts.front());
    return inside;
}

/// Whether it needs no brackets below an exponent.
bool isAtom(const FormulaNode& of) {
    return of.kind == NodeKind::fenced
           || (of.kind == NodeKind::text && !of.text.contains(u'·') && !of.text.startsWith(u'−'));
}

bool isSum(const FormulaNode& of) {
    return of.kind == NodeKind::row && std::ranges::any_of(of.parts, [](const FormulaNode& part) {
               return part.kind == NodeKind::sign && part.text.startsWith(u' ');
           });
}

/// Recursive descent parser for sums, products and powers, in the notation of the engine's texts.
class FormulaParser {
public:
    FormulaParser(const FormulaStep& step, const LeafWriter& leaf)
        : m_step(step), m_leaf(leaf), m_text(QString::fromUtf8(step.text)) {
        const qsizetype equals = m_text.indexOf(QStringLiteral(" = "));
        m_text = equals < 0 ? QString() : m_text.mid(equals + 3);
    }
    [[nodiscard]] bool any() const { return !m_text.isEmpty(); }
    FormulaNode read() { return sum(); }

private:
    bool take(const QString& token) {
        const bool here = m_text.startsWith(token);
        if (here) {
            m_text.remove(0, token.size());
        }
        return here;
    }

    FormulaNode sum() {
        FormulaNode result = product();
        while (true) {
            const bool plus = take(QStringLiteral(" + "));
            if (!plus && !take(QStringLiteral(" − "))) {
                return result;
            }
            FormulaNode next = product();
            const double value = result.value + (plus ? next.value : -next.value);
            if (!isSum(result)) {
                result = makeNode(NodeKind::row, result.value, {std::move(result)});
            }
            result = joined(std::move(result), plus ? QStringLiteral(" + ") : QStringLiteral(" − "),
                            std::move(next), value);
        }
    }

    FormulaNode product() {
        FormulaNode result = raised();
        while (true) {
            if (take(QStringLiteral("·"))) {
                FormulaNode next = raised();
                const double value = result.value * next.value;
                result = joined(std::move(result), QStringLiteral("·"), std::move(next), value);
            } else if (take(QStringLiteral("/"))) {
                FormulaNode below = raised();
                const double value = result.value / below.value;
                result = makeNode(NodeKind::fraction, value,
                                  {unfenced(std::move(result)), unfenced(std::move(below))});
            } else {
                return result;
            }
        }
    }

    FormulaNode raised() {
        if (take(QStringLiteral("−"))) {
            FormulaNode of = raised();
            const double value = -of.value;
            return makeNode(NodeKind::row, value,
                            {textNode(NodeKind::sign, QStringLiteral("−")), of});
        }
        FormulaNode base = primary();
        for (const auto& [sign, exponent] :
             {std::pair(u'²', 2), std::pair(u'³', 3), std::pair(u'⁴', 4)}) {
            if (take(QString(QChar(sign)))) {
                return power(std::move(base), QString::number(exponent), exponent);
            }
        }
        if (take(QStringLiteral("^("))) {
            const qsizetype end = m_text.indexOf(u')');
            const QString written = m_text.left(end);
            m_text.remove(0, end + 1);
            const QStringList ratio = written.split(u'/');
            return power(std::move(base), written,
                         ratio.first().toDouble() / (ratio.size() > 1 ? ratio[1].toDouble() : 1));
        }
        return base;
    }

    static FormulaNode power(FormulaNode base, const QString& written, double exponent) {
        const double value = std::pow(base.value, exponent);
        if (!isAtom(base)) {
            base = makeNode(NodeKind::fenced, base.value, {std::move(base)});
        }
        return makeNode(NodeKind::power, value,
                        {std::move(base), textNode(NodeKind::text, written)});
    }

    FormulaNode closed() {
        FormulaNode inside = sum();
        take(QStringLiteral(")"));
        return inside;
    }

    FormulaNode primary() {
        if (take(QStringLiteral("π"))) {
            return textNode(NodeKind::text, QStringLiteral("π"), std::numbers::pi);
        }
        if (take(QStringLiteral("√("))) {
            FormulaNode inside = closed();
            const double value = std::sqrt(inside.value);
            return rootOf(std::move(inside), 2, value);
        }
        if (take(QStringLiteral("∛("))) {
            FormulaNode inside = closed();
            const double value = std::cbrt(inside.value);
            return rootOf(std::move(inside), 3, value);
        }
        if (take(QStringLiteral("("))) {
            FormulaNode inside = closed();
            const double value = inside.value;
            return makeNode(NodeKind::fenced, value, {std::move(inside)});
        }
        if (take(QStringLiteral("{"))) {
            return quantity();
        }
        return m_text.front().isDigit() ? digits() : function();
    }

    FormulaNode function() {
        struct Function {
            const char16_t* name;
            double (*of)(double);
        };
        static constexpr Function functions[] = {
            {u"exp", [](double x) { return std::exp(x); }},
            {u"tg", [](double x) { return std::tan(x * std::numbers::pi / 180); }},
            {u"ierfc⁻¹", [](double y) { return inverseIerfc(y); }},
            {u"ierfc", [](double x) { return ierfc(x); }}};
        for (const Function& f : functions) {
            const QString name = QString::fromUtf16(f.name);
            if (take(name + u'(')) {
                FormulaNode inside = closed();
                const double value = f.of(inside.value);
                FormulaNode argument =
                    makeNode(NodeKind::fenced, inside.value, {std::move(inside)});
                return makeNode(NodeKind::row, value, {textNode(NodeKind::text, name), argument});
            }
        }
        Q_ASSERT_X(false, "rightSide", qPrintable(m_text));
        m_text.clear();
        return {};
    }

    FormulaNode digits() {
        qsizetype end = 0;
        while (end < m_text.size() && (m_text[end].isDigit() || m_text[end] == u'.')) {
            ++end;
        }
        const QString number = m_text.left(end);
        m_text.remove(0, end);
        return textNode(NodeKind::text, number, number.toDouble());
    }

    FormulaNode quantity() {
        const qsizetype end = m_text.indexOf(u'}');
        const std::string symbol = m_text.left(end).toStdString();
        m_text.remove(0, end + 1);
        const auto term = std::ranges::find_if(
            m_step.terms, [&](const FormulaTerm& t) { return symbol == t.symbol; });
        Q_ASSERT(term != m_step.terms.end());
        const FormulaLeaf leaf = m_leaf(*term);
        FormulaNode written = leafNode(leaf.text, leaf.value);
        return leaf.text.startsWith(u'−')
                   ? makeNode(NodeKind::fenced, leaf.value, {std::move(written)})
                   : written;
    }

    const FormulaStep& m_step;
    const LeafWriter& m_leaf;
    QString m_text;
};

/// Encloses an expression for use on one line as an index or exponent.
QString together(const FormulaNode& of) {
    const QString text = inOneLine(of);
    const bool atom = of.kind == NodeKind::text
                          ? isAtom(of)
                          : of.kind != NodeKind::row && of.kind != NodeKind::fraction;
    return atom ? text : QStringLiteral("(%1)").arg(text);
}

} // namespace

std::vector<FormulaNode> rightSide(const FormulaStep& step, const LeafWriter& leaf) {
    FormulaParser parser(step, leaf);
    return parser.any() ? std::vector{parser.read()} : std::vector<FormulaNode>();
}

FormulaNode leafNode(const QString& text, double value) {
    if (!text.startsWith(u'√')) {
        return textNode(NodeKind::text, text, value);
    }
    QString inside = text.mid(1);
    if (inside.startsWith(u'(') && inside.endsWith(u')')) {
        inside = inside.mid(1, inside.size() - 2);
    }
    return rootOf(textNode(NodeKind::text, inside, value * value), 2, value);
}

QString inOneLine(const FormulaNode& node) {
    switch (node.kind) {
    case NodeKind::text:
    case NodeKind::sign: return node.text;
    case NodeKind::row: {
        QString text;
        for (const FormulaNode& part : node.parts) {
            text += inOneLine(part);
        }
        return text;
    }
    case NodeKind::fraction: {
        const FormulaNode& above = node.parts.front();
        const QString top = isSum(above) ? together(above) : inOneLine(above);
        return top + u'/' + together(node.parts.back());
    }
    case NodeKind::root:
        return QString(node.degree == 3 ? u'∛' : u'√') + u'(' + inOneLine(node.parts.front())
               + u')';
    case NodeKind::power: {
        static const QString raised = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
        const QString exponent = node.parts.back().text;
        const bool digit = exponent.size() == 1 && exponent.front().isDigit();
        return together(node.parts.front())
               + (digit ? QString(raised[exponent.front().digitValue()])
                        : QStringLiteral("^(%1)").arg(exponent));
    }
    case NodeKind::fenced: return u'(' + inOneLine(node.parts.front()) + u')';
    }
    return {};
}

} // namespace sparkout::report
