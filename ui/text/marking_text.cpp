// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/marking_text.h"

#include "core/project/member.h"
#include "core/project/wheel.h"
#include "ui/text/number_text.h"
#include "ui/text/texts.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

#include <optional>

namespace sparkout {

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
