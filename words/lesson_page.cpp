// SPDX-License-Identifier: GPL-3.0-or-later
#include "words/lesson_page.h"

#include "core/file/strict_json.h"
#include "core/lesson/figure.h"
#include "core/lesson/lesson.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/text_markup.h"
#include "core/lesson/work.h"
#include "words/json_schema.h"
#include "words/reference_page.h"

#include <utility>

namespace sparkout {

namespace {

using nlohmann::ordered_json;

constexpr const char* lessonIntroduction =
    R"(<!-- Made from the tables of the core by sparkout-reference: do not edit. -->

# The lesson file

A laboratory work is one UTF-8 JSON file with the extension `.sparkout-lesson`. It begins with
`"format": "sparkout-lesson"` and `"version": 1`; `"project"` holds the project that it begins with,
as a project file of either version has it; the keys below follow in any order. It is read as strictly
as a project file: an unknown key, a wrong type, a value outside its range, a path that names no input
and a figure that the project does not have are errors that name the place.

`lesson.schema.json`, in the folder above this page, says the same to editors and programs.

A goal holds exactly one of its keys. Inputs are named by their paths in a project file.

A student's work, described below, holds the lesson without `variants` and `guide`, without what says
which options are right, and without kept runs and measurements.
)";

const char* scopeText(FigureScope scope) {
    switch (scope) {
    case FigureScope::cycle: return "the cycle";
    case FigureScope::stage: return "a stage";
    case FigureScope::place: return "a zone or section";
    case FigureScope::step:
        return "a double stroke or revolution, or one of its steps, in a zone or section";
    case FigureScope::batch: return "the batch";
    case FigureScope::batchPlace: return "a zone or section, over the batch";
    case FigureScope::search: return "the search";
    }
    return "";
}

void addFigures(std::string& text) {
    text += "\n## Figures\n\nQuantities that a goal may ask for. Where strips stay uncut, figures "
            "of the surface are not known.\n\n| name | meaning | unit | of | of the surface |\n| "
            "--- | --- | --- | --- | --- |\n";
    for (int i = 0; i < static_cast<int>(FigureName::count_); ++i) {
        const FigureRow& row = rowOf(static_cast<FigureName>(i));
        text += "| `" + std::string(row.choice.key) + "` | " + row.choice.label + " | "
                + (*row.unit ? std::string(row.unit) + ' ' : std::string()) + "| "
                + scopeText(row.scope) + " | " + (row.ofSurface ? "yes " : "") + "|\n";
    }
}

std::string sizeText(const char* what, const TextSize& most) {
    return std::string(what) + " has at most " + std::to_string(most.bytes) + " bytes and "
           + std::to_string(most.tags) + " tags";
}

constexpr const char* gapsOfLessons =
    "The program refuses everything that this schema refuses, and also: a goal with none or "
    "several of its keys, paths that name no input, figures and moments that the project does not "
    "have, texts that are missing in both languages or contain foreign tags, prices of hints above "
    "the points, and whatever the project's own schema leaves to the reader. sparkout-cli course "
    "check names each of them.";

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

std::string lessonPage() {
    TablePage page;
    page.text = lessonIntroduction;
    page.text += "\nTexts may have the tags";
    for (const char* tag : textTags()) {
        page.text += " `" + std::string(tag) + '`';
    }
    page.text += ", without attributes but `<p class=\"formula\">`, at most "
                 + std::to_string(limits::lessonTagDepth) + " within one another. In each language "
                 + sizeText("a title", limits::lessonTitle) + ", "
                 + sizeText("the aim, a hint or an option", limits::lessonLine) + ", "
                 + sizeText("any other text", limits::lessonText) + ".\n";
    page.addStruct(tableOf<LessonSheet>(), {});
    addFigures(page.text);
    page.text +=
        "\n# The work of a student\n\nA file `.sparkout-work`, which begins with `\"format\": "
        "\"sparkout-work\"` and `\"version\": 1`; `\"lesson\"` holds the lesson with the student's "
        "variant. Seals distinguish a work edited by hand from an unedited one; they contain no "
        "secret, so marking computes every answer again.\n";
    page.addStruct(tableOf<WorkSheet>(), {});
    return std::move(page.text);
}

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
