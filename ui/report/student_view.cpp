// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/report/student_view.h"

#include "core/project/member.h"
#include "ui/report/cell_text.h"
#include "ui/results/run_table.h"
#include "ui/text/number_text.h"

#include <algorithm>
#include <variant>

namespace sparkout::report {

namespace {

/// Columns of inputTable().
struct InputColumn {
    static constexpr std::size_t what = 0, symbol = 1, unit = 2, value = 3, key = 4;
};

/// Entries that no student's work changes or needs: entries besides the inputs, ranges of the
/// machine, and the search.
bool isBeside(std::string_view path) {
    return path == "/part/name" || path == "/title" || path == "/author" || path == "/notes"
           || path.starts_with("/machine/limits") || path.starts_with("/optimisation")
           || path.starts_with("/batch") || path.starts_with("/sweep")
           || path.starts_with("/part/tolerance") || path == "/part/radii_per_section";
}

} // namespace

StudentView::StudentView(const Lesson& lesson) : m_lesson(forStudents(lesson)) {}

bool StudentView::hides(std::string_view path) const {
    return std::ranges::any_of(m_lesson.steps, [path](const LessonStep& step) {
        return accessTo(step, path) == Access::hidden;
    });
}

bool StudentView::hidesAnyOf(std::string_view group) const {
    const Project& project = m_lesson.base.surfaces.front().project;
    const auto leaves = leavesOf(tableOf<Project>(), &project);
    return hides(group) || std::ranges::any_of(leaves, [&](const Leaf& leaf) {
               return leaf.path.starts_with(group) && hides(leaf.path);
           });
}

bool StudentView::hides(std::size_t step, Hideable thing) const {
    const auto& hidden = m_lesson.steps[step].hidden;
    return std::ranges::any_of(hidden, [thing](const HiddenThing& h) { return h.name == thing; });
}

QString StudentView::cellOf(const CsvCell& of) {
    if (const double* number = std::get_if<double>(&of)) {
        return printedNumber(*number);
    }
    const QString* text = std::get_if<QString>(&of);
    return cell(text ? manyLines(*text).simplified() : QString());
}

Table StudentView::inputs(const Project& project) const {
    Table table;
    table.head = {tr("Symbol"), tr("Input"), tr("Value"), tr("Unit")};
    table.texts = {true, true, false, true};
    table.symbols = true;
    for (const auto& row : inputTable(project).rows) {
        const std::string path = std::get<QString>(row[InputColumn::key]).toStdString();
        const QString unit = StudentView::cellOf(row[InputColumn::unit]);
        const QString value = StudentView::cellOf(row[InputColumn::value]);
        const bool isGiven =
            value != u"–"
            && (unit == u"–" || std::holds_alternative<double>(row[InputColumn::value]));
        if (isGiven && !hides(path) && !isBeside(path)) {
            table.rows.push_back(
                {cellOf(row[InputColumn::symbol]), cellOf(row[InputColumn::what]), value, unit});
        }
    }
    return table;
}

std::vector<std::size_t> StudentView::unpredicted(const Work& work) {
    std::vector<std::size_t> steps;
    for (std::size_t i = 0; i < work.lesson.steps.size(); ++i) {
        if (isPrediction(work.lesson.steps[i].goal) && !recordOf(work, i).answer) {
            steps.push_back(i);
        }
    }
    return steps;
}

} // namespace sparkout::report
