// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/formula_text.h"

#include "ui/text/source_names.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <cmath>

namespace sparkout {

namespace {

/// Units that formulas have and no input has.
[[maybe_unused]] constexpr const char* formulaUnits[] = {
    QT_TRANSLATE_NOOP("Unit", "N"),        QT_TRANSLATE_NOOP("Unit", "N/mm"),
    QT_TRANSLATE_NOOP("Unit", "N/mm^1.5"), QT_TRANSLATE_NOOP("Unit", "K·mm^1.25/N"),
    QT_TRANSLATE_NOOP("Unit", "mW"),       QT_TRANSLATE_NOOP("Unit", "mW/mm²"),
    QT_TRANSLATE_NOOP("Unit", "mm/s"),     QT_TRANSLATE_NOOP("Unit", "mm²"),
    QT_TRANSLATE_NOOP("Unit", "mm^0.25"),  QT_TRANSLATE_NOOP("Unit", "mm^0.5"),
    QT_TRANSLATE_NOOP("Unit", "mm^0.75"),  QT_TRANSLATE_NOOP("Unit", "mm^1.5"),
};

/// Decimals of a length in mm beyond its significant digits: a form error is the difference of two
/// radii.
constexpr int moreDecimals = 1;

/// "8.38·10⁻⁷" for "8.38e-07".
QString withPower(QString text) {
    const qsizetype e = text.indexOf(u'e', 0, Qt::CaseInsensitive);
    if (e < 0) {
        return text;
    }
    QString power;
    for (const QChar digit : QString::number(text.mid(e + 1).toInt())) {
        constexpr char16_t raised[] = u"⁰¹²³⁴⁵⁶⁷⁸⁹";
        power += digit == u'-' ? QChar(u'⁻') : QChar(raised[digit.digitValue()]);
    }
    return text.left(e) + QStringLiteral("·10") + power;
}

/// Of the number, not of its exponent.
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
    // A step without terms states a number: it has no numbers to put in.
    return step.terms.empty() ? symbols + QStringLiteral(" = ") + result
                              : QStringList{symbols, numbers, result}.join(QStringLiteral(" = "));
}

/// Name and source, then the steps.
QStringList paragraphs(const FormulaSheet& sheet) {
    QString head = QCoreApplication::translate("Formula", sheet.name);
    const QString source = sourceText(sheet.source);
    if (!source.isEmpty()) {
        head += QStringLiteral(" (%1)").arg(source);
    }
    QStringList paragraphs{head};
    for (const FormulaStep& step : sheet.steps) {
        paragraphs << stepText(step);
    }
    return paragraphs;
}

} // namespace

QString formulaNumber(const FormulaTerm& term, int digits) {
    return withPower(trueMinus(digitsOf(term, digits, QLocale())));
}

double shownValue(const FormulaTerm& term, int digits) {
    return digitsOf(term, digits, QLocale::c()).toDouble();
}

QString formulaText(const FormulaSheet& sheet) {
    return paragraphs(sheet).join(u'\n');
}

QString formulaMarkup(const FormulaSheet& sheet) {
    static const QRegularExpression power(QStringLiteral("\\^([0-9]+(?:[.,][0-9]+)?)"));
    QStringList texts;
    for (const QString& text : paragraphs(sheet)) {
        texts << withIndices(text).replace(power, QStringLiteral("<sup>\\1</sup>"));
    }
    texts.front() = QStringLiteral("<b>%1</b>").arg(texts.front());
    return QStringLiteral("<p>%1</p>").arg(texts.join(QStringLiteral("</p><p>")));
}

} // namespace sparkout
