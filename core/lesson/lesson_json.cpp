// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/lesson_json.h"

#include "core/file/strict_json.h"
#include "core/file/struct_json.h"
#include "core/setup/setup_file.h"

#include <algorithm>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* projectKey = "project";

/// The set-up below "/project"; empty if it has errors.
std::optional<Setup> readBase(const json& root, Issues& issues, const std::stop_token& stop) {
    const std::string path = std::string("/") + projectKey;
    const auto found = root.find(projectKey);
    if (found == root.end()) {
        addIssue(issues, {IssueCode::missingKey, Severity::error, path, {}, Phrase::object});
        return std::nullopt;
    }
    if (!found->is_object()) {
        addIssue(issues,
                 {IssueCode::wrongType, Severity::error, path, quoted(*found), Phrase::object});
        return std::nullopt;
    }
    ReadSetup read = readSetup(found->dump(), stop);
    for (Issue& issue : read.issues) {
        issue.path = path + issue.path;
        addIssue(issues, std::move(issue));
    }
    return std::move(read.setup);
}

} // namespace

ReadLesson readLessonJson(const json& root, LessonOf of, Issues found,
                          const std::stop_token& stop) {
    ReadLesson read{std::nullopt, std::move(found)};
    Issues& issues = read.issues;
    if (const Issues header = checkFileHeader(root, lessonFormat, lessonVersion); !header.empty()) {
        issues.insert(issues.end(), header.begin(), header.end());
        return read;
    }
    Lesson lesson;
    readStruct(root, tableOf<LessonSheet>(), static_cast<LessonSheet*>(&lesson), {}, issues,
               {"format", "version", projectKey});
    auto base = readBase(root, issues, stop);
    if (stop.stop_requested()) {
        return {};
    }
    if (!base || hasErrors(issues)) {
        return read;
    }
    lesson.base = std::move(*base);
    const Issues faults = checkLesson(lesson, of);
    if (faults.empty()) {
        read.lesson = std::move(lesson);
    } else { // placed before warnings, since the list may be full
        issues.insert(issues.begin(), faults.begin(), faults.end());
        issues.resize(std::min(issues.size(), limits::issues));
    }
    return read;
}

ordered_json lessonJson(const Lesson& lesson) {
    ordered_json root = {{"format", lessonFormat}, {"version", lessonVersion}};
    root.update(writeByTable(tableOf<LessonSheet>(), static_cast<const LessonSheet*>(&lesson)));
    root[projectKey] = ordered_json::parse(writeSetup(lesson.base));
    return root;
}

} // namespace sparkout
