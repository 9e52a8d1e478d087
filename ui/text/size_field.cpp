// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/size_field.h"

#include "core/project/part.h"
#include "ui/text/number_text.h"

#include <QCoreApplication>
#include <QLocale>

#include <array>

namespace sparkout {

namespace {

constexpr int finest = 4, coarsest = 14; // range of the tables in core/project/iso286.h

QString sizeWords(const char* text) {
    return QCoreApplication::translate("SizeField", text);
}

QString signedNumber(double value_um) {
    const QString digits = printedNumber(value_um);
    return value_um > 0 ? u'+' + digits : digits;
}

TypedSize refusal(const char* reason) {
    return {std::nullopt, {}, sizeWords(reason)};
}

} // namespace

TypedSize readSize(const QString& typed, const Part& part) {
    const QString text = typed.trimmed();
    if (text.isEmpty()) {
        return {};
    }
    auto size = parseSizeDesignation(text.toStdString());
    if (!size) { // only the letters
        size =
            parseSizeDesignation((showNumber(part.diameter_mm, QLocale::c()) + text).toStdString());
    }
    if (!size) {
        return refusal(QT_TRANSLATE_NOOP(
            "SizeField", "This is not a size with a tolerance class; write it like 30h6."));
    }
    const bool internal = part.surface == Surface::internal;
    if (size->isHole() != internal) {
        return refusal(
            internal ? QT_TRANSLATE_NOOP("SizeField", "Small letters are for shafts; this surface "
                                                      "is a bore.")
                     : QT_TRANSLATE_NOOP("SizeField", "Capital letters are for bores; this surface "
                                                      "is a shaft."));
    }
    const auto deviations = sizeDeviations(*size);
    if (!deviations) {
        return refusal(QT_TRANSLATE_NOOP("SizeField",
                                         "ISO 286 has no such class here: sizes to 500 mm, grades "
                                         "4 to 14, letters d to p."));
    }
    return {size, *deviations,
            sizeWords(QT_TRANSLATE_NOOP("SizeField", "∅%1 mm, upper %2 µm, lower %3 µm"))
                .arg(printedNumber(size->nominal_mm), signedNumber(deviations->upper_um),
                     signedNumber(deviations->lower_um))};
}

QString symbolOf(const Field& field, const Part& part) {
    const QString symbol = QString::fromUtf8(field.symbol);
    const bool isDeviation = symbol == u"es" || symbol == u"ei";
    return isDeviation && part.surface == Surface::internal ? symbol.toUpper() : symbol;
}

QString fieldOf(const Part& part) {
    static constexpr std::array letters{"h", "js", "g", "f", "k", "m", "n", "p", "e", "d", "j"};
    for (const char* shaft : letters) {
        for (int grade = finest; grade <= coarsest; ++grade) {
            const QString letter = QString::fromLatin1(shaft);
            const QString field = part.surface == Surface::internal ? letter.toUpper() : letter;
            const SizeDesignation size{part.diameter_mm, field.toStdString(), grade};
            const auto limits = sizeDeviations(size);
            if (limits && limits->upper_um == part.upper_deviation_um
                && limits->lower_um == part.lower_deviation_um) {
                return printedNumber(part.diameter_mm) + field + QString::number(grade);
            }
        }
    }
    return {};
}

} // namespace sparkout
