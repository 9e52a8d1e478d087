// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/input_value.h"

#include "core/project/conditions.h"
#include "core/project/member.h"
#include "core/project/number_input.h"
#include "core/setup/setup.h"
#include "core/setup/shared_members.h"
#include "core/text.h"

#include <utility>

namespace sparkout {

namespace {

bool putText(Project& project, const InputValue& value) {
    const Member member = findMember(project, value.path);
    if (!member) {
        return false;
    }
    if (member.field->kind == Kind::text) {
        member.field->as<std::string>(member.owner) = value.text;
        return true;
    }
    for (std::size_t i = 0; member.field->kind == Kind::choice && i < member.field->choices.size();
         ++i) {
        if (value.text == member.field->choices[i].key) {
            member.field->setChoice(member.owner, static_cast<int>(i));
            return true;
        }
    }
    return false;
}

} // namespace

bool putInput(Project& project, const InputValue& value) {
    return value.number ? setNumberInput(project, value.path, *value.number)
                        : putText(project, value);
}

bool putInput(Setup& setup, std::size_t surface, const InputValue& value) {
    if (surface >= setup.surfaces.size() || !putInput(setup.surfaces[surface].project, value)) {
        return false;
    }
    if (isShared(value.path)) {
        for (GroundSurface& other : setup.surfaces) {
            copyShared(Project(setup.surfaces[surface].project), other.project);
        }
    }
    return true;
}

template <>
const StructInfo& tableOf<InputValue>() {
    static const std::array rows{
        SPARKOUT_FIELD(InputValue, path, .label = SPARKOUT_NOOP("Input", "Input"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input",
                                             "Its path in a project file, as `/wheel/dullness` or "
                                             "`/cycle/stages/0/stock_mm`.")),
        SPARKOUT_FIELD(InputValue, number, .label = SPARKOUT_NOOP("Input", "Number"),
                       .hard = {-1e9, 1e9}, .nullMeaning = SPARKOUT_NOOP("Input", "the text"),
                       .hint = SPARKOUT_NOOP("Input", "In the unit of the input.")),
        SPARKOUT_FIELD(InputValue, text, .label = SPARKOUT_NOOP("Input", "Text"), .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "A choice by its key, or a name.")),
    };
    static const StructInfo info =
        makeTable<InputValue>(SPARKOUT_NOOP("Struct", "Value of an input"), rows);
    return info;
}

} // namespace sparkout
