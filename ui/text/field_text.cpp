// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/field_text.h"

#include "core/project/member.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

namespace sparkout {

namespace {

struct FieldText {
    Q_DECLARE_TR_FUNCTIONS(FieldText)
};

QString joined(const std::vector<double>& numbers) {
    QStringList parts;
    for (const double number : numbers) {
        parts << printedNumber(number);
    }
    return parts.join(QStringLiteral("; "));
}

QString choiceShown(const Field& field, const void* owner) {
    return choiceText(field.choices[static_cast<std::size_t>(field.getChoice(owner))].label);
}

QString countOrWordShown(const Field& field, const void* owner) {
    if (const int* const number = field.wholeNumber(owner)) {
        return QString::number(*number);
    }
    return field.getChoice(owner) < 0 ? inputText(field.nullMeaning) : choiceShown(field, owner);
}

QString complianceShown(const GivenCompliance& compliance, const Field& field) {
    if (const auto* zones = std::get_if<ZoneCompliance>(&compliance)) {
        return joined({zones->rz1, zones->nz, zones->rz2});
    }
    const auto* sections = std::get_if<std::vector<double>>(&compliance);
    return sections ? joined(*sections) : inputText(field.nullMeaning);
}

QString levelsShown(const Levels& levels, const Field& field) {
    if (const auto* stepped = std::get_if<SteppedLevels>(&levels)) {
        return FieldText::tr("%1…%2 in steps of %3")
            .arg(printedNumber(stepped->from), printedNumber(stepped->to),
                 printedNumber(stepped->step));
    }
    const auto* list = std::get_if<std::vector<double>>(&levels);
    return list ? joined(*list) : inputText(field.nullMeaning);
}

QString rowsShown(const NumberRows& rows, const Field& field) {
    QStringList lines;
    for (const std::vector<double>& row : rows.value_or(std::vector<std::vector<double>>())) {
        lines << u'(' + joined(row) + u')';
    }
    return rows ? lines.join(QStringLiteral(", ")) : inputText(field.nullMeaning);
}

} // namespace

QString fieldText(const Field& field, const void* owner) {
    switch (field.kind) {
    case Kind::boolean: return field.as<bool>(owner) ? FieldText::tr("yes") : FieldText::tr("no");
    case Kind::text: return QString::fromStdString(field.as<std::string>(owner)).simplified();
    case Kind::choice: return choiceShown(field, owner);
    case Kind::numberList: return joined(field.as<std::vector<double>>(owner));
    case Kind::optionalNumberList: {
        const auto& list = field.as<std::optional<std::vector<double>>>(owner);
        return list ? joined(*list) : inputText(field.nullMeaning);
    }
    case Kind::countOrWord: return countOrWordShown(field, owner);
    case Kind::compliance: return complianceShown(field.as<GivenCompliance>(owner), field);
    case Kind::levels: return levelsShown(field.as<Levels>(owner), field);
    case Kind::numberRows: return rowsShown(field.as<NumberRows>(owner), field);
    default: return inputText(field.nullMeaning);
    }
}

std::optional<double> singleNumberIn(const Field& field, const void* owner) {
    switch (field.kind) {
    case Kind::objectList: return static_cast<double>(field.size(owner));
    case Kind::number:
    case Kind::optionalNumber:
    case Kind::integer:
    case Kind::optionalInteger: return ShownScale::of(field).shown(numberIn(field, owner));
    default: return std::nullopt;
    }
}

} // namespace sparkout
