// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/field_text.h"

#include "core/project/cycle.h"
#include "core/project/member.h"
#include "ui/text/names.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <vector>

namespace sparkout {

namespace {

/// The table that contains a row, searched below another; null if there is none.
const StructInfo* tableHolding(const Field& field, const StructInfo& table) {
    for (const Field& row : table.fields) {
        if (&row == &field) {
            return &table;
        }
        const StructInfo* found = row.nested ? tableHolding(field, *row.nested) : nullptr;
        if (found) {
            return found;
        }
    }
    return nullptr;
}

/// The struct with the defaults of the table that contains a row.
const void* defaultsOf(const Field& field) {
    const StructInfo* table = tableHolding(field, tableOf<Project>());
    return table ? table->defaults : nullptr;
}

bool isNumber(Kind kind) {
    return kind == Kind::number || kind == Kind::optionalNumber || kind == Kind::integer
           || kind == Kind::optionalInteger;
}

} // namespace

bool hasDefault(const Field& field) {
    const bool simple =
        isNumber(field.kind) || field.kind == Kind::boolean || field.kind == Kind::choice;
    return simple && !field.required && defaultsOf(field);
}

bool isDefault(const Field& field, const void* owner) {
    return !hasDefault(field) || field.same(owner, defaultsOf(field));
}

bool isAsNew(const Field& field, const void* owner) {
    switch (field.kind) {
    case Kind::optionalObject: return !field.objectIn(owner);
    case Kind::objectList: return field.size(owner) == 0;
    case Kind::object:
        return std::ranges::all_of(field.nested->fields,
                                   [object = field.objectIn(owner)](const Field& member) {
                                       return isAsNew(member, object);
                                   });
    default: {
        const void* const defaults = defaultsOf(field);
        return defaults && field.same(owner, defaults);
    }
    }
}

QString defaultText(const Field& field) {
    return hasDefault(field) ? valueText(field, defaultsOf(field)) : QString();
}

QString valueText(const Field& field, const void* owner) {
    if (field.kind == Kind::boolean) {
        return field.as<bool>(owner) ? QCoreApplication::translate("Default", "yes")
                                     : QCoreApplication::translate("Default", "no");
    }
    if (field.kind == Kind::choice) {
        return choiceText(field.choices[std::size_t(field.getChoice(owner))].label);
    }
    const auto value = numberIn(field, owner);
    if (!value) {
        return inputText(field.nullMeaning);
    }
    const QString number = printedNumber(ShownScale::ofInput(field).shown(*value));
    return *field.unit ? number + u'\u00a0' + unitText(field.unit) : number;
}

void setDefault(const Field& field, void* owner) {
    if (!hasDefault(field)) {
        return;
    }
    const void* const defaults = defaultsOf(field);
    switch (field.kind) {
    case Kind::boolean: field.as<bool>(owner) = field.as<bool>(defaults); break;
    case Kind::choice: field.setChoice(owner, field.getChoice(defaults)); break;
    default: setNumberIn(field, owner, numberIn(field, defaults));
    }
}

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

namespace {

QString byPlace(bool zones) {
    return zones ? QCoreApplication::translate("OperationNotice", "zone by zone")
                 : QCoreApplication::translate("OperationNotice", "section by section");
}

/// For a compliance, and for values of single zones or sections, states what they are given for.
QString switchedText(const ConstMember& member, const Project& of) {
    switch (member.field->kind) {
    case Kind::compliance: {
        const auto& given = member.field->as<GivenCompliance>(member.owner);
        return std::holds_alternative<std::monostate>(given)
                   ? inputText(member.field->nullMeaning)
                   : byPlace(std::holds_alternative<ZoneCompliance>(given));
    }
    case Kind::optionalNumberList:
        return member.field->as<std::optional<std::vector<double>>>(member.owner)
                   ? byPlace(of.operation->travels)
                   : inputText(member.field->nullMeaning);
    case Kind::numberRows:
        return member.field->as<NumberRows>(member.owner) ? byPlace(of.operation->travels)
                                                          : inputText(member.field->nullMeaning);
    default: return valueText(*member.field, member.owner);
    }
}

/// Adds the axial feeds, stage by stage, if a traverse gave them to stages without one.
void addAxialFeeds(const Project& before, const Project& after, QStringList& changes) {
    const StageFeed* const axial = after.operation->axial();
    const bool areSet = axial && !before.operation->axial()
                        && std::ranges::any_of(before.cycle->stages, [axial](const Stage& stage) {
                               return !(stage.*axial->value);
                           });
    if (!areSet) {
        return;
    }
    const Field& row = *tableOf<Stage>().find(axial->key);
    QStringList feeds;
    for (const Stage& stage : after.cycle->stages) {
        feeds += valueText(row, &stage);
    }
    changes += QStringLiteral("%1: %2 → %3")
                   .arg(inputText(row.label), inputText(row.nullMeaning),
                        feeds.join(QStringLiteral(", ")));
}

} // namespace

QStringList changesOfOperation(const Project& before, const Project& after) {
    QStringList changes;
    for (const char* path :
         {"/part/length_mm", "/machine/overrun_entry_mm", "/machine/overrun_exit_mm",
          "/machine/compliance_mm_per_n", "/gauge/section", "/gauge/position_mm",
          "/gauge/compliance_mm_per_n", "/least_steps", "/part/zone_stock_mm",
          "/part/zone_runout_mm", "/machine/zone_compliance", "/batch/zone_stock_mm",
          "/machine/form/roundness_um", "/machine/form/runout_um", "/batch/zone_runout_mm",
          "/batch/zone_compliance"}) {
        const ConstMember was = findMember(before, path);
        const QString old = switchedText(was, before);
        const QString made = switchedText(findMember(after, path), after);
        if (old != made) {
            changes += QStringLiteral("%1: %2 → %3").arg(inputText(was.field->label), old, made);
        }
    }
    addAxialFeeds(before, after, changes);
    return changes;
}

namespace {

QString translated(const char* text) {
    return *text ? QCoreApplication::translate("Output", text) : QString();
}

QString withUnit(const QString& label, const OutputRow& row) {
    const QString unit = unitText(row.unitShown());
    return unit.isEmpty() ? label : QStringLiteral("%1, %2").arg(label, unit);
}

} // namespace

QString outputLabel(const OutputRow& row) {
    return translated(*row.brief ? row.brief : row.label);
}

QString outputName(const OutputRow& row, bool revolutions) {
    return withUnit(translated(row.labelOf(revolutions)), row);
}

QString outputBrief(const OutputRow& row, bool revolutions) {
    const QString brief = translated(row.brief);
    return brief.isEmpty()          ? outputName(row, revolutions)
           : brief.startsWith(u' ') ? brief // below a row with the unit
                                    : withUnit(brief, row);
}

QString outputHint(const OutputRow& row) {
    return translated(row.hint);
}

std::optional<double> outputNumber(const OutputRow& row, const OutputValue& value) {
    if (const auto* number = std::get_if<double>(&value)) {
        return *number * row.shownFactor;
    }
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return static_cast<double>(*whole);
    }
    if (const auto* estimate = std::get_if<Estimate>(&value)) {
        return estimate->value * row.shownFactor;
    }
    if (const auto* share = std::get_if<Share>(&value)) {
        return share->value;
    }
    return {};
}

QString outputText(const OutputRow& row, const OutputValue& value) {
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return QString::number(*whole);
    }
    const std::optional<double> number = outputNumber(row, value);
    return number ? threeDigits(*number) : QString();
}

QString threeDigits(double value) {
    if (!(value > 0)) {
        return QStringLiteral("0");
    }
    const int zeros = value < 1 ? -static_cast<int>(std::floor(std::log10(value))) - 1 : 0;
    return Names::significant(value, std::max(1, 3 - zeros));
}

} // namespace sparkout
