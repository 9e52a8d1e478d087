// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/work_seal.h"

#include "core/format/strict_json.h"
#include "core/format/table_writer.h"
#include "core/lesson/lesson_file.h"
#include "core/sha256.h"

#include <utility>

namespace sparkout {

namespace {

/// The text of an entry that its seal covers.
std::string sealedText(const WorkEntry& entry) {
    return printJson(writeByTable(tableOf<WorkEntry>(), &entry, {"sha256"}));
}

} // namespace

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

} // namespace sparkout
