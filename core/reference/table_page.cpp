// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reference/table_page.h"

#include "core/format/strict_json.h"
#include "core/format/table_writer.h"
#include "core/project/validate.h"
#include "core/reference/reference_page.h"

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

} // namespace sparkout
