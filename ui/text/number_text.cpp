// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/number_text.h"

#include "core/units.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QRegularExpression>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdlib>

namespace sparkout {

namespace {

constexpr qsizetype longest = 400; // digits of the smallest double, with a margin
constexpr double smallestPlain = 1e-7;
constexpr double largestPlain = 1e15;

constexpr QStringView raised = u"⁰¹²³⁴⁵⁶⁷⁸⁹";

/// "1.5e-8" for "1.5·10⁻⁸", "1e-15" for "10⁻¹⁵"; any other text stays.
QString withExponent(const QString& text) {
    static const QRegularExpression pattern(
        QStringLiteral("^([+\\-−–]?)(?:([\\d.,]+)\\s*[·×*]\\s*)?10([⁺⁻]?)([⁰¹²³⁴⁵⁶⁷⁸⁹]+)$"));
    const QRegularExpressionMatch found = pattern.match(text);
    if (!found.hasMatch()) {
        return text;
    }
    QString exponent = found.captured(3) == u"⁻" ? QStringLiteral("-") : QString();
    for (const QChar digit : found.captured(4)) {
        exponent += QString::number(raised.indexOf(digit));
    }
    const QString mantissa = found.captured(2).isEmpty() ? QStringLiteral("1") : found.captured(2);
    return found.captured(1) + mantissa + u'e' + exponent;
}

QString signOf(double value) {
    return value < 0 ? QStringLiteral("−") : QString();
}

/// The text in the characters read by from_chars; empty if it has others.
QByteArray plain(const QString& text) {
    const QString trimmed = withExponent(text.trimmed());
    if (trimmed.size() > longest) {
        return {};
    }
    QByteArray out;
    for (const QChar c : trimmed) {
        switch (c.unicode()) {
        case u',':
        case u'.': out += '.'; break;
        case u'-':
        case u'\u2212':
        case u'\u2013': out += '-'; break;
        case u'e':
        case u'E':
        case u'\u0435': // Cyrillic letters that look the same
        case u'\u0415': out += 'e'; break;
        case u'+': out += '+'; break;
        default:
            if (c < u'0' || c > u'9') {
                return {};
            }
            out += char(c.unicode());
        }
    }
    return out;
}

} // namespace

std::optional<double> parseNumber(const QString& text) {
    QByteArray digits = plain(text);
    if (digits.startsWith('+')) {
        digits.remove(0, 1);
        if (digits.startsWith('-')) {
            return {};
        }
    }
    double value = 0;
    const char* const end = digits.constData() + digits.size();
    const auto [stop, error] = std::from_chars(digits.constData(), end, value);
    if (error != std::errc{} || stop != end || !std::isfinite(value)) {
        return {};
    }
    return value;
}

QString showNumber(double value, const QLocale& locale) {
    const double size = std::abs(value);
    const bool plain = value == 0 || (size >= smallestPlain && size < largestPlain);
    char buffer[64];
    const auto [end, error] =
        plain ? std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed)
              : std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific);
    QString text = QString::fromLatin1(buffer, end - buffer);
    static const QRegularExpression padding(QStringLiteral("e\\+?(-?)0*(\\d)"));
    return text.replace(padding, QStringLiteral("e\\1\\2")).replace(u'.', locale.decimalPoint());
}

QString withPower(const QString& number) {
    const qsizetype e = number.indexOf(u'e', 0, Qt::CaseInsensitive);
    if (e < 0) {
        return number;
    }
    QString power;
    for (const QChar digit : QString::number(number.mid(e + 1).toInt())) {
        power += digit == u'-' ? QChar(u'⁻') : raised[digit.digitValue()];
    }
    const QString mantissa = number.left(e);
    const QString sign = mantissa.chopped(std::min<qsizetype>(1, mantissa.size()));
    const bool isOne = mantissa.endsWith(u'1') && (sign.isEmpty() || sign == u"-" || sign == u"−");
    return (isOne ? sign : mantissa + u'·') + QStringLiteral("10") + power;
}

QString printedNumber(double value) {
    return signOf(value) + withPower(showNumber(std::abs(value), QLocale()));
}

QString printedNumber(double value, int digits) {
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    return signOf(value) + withPower(locale.toString(std::abs(value), 'g', digits));
}

QString stepNumber(const QString& text, int steps, bool zeroAllowed) {
    if (!parseNumber(text)) {
        return text;
    }
    QString mantissa = text.trimmed();
    const qsizetype e = mantissa.indexOf(QRegularExpression(QStringLiteral("[eE\u0435\u0415]")));
    const QString exponent = e < 0 ? QString() : mantissa.mid(e);
    mantissa.truncate(e < 0 ? mantissa.size() : e);
    const bool comma = mantissa.contains(u',');
    const qsizetype separator = mantissa.indexOf(comma ? u',' : u'.');
    qsizetype decimals = separator < 0 ? 0 : mantissa.size() - separator - 1;
    if (mantissa.size() > 17) {
        return text; // the last digit is beyond the precision of a double
    }
    qlonglong digits = std::llround(*parseNumber(mantissa) * std::pow(10.0, double(decimals)));
    if (digits + steps == 0 && !zeroAllowed) {
        digits *= 10;
        ++decimals;
    }
    digits += steps;
    QString shown = QString::number(std::abs(digits)).rightJustified(decimals + 1, u'0');
    if (decimals > 0) {
        shown.insert(shown.size() - decimals,
                     comma || separator < 0 ? QLocale().decimalPoint() : QStringLiteral("."));
        if (comma) {
            shown.replace(u'.', u',');
        }
    }
    return (digits < 0 ? QStringLiteral("-") : QString()) + shown + exponent;
}

QString dateText(const QDate& date) {
    const QLocale locale;
    return locale.toString(date, locale.language() == QLocale::Russian
                                     ? QStringLiteral("dd.MM.yyyy")
                                     : QStringLiteral("d MMMM yyyy"));
}

QString momentText(const QDateTime& moment) {
    return dateText(moment.date()) + moment.time().toString(QStringLiteral(", HH:mm"));
}

QDate documentDay() {
    bool given = false;
    const qlonglong epoch_s = qEnvironmentVariable("SOURCE_DATE_EPOCH").toLongLong(&given);
    const QDate day = given ? QDateTime::fromSecsSinceEpoch(epoch_s, Qt::UTC).date() : QDate();
    return day.isValid() ? day : QDate::currentDate();
}

QString keptTogether(QString line) {
    static const QRegularExpression gap(QStringLiteral("(?<=[0-9]) (?=\\p{L})|(?<=[≤≥=]) "));
    static const QRegularExpression fraction(QStringLiteral("(?<=\\p{L})/(?=\\p{L})"));
    constexpr QChar joiner(0x2060);
    return line.replace(gap, QStringLiteral("\u00A0"))
        .replace(fraction, QStringLiteral("/") + joiner);
}

QString sizeText(qint64 bytes) {
    constexpr qint64 kilo = 1000, mega = 1000 * kilo, giga = 1000 * mega;
    const auto shown = [bytes](const char* unit, qint64 of, int decimals) {
        const double size = double(bytes) / double(of);
        const QString number =
            QLocale().toString(decimals > 0 ? size : std::ceil(size), 'f', decimals);
        return QCoreApplication::translate("FileSize", unit).arg(number);
    };
    return bytes < mega   ? shown(QT_TRANSLATE_NOOP("FileSize", "%1 kB"), kilo, 0)
           : bytes < giga ? shown(QT_TRANSLATE_NOOP("FileSize", "%1 MB"), mega, 1)
                          : shown(QT_TRANSLATE_NOOP("FileSize", "%1 GB"), giga, 1);
}

TimeUnit::TimeUnit(double longest_s) : m_seconds(timeUnit_s(longest_s)) {}

QString TimeUnit::text() const {
    return unitText(m_seconds > 1 ? "min" : "s");
}

QString TimeUnit::titled(const QString& name) const {
    return QStringLiteral("%1, %2").arg(name, text());
}

} // namespace sparkout
