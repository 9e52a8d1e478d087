// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/parts/input_fact.h"

#include "core/project/iso286.h"
#include "core/project/member.h"
#include "core/project/part.h"
#include "core/units.h"
#include "ui/report/parts/cell_text.h"
#include "ui/text/designation_text.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QStringList>

#include <cmath>
#include <cstddef>

namespace sparkout::report {

namespace {
constexpr double nanometres = 1e3; ///< per micrometre
}

QString drawnSize(const Part& part) {
    QString field = fieldOf(part);
    for (const QString& word : oneLine(part.name).split(u' ', Qt::SkipEmptyParts)) {
        const auto size = parseSizeDesignation(word.toStdString());
        if (field.isEmpty() && size && size->nominal_mm == part.diameter_mm
            && size->isHole() == (part.surface == Surface::internal)) {
            field = printedNumber(size->nominal_mm) + QString::fromStdString(size->letters)
                    + QString::number(size->grade);
        }
    }
    const auto limit = [](double value_um) {
        return (value_um > 0 ? QStringLiteral("+") : QString())
               + printedNumber(std::round(value_um * nanometres) / nanometres / units::umPerMm);
    };
    const double upper = part.upper_deviation_um, lower = part.lower_deviation_um;
    QString limits;
    if (upper == -lower) {
        limits = upper == 0 ? QStringLiteral("0") : u'±' + limit(upper).remove(u'+');
    } else if (upper == 0 || lower == 0) {
        limits = limit(upper == 0 ? lower : upper);
    } else {
        limits = limit(upper) + QStringLiteral("; ") + limit(lower);
    }
    return u'⌀' + (field.isEmpty() ? printedNumber(part.diameter_mm) + u' ' : field) + u'(' + limits
           + u')';
}

std::pair<QString, QString> inputFact(const Project& project, const char* path) {
    const ConstMember member = findMember(project, path);
    const Field& field = *member.field;
    QString name = inputText(field.label);
    if (*field.symbol) {
        name += QStringLiteral(" ") + symbolOf(field, *project.part).remove(u'_');
    }
    if (field.kind == sparkout::Kind::text) {
        return {name, cell(oneLine(field.as<std::string>(member.owner)))};
    }
    if (field.kind == sparkout::Kind::choice) {
        const auto chosen = static_cast<std::size_t>(field.getChoice(member.owner));
        return {name, choiceText(field.choices[chosen].label)};
    }
    const std::optional<double> value = ShownScale::of(field).shown(numberIn(field, member.owner));
    if (!value) {
        return {name, cell({})};
    }
    constexpr int digits = 6; // wear by the earlier surfaces gives all digits of a double
    const QString printed = printedNumber(*value, digits);
    return {name, *field.unit ? withUnit(printed, field.unit) : printed};
}

} // namespace sparkout::report
