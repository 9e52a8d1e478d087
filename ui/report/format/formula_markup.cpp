// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/format/formula_markup.h"

#include <QRegularExpression>

namespace sparkout::report {

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
