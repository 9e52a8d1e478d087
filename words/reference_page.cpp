// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/reference_page.h"

#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/project/cycle.h"
#include "core/project/gauge.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/part.h"
#include "core/project/project.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/setup/setup.h"
#include "core/text.h"

#include <array>
#include <set>
#include <vector>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

const char* typeText(Kind kind) {
    switch (kind) {
    case Kind::number:
    case Kind::optionalNumber: return "number";
    case Kind::integer:
    case Kind::optionalInteger: return "whole number";
    case Kind::boolean: return "true or false";
    case Kind::text: return "text";
    case Kind::choice: return "one of";
    case Kind::numberList:
    case Kind::samples:
    case Kind::optionalNumberList: return "list of numbers";
    case Kind::object:
    case Kind::optionalObject: return "object";
    case Kind::objectList: return "list of objects";
    case Kind::countOrWord: return "whole number or";
    case Kind::compliance:
        return "object with rz1, nz, rz2 (traverse), or list of numbers (plunge)";
    case Kind::levels: return "list of numbers, or object with from, to, step";
    case Kind::numberRows: return "list of rows of numbers";
    case Kind::jsonText: return "object";
    }
    return "";
}

bool mayBeNull(Kind kind) {
    switch (kind) {
    case Kind::optionalNumber:
    case Kind::optionalInteger:
    case Kind::optionalNumberList:
    case Kind::optionalObject:
    case Kind::countOrWord:
    case Kind::compliance:
    case Kind::levels:
    case Kind::numberRows: return true;
    default: return false;
    }
}

std::string typeColumn(const Field& field) {
    std::string text = typeText(field.kind);
    if (field.kind == Kind::choice || field.kind == Kind::countOrWord) {
        for (std::size_t i = 0; i < field.choices.size(); ++i) {
            text += (i == 0 ? " `\"" : ", `\"") + std::string(field.choices[i].key) + "\"`";
        }
    }
    if (field.count != 0) {
        text += ", " + std::to_string(field.count) + " each";
    }
    return text;
}

std::string rangeColumn(const Range& range, const Field& field) {
    if (range.unbounded()) {
        return "";
    }
    const bool items = field.kind == Kind::objectList;
    return rangeText(range, items ? "items" : "");
}

std::string allowedColumn(const Field& field) {
    const std::string text = rangeColumn(field.stated(), field);
    return field.read.unbounded()
               ? text
               : text + " where it feeds, else " + rangeColumn(field.hard, field);
}

std::string requiredColumn(const Field& field, const StructInfo& table) {
    std::string text = field.required ? conditionText(field.required, table) : "";
    const std::string relevant = field.relevant ? conditionText(field.relevant, table) : "";
    if (!relevant.empty() && relevant != text) {
        text += (text.empty() ? "" : "; ") + ("used: " + relevant);
    }
    return text;
}

std::string defaultColumn(const Field& field, const StructInfo& table) {
    const bool always = field.required && conditionText(field.required, table) == "always";
    if (always || field.kind == Kind::object) {
        return "";
    }
    const ordered_json defaults = writeByTable(table, table.defaults);
    const auto found = defaults.find(field.key);
    std::string text = printJson(found == defaults.end() ? ordered_json(nullptr) : *found);
    text.pop_back(); // the line end
    return '`' + text + '`';
}

std::string meaningColumn(const Field& field) {
    std::string text = field.label;
    if (*field.symbol) {
        text += " *" + std::string(field.symbol) + "*";
    }
    if (*field.hint) {
        text += ". " + std::string(field.hint);
    }
    if (*field.formula) {
        text += " `" + std::string(field.formula) + "`.";
    }
    if (mayBeNull(field.kind)) {
        text += std::string(text.back() == '.' ? "" : ".") + " `null`: " + field.nullMeaning + ".";
    }
    if (*field.source) {
        text += " [" + std::string(field.source) + "]";
    }
    return text;
}

constexpr const char* introduction =
    R"(<!-- Made from the tables of the core by sparkout-reference: do not edit. -->

# The project file

A project is one UTF-8 JSON file with the extension `.sparkout`. It begins with
`"format": "sparkout-project"` and `"version": 1`; the keys below follow in any order. A number is
written with the shortest digits that read back to the same value.

* An unknown key, a key that stands twice, a missing required key, a wrong type and a value outside
  the allowed range are errors: the message names the path, the value and what is allowed.
* A value outside the usual range is a warning. It refuses nothing.
* A key that is left out takes its default. `null` is allowed where its meaning is given.
* `>` before a range excludes its lower end.
* Sources are the keys of `core/SOURCES.md`; MODEL-n is section n of the process model.

`project.schema.json`, beside this page, says the same to editors and programs.
)";

constexpr const char* severalSurfaces =
    R"(
# Several surfaces in one set-up

`"version": 2` holds a part of 1 to 20 surfaces that are ground in one set-up, in this order. What
they share stands once, at the path it has above:

)";

constexpr const char* surfacesInOrder =
    R"(
Every other key above stands in its place in each object of `"surfaces"`, which also has a `"name"` of
its own; `part.shaft.ground_from_mm` is where the surface stands on the shaft, from which its
compliance follows. A key in the wrong one of the two
places is an error that names it. A set-up of one
surface without name, times and wear is written as version 1, and a file of version 1 is read as such
a set-up. Window and `sparkout-cli` take files of both versions;
`project.schema.json` describes both.
)";

// --- conditions in words ------------------------------------------------------------------------

/// A question that a condition may depend on, and its possible answers in words.
struct Question {
    std::vector<const char*> answers;
    void (*answer)(Project& project, Stage& stage, std::size_t choice);
};

const std::array<Question, 12>& questions() {
    static const std::array<Question, 12> all{{
        {{SPARKOUT_NOOP("Condition", "traverse"), SPARKOUT_NOOP("Condition", "plunge")},
         [](Project& p, Stage&, std::size_t i) { p.operation = Operation::ofIndex(i); }},
        {{SPARKOUT_NOOP("Condition", "external"), SPARKOUT_NOOP("Condition", "internal")},
         [](Project& p, Stage&, std::size_t i) { p.part->surface = static_cast<Surface>(i); }},
        {{SPARKOUT_NOOP("Condition", "ellipse"), SPARKOUT_NOOP("Condition", "eccentric"),
          SPARKOUT_NOOP("Condition", "lobes"), SPARKOUT_NOOP("Condition", "measured")},
         [](Project& p, Stage&, std::size_t i) { p.part->profile = static_cast<ProfileForm>(i); }},
        {{SPARKOUT_NOOP("Condition", "between centres"), SPARKOUT_NOOP("Condition", "in a chuck")},
         [](Project& p, Stage&, std::size_t i) {
             p.part->shaft.mounting = static_cast<Mounting>(i);
         }},
        {{SPARKOUT_NOOP("Condition", "gauge at a section"),
          SPARKOUT_NOOP("Condition", "gauge at a free position")},
         [](Project& p, Stage&, std::size_t i) {
             p.gauge->position_mm = i == 0 ? std::nullopt : std::optional<double>(1);
         }},
        {{SPARKOUT_NOOP("Condition", "gauge control"),
          SPARKOUT_NOOP("Condition", "position control")},
         [](Project& p, Stage&, std::size_t i) { p.gauge->control = static_cast<Control>(i); }},
        {{SPARKOUT_NOOP("Condition", "surface without gaps"),
          SPARKOUT_NOOP("Condition", "interrupted surface")},
         [](Project& p, Stage&, std::size_t i) { p.part->gaps = std::vector<SurfaceGap>(i); }},
        {{SPARKOUT_NOOP("Condition", "no length of a wear flat"),
          SPARKOUT_NOOP("Condition", "a wear flat of a given length")},
         [](Project& p, Stage&, std::size_t i) {
             if (i == 1) {
                 p.wheel->force_recipe.emplace().wear_flat_mm = 0;
             }
         }},
        {{SPARKOUT_NOOP("Condition", "force law of the sources"),
          SPARKOUT_NOOP("Condition", "force law with a threshold")},
         [](Project& p, Stage&, std::size_t i) {
             p.material->force_law = static_cast<ForceLawKind>(i);
         }},
        {{SPARKOUT_NOOP("Condition", "no machine's form"),
          SPARKOUT_NOOP("Condition", "with the machine's form")},
         [](Project& p, Stage&, std::size_t i) {
             if (i == 1) {
                 p.machine->form.emplace().runout_um.emplace();
             }
         }},
        {{SPARKOUT_NOOP("Condition", "runout of the wheel not given"),
          SPARKOUT_NOOP("Condition", "runout of the wheel by its amplitude"),
          SPARKOUT_NOOP("Condition", "unbalanced wheel")},
         [](Project& p, Stage&, std::size_t i) {
             if (i > 0) {
                 WheelRunout& runout = p.wheel->runout.emplace();
                 (i == 1 ? runout.amplitude_um : runout.balance_grade_mm_s) = 1;
             }
         }},
        {{SPARKOUT_NOOP("Condition", "the stage feeds"),
          SPARKOUT_NOOP("Condition", "the stage is a spark-out")},
         [](Project&, Stage& stage, std::size_t i) {
             i == 0 ? stage.dropSparkOut() : stage.sparkOutUntilSize();
         }},
    }};
    return all;
}

/// Evaluates the condition in every situation; calls back with the answers for which it is true.
template <class Visit>
void forEachTrueSituation(Condition condition, const StructInfo& table, const Visit& visit) {
    std::vector<std::size_t> answers(questions().size(), 0);
    for (;;) {
        Project project;
        Stage stage;
        for (std::size_t q = 0; q < answers.size(); ++q) {
            questions()[q].answer(project, stage, answers[q]);
        }
        const void* owner = &table == &tableOf<Stage>() ? &stage : table.defaults;
        if (condition(project, owner)) {
            visit(answers);
        }
        std::size_t q = 0;
        while (q < answers.size() && ++answers[q] == questions()[q].answers.size()) {
            answers[q++] = 0;
        }
        if (q == answers.size()) {
            return;
        }
    }
}

} // namespace

void TablePage::addStruct(const StructInfo& table, const std::string& path) {
    text += "\n## " + std::string(table.name) + "\n\nPath `" + (path.empty() ? "/" : path);
    text += "`.\n\n| key | type | unit | default | allowed | usual | required | meaning |\n"
            "| --- | --- | --- | --- | --- | --- | --- | --- |\n";
    for (const Field& field : table.fields) {
        addRow(field, table);
    }
    for (const Field& field : table.fields) {
        if (field.nested) {
            const char* item = field.kind == Kind::objectList ? "/*" : "";
            addNested(*field.nested, path + "/" + field.key + item);
        }
    }
}

void TablePage::addRow(const Field& field, const StructInfo& table) {
    text += "| `" + std::string(field.key) + "` ";
    for (const std::string& column :
         {typeColumn(field), std::string(field.unit), defaultColumn(field, table),
          allowedColumn(field), rangeColumn(field.soft, field), requiredColumn(field, table),
          meaningColumn(field)}) {
        text += column.empty() ? "| " : "| " + column + " ";
    }
    text += "|\n";
}

void TablePage::addNested(const StructInfo& table, const std::string& path) {
    const auto [described, isNew] = m_described.emplace(&table, path);
    if (isNew) {
        addStruct(table, path);
    } else {
        text += "\n`" + path + "` has the keys of `" + described->second + "`.\n";
    }
}

ConditionAnswers conditionAnswers(Condition condition, const StructInfo& table) {
    std::vector<std::set<std::size_t>> seen(questions().size());
    forEachTrueSituation(condition, table, [&](const std::vector<std::size_t>& answers) {
        for (std::size_t q = 0; q < answers.size(); ++q) {
            seen[q].insert(answers[q]);
        }
    });
    if (seen[0].empty()) {
        return std::nullopt;
    }
    std::vector<std::vector<const char*>> groups;
    for (std::size_t q = 0; q < seen.size(); ++q) {
        if (seen[q].size() == questions()[q].answers.size()) {
            continue;
        }
        auto& group = groups.emplace_back();
        for (const std::size_t answer : seen[q]) {
            group.push_back(questions()[q].answers[answer]);
        }
    }
    return groups;
}

std::string conditionText(Condition condition, const StructInfo& table) {
    const ConditionAnswers answers = conditionAnswers(condition, table);
    if (!answers) {
        return "never";
    }
    std::string text;
    for (const auto& group : *answers) {
        std::string part;
        for (const char* answer : group) {
            part += (part.empty() ? "" : " or ") + std::string(answer);
        }
        text += (text.empty() ? "" : ", ") + part;
    }
    return text.empty() ? "always" : text;
}

std::string referencePage() {
    TablePage page;
    page.text = introduction;
    page.addStruct(tableOf<Project>(), {});
    page.text += severalSurfaces;
    for (const std::string_view member : sharedMembers()) {
        page.text += "* `" + std::string(member) + "`\n";
    }
    page.text += surfacesInOrder;
    page.addStruct(tableOf<SetupTimes>(), "/times");
    page.addStruct(tableOf<WheelWear>(), "/wear");
    return std::move(page.text);
}

} // namespace sparkout
