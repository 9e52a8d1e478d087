// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson_file.h"
#include "core/study/search.h"
#include "tests/core/support/project_samples.h"

#include <string>
#include <vector>

/// The shipped lessons, and what tests make of them.
namespace sparkout::samples {

inline std::vector<std::filesystem::path> lessonFiles() {
    std::vector<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(sourcePath("resources/lessons"))) {
        if (entry.path().extension() == ".sparkout-lesson") {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Work 2, with every kind of goal but the requirements.
inline std::string lessonText() {
    return readText(sourcePath("resources/lessons/02-actual-feed.sparkout-lesson"));
}
inline json lessonJsonOf() {
    return json::parse(lessonText());
}
inline Lesson lesson() {
    return readLesson(lessonText()).lesson.value();
}
inline Lesson lessonOf(const json& file) {
    return readLesson(file.dump()).lesson.value();
}

/// A project with the best of its grid, or where a goal is for every stock the best that holds so.
inline Project solving(const Project& best, const Goal& goal) {
    if (!goal.requirements || !goal.requirements->every_stock) {
        return best;
    }
    Project searched = best;
    searched.optimisation->scenarios = OptimisationScenarios::stocks;
    const SearchOutcomePtr found = search(searched, {});
    return found->answer() ? withFound(best, *found->answer()) : best;
}

/// What a reader must do with any text of a lesson; empty when it does.
inline std::string faultOfLesson(const ReadLesson& read) {
    if (read.lesson.has_value() == hasErrors(read.issues)) {
        return "a lesson with errors, or none without";
    }
    if (read.issues.size() > limits::issues) {
        return "too many issues";
    }
    for (const Issue& issue : read.issues) {
        const std::string sentence = issueSentence(issue);
        if (sentence.empty() || sentence.size() > 2000 || issue.path.size() > 5000) {
            return "no readable sentence";
        }
    }
    if (read.lesson) {
        const std::string text = writeLesson(*read.lesson);
        const ReadLesson again = readLesson(text);
        if (!again.lesson || writeLesson(*again.lesson) != text) {
            return "does not round-trip";
        }
    }
    return {};
}

} // namespace sparkout::samples
