// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QLocale>
#include <QString>

#include <optional>

/// Numbers and dates as people type and read them.
namespace sparkout {

/// Reads a number written with a decimal point or comma, an exponent or a power of ten, a
/// typographic minus and spaces around it. Anything else, group separators too, is no number.
[[nodiscard]] std::optional<double> parseNumber(const QString& text);

/// The shortest digits that read back to the same double, with the locale's decimal separator;
/// plain decimals from 1e-7 to 1e15, an exponent beyond.
[[nodiscard]] QString showNumber(double value, const QLocale& locale);

/// The same in the present locale with a typographic minus and a power of ten where the other has
/// an exponent, "1.5·10⁻⁸": for what is read, not typed.
[[nodiscard]] QString printedNumber(double value);

/// So many significant digits at most, as QLocale's 'g' has them, written as printedNumber() does.
[[nodiscard]] QString printedNumber(double value, int digits);

/// A number with an exponent as people write it: "1.5·10⁻⁸" for "1.5e-8", "10⁻¹⁵" for "1e-15". A
/// text without an exponent stays.
[[nodiscard]] QString withPower(const QString& number);

/// The number of a text one step of its last digit higher (steps > 0) or lower, written as the
/// text is. A step to zero that the caller refuses goes one digit finer.
[[nodiscard]] QString stepNumber(const QString& text, int steps, bool zeroAllowed);

/// A date as the present language writes it, the year in full: "23 November 2026", "23.11.2026".
[[nodiscard]] QString dateText(const QDate& date);
/// The same with hours and minutes.
[[nodiscard]] QString momentText(const QDateTime& moment);

/// The day that a document bears: today, or that of SOURCE_DATE_EPOCH where the environment gives
/// one, so that documents can be made anew byte by byte.
[[nodiscard]] QDate documentDay();

/// Of a file or the room for one, in the units of the present language: "10 kB", "2.5 GB".
[[nodiscard]] QString sizeText(qint64 bytes);

/// A text in which no line ends between a number and its unit, a sign and its number, or within a
/// unit.
[[nodiscard]] QString keptTogether(QString line);

} // namespace sparkout
