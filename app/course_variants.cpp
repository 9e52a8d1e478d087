// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/batch_watch.h"
#include "app/cli_io.h"
#include "app/stop_signals.h"
#include "core/file/file_system.h"
#include "core/lesson/best_table.h"
#include "core/lesson/make_variants.h"
#include "core/lesson/work.h"
#include "core/printable.h"
#include "words/lesson_words.h"

#include <cstdint>
#include <filesystem>
#include <utility>

namespace sparkout::cli {

namespace {

constexpr const char* assignmentsName = "assignments.csv";
constexpr const char* bestName = "teacher-best-answers.csv";

/// Prints how many of the tries each condition refused.
void printRefused(const std::string& file, const MadeVariants& made, std::size_t wanted) {
    print(stderr, printable(file) + ": only " + std::to_string(made.variants.size()) + " of "
                      + std::to_string(wanted) + " variants were found in "
                      + std::to_string(made.tries) + " tries; nothing was written\n");
    for (std::size_t i = 0; i < variantFaults; ++i) {
        if (made.refused[i] > 0) {
            print(stderr, "  " + std::to_string(made.refused[i]) + " refused: "
                              + variantFaultText(static_cast<VariantFault>(i)) + '\n');
        }
    }
}

struct OutputFile {
    std::string path, content;
};

std::vector<OutputFile> outputs(const Lesson& lesson, const MadeVariants& made,
                                const std::vector<Student>& students, const std::string& folder) {
    std::vector<Work> works;
    for (std::size_t i = 0; i < students.size(); ++i) {
        const MadeVariant& variant = made.variants[i];
        works.push_back(newWork(lesson, variant.levels,
                                variant.best ? std::optional(variant.best->time_min) : std::nullopt,
                                static_cast<int>(i) + 1, students[i].name, students[i].group));
    }
    std::vector<OutputFile> files;
    for (std::size_t i = 0; i < works.size(); ++i) {
        files.push_back({folder + '/' + workFileName(works[i], i + 1), writeWork(works[i])});
    }
    files.push_back({folder + '/' + assignmentsName, assignmentsCsv(lesson, works)});
    files.push_back({folder + '/' + bestName, bestTableCsv(lesson, works, made.variants)});
    return files;
}

/// Does not overwrite files by accident, since they may be works that were handed in.
int writeAll(const std::vector<OutputFile>& files, const manual::Given& given) {
    std::error_code error; // a folder that cannot be made is reported by the first file
    std::filesystem::create_directory(pathFromUtf8(given.text("-d")), error);
    bool stands = false;
    for (const OutputFile& file : files) {
        if (!given.has("--force") && std::filesystem::exists(pathFromUtf8(file.path), error)) {
            print(stderr, printable(file.path) + ": exists and is kept\n");
            stands = true;
        }
    }
    if (stands) {
        print(stderr, "sparkout-cli: nothing was written; --force replaces these files\n");
        return refused;
    }
    for (const OutputFile& file : files) {
        if (const int failed = save(file.path, file.content)) {
            return failed;
        }
        print(stdout, printable(file.path) + '\n');
    }
    return done;
}

} // namespace

int runCourseVariants(const manual::Given& given) {
    const std::string& file = given.operands.front();
    const auto lesson = loadLesson(file);
    const auto students = lesson ? loadGroup(given.text("--group")) : std::nullopt;
    if (!students) {
        return refused;
    }
    MadeVariants made;
    {
        BatchWatch watch(static_cast<std::int64_t>(students->size()), false, "variants");
        made = makeVariants(*lesson, students->size(),
                            static_cast<std::uint32_t>(*given.integer("--seed")), watch.stop(),
                            [&watch](const VariantTry& tried) {
                                *watch.done() = static_cast<std::int64_t>(tried.made);
                            });
    }
    if (caughtSignal() != 0) {
        return interrupted + caughtSignal();
    }
    if (made.fault != LessonFault::none) {
        print(stderr, printable(file) + ": " + lessonFaultText(made.fault) + '\n');
        return made.fault == LessonFault::noGrid ? refused : nothingFeasible;
    }
    if (made.variants.size() < students->size()) {
        printRefused(file, made, students->size());
        return nothingFeasible;
    }
    return writeAll(outputs(*lesson, made, *students, given.text("-d")), given);
}

} // namespace sparkout::cli
