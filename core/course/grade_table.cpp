// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/grade_table.h"

#include "core/tables/csv_line.h"

#include <utility>

namespace sparkout {

namespace {

constexpr int minuteDecimals = 3, ratioDecimals = 3;

template <typename Texts>
std::string joined(const Texts& texts, const char* separator) {
    std::string all;
    for (const std::string& text : texts) {
        all += (all.empty() ? "" : separator) + text;
    }
    return all;
}

GradeCell orEmpty(const std::optional<double>& value) {
    return value ? GradeCell(*value) : GradeCell();
}

std::vector<GradeColumn> columnsFor(const Lesson& lesson) {
    constexpr int points = GradeColumn::asGiven;
    std::vector<GradeColumn> columns{{"file", "file"},     {"name", "name"},
                                     {"group", "group"},   {"variant", "variant"},
                                     {"flags", "remarks"}, {"copied_from", "copied from"}};
    for (std::size_t i = 1; i <= lesson.steps.size(); ++i) {
        const std::string number = std::to_string(i);
        columns.push_back({"step_" + number + "_points", "step " + number, points});
    }
    const GradeColumn last[] = {{"points", "points", points},
                                {"most", "most", points},
                                {"pending", "to be marked", points},
                                {"attempts", "attempts"},
                                {"hints_points", "points for hints", points},
                                {"time_min", "time, min", minuteDecimals},
                                {"best_min", "best time, min", minuteDecimals},
                                {"best_over_time", "best / time", ratioDecimals}};
    columns.insert(columns.end(), std::begin(last), std::end(last));
    return columns;
}

std::vector<GradeCell> rowOf(const GradedWork& work, std::size_t steps, FlagStyle style) {
    std::vector<std::string> flags;
    for (const WorkFlag flag : work.flags) {
        flags.emplace_back(style.word(flag));
    }
    std::vector<GradeCell> row{work.file,
                               work.name,
                               work.group,
                               work.variant > 0 ? GradeCell(work.variant) : GradeCell(),
                               joined(flags, style.separator),
                               joined(work.copiedFrom, "; ")};
    int attempts = 0;
    double hints = 0;
    for (std::size_t i = 0; i < steps; ++i) {
        const bool isMarked = i < work.steps.size();
        row.push_back(isMarked ? GradeCell(work.steps[i].points) : GradeCell());
        attempts += isMarked ? work.steps[i].attempts : 0;
        hints += isMarked ? work.steps[i].hints : 0;
    }
    row.insert(row.end(),
               {work.points, work.most, work.pending, attempts, hints, orEmpty(work.time_min),
                orEmpty(work.best_min), orEmpty(work.nearness())});
    return row;
}

void addCell(CsvLine& line, const GradeCell& cell) {
    if (const auto* text = std::get_if<std::string>(&cell)) {
        line.text(*text);
    } else if (const auto* count = std::get_if<int>(&cell)) {
        line.whole(*count);
    } else if (const auto* number = std::get_if<double>(&cell)) {
        line.number(*number);
    } else {
        line.empty();
    }
}

} // namespace

GradeTable gradeTable(const Lesson& lesson, const std::vector<GradedWork>& works, FlagStyle flags) {
    GradeTable table{columnsFor(lesson), {}};
    for (const GradedWork& work : works) {
        table.rows.push_back(rowOf(work, lesson.steps.size(), flags));
    }
    return table;
}

std::string gradesCsv(const Lesson& lesson, const std::vector<GradedWork>& works) {
    const GradeTable table = gradeTable(lesson, works);
    CsvLine line;
    for (const GradeColumn& column : table.columns) {
        line.text(column.key);
    }
    std::string text = line.end();
    for (const auto& row : table.rows) {
        for (const GradeCell& cell : row) {
            addCell(line, cell);
        }
        text += line.end();
    }
    return text;
}

} // namespace sparkout
