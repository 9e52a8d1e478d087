// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/work_file.h"

#include "core/format/strict_json.h"
#include "core/format/table_reader.h"
#include "core/format/table_writer.h"
#include "core/lesson/lesson_json.h"

#include <cmath>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

constexpr const char* lessonKey = "lesson";

/// Faults of a work besides its keys and ranges: entries with missing steps and hints.
void checkEntries(const Work& work, Issues& issues) {
    const auto steps = static_cast<double>(work.lesson.steps.size());
    for (std::size_t i = 0; i < work.levels.size(); ++i) {
        if (work.levels[i] != std::floor(work.levels[i])) {
            addIssue(issues, {IssueCode::wrongType, Severity::error, "/levels/" + std::to_string(i),
                              Amount{work.levels[i]}, Phrase::wholeNumber});
        }
    }
    for (std::size_t i = 0; i < work.entries.size(); ++i) {
        const WorkEntry& entry = work.entries[i];
        const std::string path = "/entries/" + std::to_string(i);
        if (entry.step > steps) {
            addIssue(issues, {IssueCode::outOfRange, Severity::error, path + "/step",
                              Count{entry.step}, Bounds{{1, steps}}});
            continue;
        }
        const LessonStep& step = work.lesson.steps[static_cast<std::size_t>(entry.step) - 1];
        const auto hints = static_cast<double>(step.hints.size());
        if (entry.event == WorkEvent::hint && !entry.hint) {
            addIssue(
                issues,
                {IssueCode::missingKey, Severity::error, path + "/hint", {}, Bounds{{1, hints}}});
        } else if (entry.event == WorkEvent::hint && *entry.hint > hints) {
            addIssue(issues, {IssueCode::outOfRange, Severity::error, path + "/hint",
                              Count{*entry.hint}, Bounds{{1, hints}}});
        } else if (entry.event == WorkEvent::run && !entry.run) {
            addIssue(issues,
                     {IssueCode::missingKey, Severity::error, path + "/run", {}, Phrase::object});
        }
    }
}

ReadWork readWorkJson(const json& root, Issues found, const std::stop_token& stop) {
    ReadWork read{std::nullopt, std::move(found)};
    Issues& issues = read.issues;
    if (const Issues header = checkFileHeader(root, workFormat, workVersion); !header.empty()) {
        issues.insert(issues.end(), header.begin(), header.end());
        return read;
    }
    Work work;
    readStruct(root, tableOf<WorkSheet>(), static_cast<WorkSheet*>(&work), {}, issues,
               {"format", "version", lessonKey});
    const std::string path = std::string("/") + lessonKey;
    const auto lesson = root.find(lessonKey);
    if (lesson == root.end()) {
        addIssue(issues, {IssueCode::missingKey, Severity::error, path, {}, Phrase::object});
        return read;
    }
    ReadLesson inner = readLessonJson(*lesson, LessonOf::student, {}, stop);
    for (Issue& issue : inner.issues) {
        issue.path = path + issue.path;
        addIssue(issues, std::move(issue));
    }
    if (stop.stop_requested() || !inner.lesson || hasErrors(issues)) {
        return read;
    }
    work.lesson = std::move(*inner.lesson);
    Issues faults;
    checkEntries(work, faults);
    if (faults.empty()) {
        read.work = std::move(work);
    } else { // placed before warnings, since the list may be full
        issues.insert(issues.begin(), faults.begin(), faults.end());
        issues.resize(std::min(issues.size(), limits::issues));
    }
    return read;
}

} // namespace

ReadWork readWork(std::string_view text, const std::stop_token& stop) {
    Issues issues;
    const auto root = parseStrictly(text, issues, stop);
    if (!root || stop.stop_requested()) {
        return {std::nullopt, stop.stop_requested() ? Issues() : std::move(issues)};
    }
    return readWorkJson(*root, std::move(issues), stop);
}

std::string writeWork(const Work& work) {
    ordered_json root = {{"format", workFormat}, {"version", workVersion}};
    root.update(writeByTable(tableOf<WorkSheet>(), static_cast<const WorkSheet*>(&work)));
    root[lessonKey] = lessonJson(work.lesson);
    return printJson(root);
}

} // namespace sparkout
