// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reference/lesson_schema.h"

#include "core/course/work.h"
#include "core/course/work_file.h"
#include "core/format/strict_json.h"
#include "core/lesson/lesson.h"
#include "core/lesson/lesson_file.h"
#include "core/reference/schema_parts.h"

#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

constexpr const char* gapsOfLessons =
    "The program's reader refuses all that this schema refuses, and beyond it: a goal that holds "
    "none or several of its keys, paths that name no input, figures and moments that the project "
    "does not have, texts that are missing in both languages or hold foreign tags, prices of hints "
    "above the points, and what the project's own schema leaves to the reader. "
    "sparkout-cli course check names each of them.";

/// The schema of a file: its format and version come first, with keys that are not in its table.
ordered_json fileOf(const StructInfo& table, const char* format, int version, const char* inner,
                    const char* reference) {
    const ordered_json object = objectSchema(table);
    ordered_json properties = {{"format", {{"const", format}}}, {"version", {{"const", version}}}};
    properties.update(object.at("properties"));
    properties[inner] = {{"$ref", reference}};
    ordered_json required = {"format", "version", inner};
    for (const ordered_json& key : object.value("required", ordered_json::array())) {
        required.push_back(key);
    }
    return closedObject(std::move(properties), std::move(required));
}

} // namespace

std::string lessonSchema() {
    const ordered_json ofWork = {{"properties", {{"format", {{"const", workFormat}}}}},
                                 {"required", {"format"}}};
    const ordered_json root = {
        {"$schema", "https://json-schema.org/draft/2020-12/schema"},
        {"title", "Sparkout laboratory work, of a teacher or a student"},
        {"description", gapsOfLessons},
        {"type", "object"},
        {"if", ofWork},
        {"then", {{"$ref", "#/$defs/work"}}},
        {"else", {{"$ref", "#/$defs/lesson"}}},
        {"$defs",
         {{"lesson", fileOf(tableOf<LessonSheet>(), lessonFormat, lessonVersion, "project",
                            "project.schema.json")},
          {"work",
           fileOf(tableOf<WorkSheet>(), workFormat, workVersion, "lesson", "#/$defs/lesson")}}}};
    return printJson(root);
}

} // namespace sparkout
