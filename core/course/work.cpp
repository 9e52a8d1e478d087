// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/work.h"

#include "core/format/strict_json.h"
#include "core/format/table_reader.h"
#include "core/format/table_writer.h"
#include "core/lesson/lesson_file.h"
#include "core/lesson/lesson_json.h"
#include "core/project/conditions.h"
#include "core/sha256.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

namespace sparkout {

namespace {

using nlohmann::json;
using nlohmann::ordered_json;

/// The text of an entry that its seal covers.
std::string sealedText(const WorkEntry& entry) {
    return printJson(writeByTable(tableOf<WorkEntry>(), &entry, {"sha256"}));
}

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

VariantLevels Work::variantLevels() const {
    VariantLevels whole;
    for (const double level : levels) {
        whole.push_back(static_cast<std::size_t>(level));
    }
    return whole;
}

Work newWork(const Lesson& lesson, const VariantLevels& levels,
             const std::optional<double>& best_min, int variant, std::string name,
             std::string group) {
    Work work;
    work.name = std::move(name);
    work.group = std::move(group);
    work.variant = variant;
    work.levels.assign(levels.begin(), levels.end());
    work.lesson_sha256 = lessonDigest(lesson);
    work.lesson = forStudents(withVariant(lesson, levels, best_min));
    work.sha256 = firstSeal(work);
    return work;
}

StepRecord recordOf(const Work& work, std::size_t step) {
    StepRecord record;
    const bool predicts = isPrediction(work.lesson.steps[step].goal);
    bool isSeen = false;
    const WorkEntry* counts = nullptr; // copied once: a work may have thousands
    for (const WorkEntry& entry : work.entries) {
        if (static_cast<std::size_t>(entry.step) != step + 1) {
            continue;
        }
        switch (entry.event) {
        case WorkEvent::hint:
            if (std::find(record.hints.begin(), record.hints.end(), entry.hint.value_or(0))
                == record.hints.end()) {
                record.hints.push_back(entry.hint.value_or(0));
            }
            break;
        case WorkEvent::run: isSeen = true; break;
        case WorkEvent::prediction:
            if (predicts && !counts) {
                counts = &entry;
                record.isPredictedLate = isSeen;
            }
            record.attempts += predicts ? 1 : 0;
            break;
        case WorkEvent::attempt:
            isSeen = true;
            if (!predicts) {
                counts = &entry;
                ++record.attempts;
            }
            break;
        }
    }
    if (counts) {
        record.answer = counts->answer;
        record.when = counts->when;
    }
    return record;
}

double priceOf(const LessonStep& step, const StepRecord& record) {
    double price = 0;
    for (const int hint : record.hints) {
        const auto index = static_cast<std::size_t>(hint) - 1;
        price += hint > 0 && index < step.hints.size() ? step.hints[index].price : 0;
    }
    return price;
}

template <>
std::span<const Choice> choicesOf<WorkEvent>() {
    static constexpr std::array choices{Choice{"prediction", "said before the run"},
                                        Choice{"attempt", "handed in"},
                                        Choice{"hint", "hint taken"}, Choice{"run", "run kept"}};
    return choices;
}

template <>
const StructInfo& tableOf<WorkEntry>() {
    static const std::array rows{
        SPARKOUT_FIELD(WorkEntry, event, .label = "Event", .required = conditions::always),
        SPARKOUT_FIELD(WorkEntry, step, .label = "Step", .hard = {1, 100},
                       .required = conditions::always, .hint = "Counted from 1."),
        SPARKOUT_FIELD(WorkEntry, when, .label = "When", .required = conditions::always,
                       .hint = "By the clock of the student's machine, UTC."),
        SPARKOUT_FIELD(WorkEntry, answer, .label = "Answer", .sparse = true,
                       .hint = "Of a prediction or an attempt."),
        SPARKOUT_FIELD(WorkEntry, hint, .label = "Hint", .hard = {1, 20},
                       .nullMeaning = "the entry is no hint", .hint = "Counted from 1."),
        SPARKOUT_FIELD(WorkEntry, run, .label = "Run", .nullMeaning = "the entry is no run",
                       .hint = "As a project file keeps it."),
        SPARKOUT_FIELD(WorkEntry, sha256, .label = "Seal", .required = conditions::always,
                       .hint = "SHA-256 of the seal before and of this entry."),
    };
    static const StructInfo info = makeTable<WorkEntry>("Entry", rows);
    return info;
}

template <>
const StructInfo& tableOf<WorkSheet>() {
    static const std::array rows{
        SPARKOUT_FIELD(WorkSheet, name, .label = "Student", .required = conditions::always),
        SPARKOUT_FIELD(WorkSheet, group, .label = "Group", .required = conditions::always),
        SPARKOUT_FIELD(WorkSheet, variant, .label = "Variant", .hard = {1, 1000000},
                       .required = conditions::always, .hint = "Its number."),
        SPARKOUT_FIELD(WorkSheet, levels, .label = "Levels", .hard = {0, 10000},
                       .required = conditions::always, .whole = true,
                       .hint = "Of the inputs that are varied, from 0, in their order."),
        SPARKOUT_FIELD(WorkSheet, lesson_sha256, .label = "Digest of the lesson",
                       .required = conditions::always,
                       .hint = "SHA-256 of the teacher's lesson as students may have it, without "
                               "a variant."),
        SPARKOUT_FIELD(WorkSheet, sha256, .label = "Seal", .required = conditions::always,
                       .hint = "SHA-256 of what stands above and of the lesson with its variant."),
        SPARKOUT_FIELD(WorkSheet, entries, .label = "Entries",
                       .hard = {0, static_cast<double>(limits::workEntries)},
                       .hint = "All that was handed in, in its order."),
    };
    static const StructInfo info = makeTable<WorkSheet>("Work", rows);
    return info;
}

std::string lessonDigest(const Lesson& lesson) {
    return sha256(writeLesson(forStudents(lesson)));
}

std::string variantDigest(const Lesson& issued) {
    return sha256(writeLesson(issued));
}

std::string firstSeal(const Work& work) {
    const auto* sheet = static_cast<const WorkSheet*>(&work);
    return sha256(printJson(writeByTable(tableOf<WorkSheet>(), sheet, {"sha256", "entries"}))
                  + variantDigest(work.lesson));
}

std::string nextSeal(const std::string& before, const WorkEntry& entry) {
    return sha256(before + '\n' + sealedText(entry));
}

void addEntry(Work& work, WorkEntry entry) {
    const std::string& before = work.entries.empty() ? work.sha256 : work.entries.back().sha256;
    entry.sha256 = nextSeal(before, entry);
    work.entries.push_back(std::move(entry));
}

std::optional<std::size_t> brokenSeal(const Work& work) {
    if (work.sha256 != firstSeal(work)) {
        return 0;
    }
    const std::string* before = &work.sha256;
    for (std::size_t i = 0; i < work.entries.size(); ++i) {
        if (work.entries[i].sha256 != nextSeal(*before, work.entries[i])) {
            return i + 1;
        }
        before = &work.entries[i].sha256;
    }
    return std::nullopt;
}

std::string contentDigest(const Work& work) {
    std::string all;
    for (const WorkEntry& entry : work.entries) {
        all += sealedText(entry);
    }
    return all.empty() ? all : sha256(all);
}

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
