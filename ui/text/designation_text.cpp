// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/designation_text.h"

#include "core/project/member.h"
#include "core/project/part.h"
#include "core/project/wheel.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

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
                                         "ISO 286 does not have this class here: sizes to 500 "
                                         "mm, grades 4 to 14, letters d to p."));
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

namespace {

QString markingWord(const char* text) {
    return QCoreApplication::translate("Marking", text);
}

QString number(double value) {
    return printedNumber(value);
}

/// The kind of grain, by the letter and the first digit of its mark [ABRASIVES].
QString abrasiveMeaning(const std::string& abrasive) {
    const bool carbide = abrasive.ends_with("С");
    const char digit = abrasive.empty() ? '\0' : abrasive.front();
    if (carbide) {
        return digit == '5'   ? markingWord(QT_TRANSLATE_NOOP("Marking", "black silicon carbide"))
               : digit == '6' ? markingWord(QT_TRANSLATE_NOOP("Marking", "green silicon carbide"))
                              : markingWord(QT_TRANSLATE_NOOP("Marking", "silicon carbide"));
    }
    switch (digit) {
    case '1': return markingWord(QT_TRANSLATE_NOOP("Marking", "normal fused alumina"));
    case '2': return markingWord(QT_TRANSLATE_NOOP("Marking", "white fused alumina"));
    default: return markingWord(QT_TRANSLATE_NOOP("Marking", "fused alumina"));
    }
}

QString bondMeaning(const std::string& bond) {
    switch (bond.empty() ? '\0' : bond.front()) {
    case 'V': return markingWord(QT_TRANSLATE_NOOP("Marking", "vitrified bond"));
    case 'B': return markingWord(QT_TRANSLATE_NOOP("Marking", "resin bond"));
    case 'R': return markingWord(QT_TRANSLATE_NOOP("Marking", "rubber bond"));
    case 'E': return markingWord(QT_TRANSLATE_NOOP("Marking", "shellac bond"));
    case 'M': return markingWord(QT_TRANSLATE_NOOP("Marking", "magnesite bond"));
    case 'P': return markingWord(QT_TRANSLATE_NOOP("Marking", "plastic bond"));
    default: return {};
    }
}

std::optional<double> numberIn(const Field& field, const Wheel& wheel) {
    return field.kind == Kind::number           ? std::optional(field.as<double>(&wheel))
           : field.kind == Kind::optionalNumber ? field.as<std::optional<double>>(&wheel)
                                                : std::nullopt;
}

} // namespace

QString markingExplained(const WheelMarking& marking) {
    QStringList parts;
    if (marking.diameter_mm && marking.width_mm) {
        parts += marking.bore_mm
                     ? markingWord(QT_TRANSLATE_NOOP("Marking", "∅%1 mm, width %2 mm, bore %3 mm"))
                           .arg(number(*marking.diameter_mm), number(*marking.width_mm),
                                number(*marking.bore_mm))
                     : markingWord(QT_TRANSLATE_NOOP("Marking", "∅%1 mm, width %2 mm"))
                           .arg(number(*marking.diameter_mm), number(*marking.width_mm));
    }
    parts += QString::fromStdString(marking.abrasive) + QStringLiteral(" – ")
             + abrasiveMeaning(marking.abrasive);
    parts += markingWord(QT_TRANSLATE_NOOP("Marking", "F%1 – grain %2 mm"))
                 .arg(marking.grit)
                 .arg(number(grainOfGrit(marking.grit).value_or(0)));
    parts += markingWord(QT_TRANSLATE_NOOP("Marking", "%1 – hardness (A softest, Z hardest)"))
                 .arg(QLatin1Char(marking.hardness));
    if (marking.structure) {
        parts += markingWord(QT_TRANSLATE_NOOP("Marking", "structure %1 – grain share %2"))
                     .arg(*marking.structure)
                     .arg(number(grainShareOfStructure(*marking.structure)));
    }
    parts +=
        QString::fromStdString(marking.bond) + QStringLiteral(" – ") + bondMeaning(marking.bond);
    if (marking.speed_m_s) {
        parts += markingWord(QT_TRANSLATE_NOOP("Marking", "at most %1 m/s"))
                     .arg(number(*marking.speed_m_s));
    }
    return parts.join(QStringLiteral("; "));
}

QString markingChanges(const WheelMarking& marking, const Wheel& wheel) {
    Wheel filled = wheel;
    applyMarking(marking, filled);
    QStringList changes;
    for (const Field& field : tableOf<Wheel>().fields) {
        const auto now = numberIn(field, wheel), then = numberIn(field, filled);
        if (now != then && then) {
            const QString unit = *field.unit ? u'\u00a0' + unitText(field.unit) : QString();
            changes += QStringLiteral("%1 %2 → %3%4")
                           .arg(inputText(field.label), now ? number(*now) : QStringLiteral("—"),
                                number(*then), unit);
        }
    }
    return changes.join(QStringLiteral("; "));
}

} // namespace sparkout
