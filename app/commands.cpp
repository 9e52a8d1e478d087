// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/cli_io.h"
#include "core/file/project_file.h"
#include "core/lesson/lesson_file.h"
#include "core/printable.h"
#include "words/lesson_words.h"

#include <utility>

namespace sparkout::cli {

std::optional<Lesson> loadLesson(const std::string& file) {
    const auto content = readOrSay(file, limits::fileBytes);
    if (!content) {
        return std::nullopt;
    }
    ReadLesson read = readLesson(*content);
    printIssues(file, read.issues);
    return std::move(read.lesson);
}

std::optional<std::vector<Student>> loadGroup(const std::string& file) {
    const auto content = readOrSay(file, limits::groupBytes);
    if (!content) {
        return std::nullopt;
    }
    GroupList list = readGroup(*content);
    for (const GroupFault& fault : list.faults) {
        print(stderr, printable(file) + (fault.line > 0 ? ':' + std::to_string(fault.line) : "")
                          + ": " + (fault.name.empty() ? "" : printable(fault.name) + ": ")
                          + groupFaultText(fault.kind) + '\n');
    }
    return list.faults.empty() ? std::optional(std::move(list.students)) : std::nullopt;
}

} // namespace sparkout::cli
