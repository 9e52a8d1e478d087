// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QLocale>
#include <QString>

#include <optional>

/// Numbers and dates as people type and read them.
namespace sparkout {

/// Reads a number written with a decimal point or comma, an exponent or a power of ten, a
/// typographic minus and spaces around it. Any other text, also with group separators, is not a
/// number.
[[nodiscard]] std::optional<double> parseNumber(const QString& text);

/// The shortest digits that read back to the same double, with the locale's decimal separator;
/// plain decimals from 1e-7 to 1e15, an exponent beyond.
[[nodiscard]] QString showNumber(double value, const QLocale& locale);

/// A number for display in the current locale, with a typographic minus and a power of ten in place
/// of an exponent, "1.5·10⁻⁸".
[[nodiscard]] QString printedNumber(double value);

/// With at most this number of significant digits, like QLocale's 'g', in the format of
/// printedNumber().
[[nodiscard]] QString printedNumber(double value, int digits);

/// A number with an exponent in the usual notation: "1.5·10⁻⁸" for "1.5e-8", "10⁻¹⁵" for "1e-15". A
/// text without an exponent is unchanged.
[[nodiscard]] QString withPower(const QString& number);

/// Changes the number of a text by steps of its last digit, in the same notation. A step to a zero
/// that the caller refuses uses the next finer digit.
[[nodiscard]] QString stepNumber(const QString& text, int steps, bool zeroAllowed);

/// A date in the format of the current language, with the full year: "23 November 2026",
/// "23.11.2026".
[[nodiscard]] QString dateText(const QDate& date);
/// The date with hours and minutes.
[[nodiscard]] QString momentText(const QDateTime& moment);

/// The date on documents: today, or that of SOURCE_DATE_EPOCH if the environment sets it, so that
/// documents are reproducible byte by byte.
[[nodiscard]] QDate documentDay();

/// The size of a file or of free space in the units of the current language: "10 kB", "2.5 GB".
[[nodiscard]] QString sizeText(qint64 bytes);

/// A text without line breaks between a number and its unit, a sign and its number, or within a
/// unit.
[[nodiscard]] QString keptTogether(QString line);

/// The unit of all times of one chart or table: seconds where the longest is below two minutes,
/// otherwise minutes.
class TimeUnit {
public:
    explicit TimeUnit(double longest_s = 0);

    [[nodiscard]] double of(double time_s) const { return time_s / m_seconds; }
    [[nodiscard]] QString text() const;                      ///< "s", "min"
    [[nodiscard]] QString titled(const QString& name) const; ///< "Time, s"

private:
    double m_seconds;
};

} // namespace sparkout
