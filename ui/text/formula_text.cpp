// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/formula_text.h"

#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <algorithm>
#include <cmath>

namespace sparkout {

namespace {

/// Units of formulas that are not those of an input.
[[maybe_unused]] constexpr const char* formulaUnits[] = {
    QT_TRANSLATE_NOOP("Unit", "N"),        QT_TRANSLATE_NOOP("Unit", "N/mm"),
    QT_TRANSLATE_NOOP("Unit", "N/mm^1.5"), QT_TRANSLATE_NOOP("Unit", "K·mm^1.25/N"),
    QT_TRANSLATE_NOOP("Unit", "mW"),       QT_TRANSLATE_NOOP("Unit", "mW/mm²"),
    QT_TRANSLATE_NOOP("Unit", "mm/s"),     QT_TRANSLATE_NOOP("Unit", "mm²"),
    QT_TRANSLATE_NOOP("Unit", "mm^0.25"),  QT_TRANSLATE_NOOP("Unit", "mm^0.5"),
    QT_TRANSLATE_NOOP("Unit", "mm^0.75"),  QT_TRANSLATE_NOOP("Unit", "mm^1.5"),
    QT_TRANSLATE_NOOP("Unit", "N/mm^0.5"),
};

/// Additional decimals of a length in mm, since a form error is the difference of two radii.
constexpr int moreDecimals = 1;

/// Replaces the minus of a number, but not of its exponent.
QString trueMinus(const QString& number) {
    return number.startsWith(u'-') ? u'−' + number.mid(1) : number;
}

QString digitsOf(const FormulaTerm& term, int digits, QLocale locale) {
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    const bool length = term.unit && QLatin1StringView(term.unit) == QLatin1StringView("mm");
    if (!length || std::abs(term.value) < 1) {
        return locale.toString(term.value, 'g', digits);
    }
    QString text = locale.toString(term.value, 'f', digits + moreDecimals);
    while (text.endsWith(u'0')) {
        text.chop(1);
    }
    return text.endsWith(locale.decimalPoint()) ? text.chopped(1) : text;
}

QString stepText(const FormulaStep& step) {
    const TermWriter write = [](const FormulaTerm& term) {
        return formulaNumber(term).toStdString();
    };
    const QString symbols = QString::fromStdString(formulaInSymbols(step, write));
    const QString numbers = QString::fromStdString(formulaInNumbers(step, write));
    QString result = formulaNumber(step.result);
    if (step.result.unit && *step.result.unit) {
        result += QChar::Nbsp + unitText(step.result.unit);
    }
    // A step without terms states a number: there are no numbers to insert.
    return step.terms.empty() ? symbols + QStringLiteral(" = ") + result
                              : QStringList{symbols, numbers, result}.join(QStringLiteral(" = "));
}

/// Name and source, then the steps.
QStringList paragraphs(const FormulaSheet& sheet) {
    QStringList paragraphs{formulaHead(sheet)};
    for (const FormulaStep& step : sheet.steps) {
        paragraphs << stepText(step);
    }
    return paragraphs;
}

} // namespace

QString formulaHead(const FormulaSheet& sheet) {
    const QString name = QCoreApplication::translate("Formula", sheet.name);
    const QString source = sourceText(sheet.source);
    return source.isEmpty() ? name : QStringLiteral("%1 (%2)").arg(name, source);
}

QString formulaNumber(const FormulaTerm& term, int digits) {
    return withPower(trueMinus(digitsOf(term, digits, QLocale())));
}

double shownValue(const FormulaTerm& term, int digits) {
    return digitsOf(term, digits, QLocale::c()).toDouble();
}

QString sourceCoefficients(const FormulaSheet& sheet, bool withAxialFeed) {
    const bool has = std::ranges::any_of(sheet.steps, [](const FormulaStep& step) {
        return QLatin1StringView(step.result.symbol) == QLatin1StringView("k_r");
    });
    const auto text = [](const char* english) {
        return QCoreApplication::translate("Formula", english);
    };
    return !has ? QString()
           : withAxialFeed
               ? text(QT_TRANSLATE_NOOP("Formula", "In the sources K_1 = b·k_s and K_2 = b·k_r "
                                                   "with axial feed, K_3 and K_4 in plunge."))
               : text(QT_TRANSLATE_NOOP("Formula", "In the sources K_3 = b·k_s and K_4 = b·k_r."));
}

QString formulaText(const FormulaSheet& sheet) {
    return paragraphs(sheet).join(u'\n');
}

} // namespace sparkout
