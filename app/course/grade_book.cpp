// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/course/grade_book.h"

#include "core/course/grade_table.h"
#include "core/printable.h"
#include "core/version.h"
#include "words/lesson_words.h"

#include <cmath>
#include <memory>
#include <utility>

namespace sparkout::cli {

namespace {

constexpr int mostDecimals = 3; ///< greatest number of decimals of points

/// The number of decimals in a column.
int digitsOf(const GradeTable& table, std::size_t column) {
    constexpr double tolerance = 1e-6;
    int decimals = 0;
    for (const auto& row : table.rows) {
        const auto* number = std::get_if<double>(&row[column]);
        const auto isShown = [&] {
            const double scaled = *number * std::pow(10, decimals);
            return std::abs(scaled - std::round(scaled)) < tolerance;
        };
        while (number && decimals < mostDecimals && !isShown()) {
            ++decimals;
        }
    }
    return decimals;
}

xlsx::Cell asCell(const GradeCell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) {
        return printable(*text);
    }
    const auto* count = std::get_if<int>(&cell);
    const auto* number = std::get_if<double>(&cell);
    return count    ? xlsx::Cell(static_cast<double>(*count))
           : number ? xlsx::Cell(*number)
                    : xlsx::Cell();
}

xlsx::Sheet sheetOf(GradeTable given, const char* name) {
    xlsx::Sheet sheet{name, {}, given.rows.size()};
    for (std::size_t i = 0; i < given.columns.size(); ++i) {
        const GradeColumn& column = given.columns[i];
        sheet.columns.push_back(
            {column.title,
             {},
             column.decimals == GradeColumn::asGiven ? digitsOf(given, i) : column.decimals});
    }
    sheet.fill = [table = std::make_shared<const GradeTable>(std::move(given))](
                     std::size_t row, std::vector<xlsx::Cell>& cells) {
        for (std::size_t i = 0; i < cells.size(); ++i) {
            cells[i] = asCell(table->rows[row][i]);
        }
    };
    return sheet;
}

/// The results of each step, as they are printed.
GradeTable stepTable(const Lesson& lesson, const std::vector<GradedWork>& works) {
    constexpr int points = GradeColumn::asGiven;
    GradeTable table{{{"file", "file"},
                      {"name", "name"},
                      {"step", "step"},
                      {"points", "points", points},
                      {"most", "most", points},
                      {"found", "found"}},
                     {}};
    for (const GradedWork& work : works) {
        for (std::size_t i = 0; i < work.steps.size(); ++i) {
            const GradedStep& step = work.steps[i];
            table.rows.push_back({work.file, work.name, static_cast<int>(i) + 1, step.points,
                                  step.most, goalSentence(lesson.steps[i].goal, step.result)});
        }
    }
    return table;
}

} // namespace

xlsx::Book gradeBook(const Lesson& lesson, const std::vector<GradedWork>& works) {
    return {lesson.title.in(false),
            {},
            std::string("Sparkout ") + version,
            {sheetOf(gradeTable(lesson, works, {flagText, "; "}), "Grades"),
             sheetOf(stepTable(lesson, works), "Steps")}};
}

} // namespace sparkout::cli
