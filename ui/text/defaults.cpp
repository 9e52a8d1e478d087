// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/defaults.h"

#include "core/project/member.h"
#include "core/project/project.h"
#include "ui/text/number_text.h"
#include "ui/text/shown_scale.h"
#include "ui/text/texts.h"

#include <QCoreApplication>

#include <algorithm>

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

} // namespace sparkout
