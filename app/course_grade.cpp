// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/batch_watch.h"
#include "app/cli_io.h"
#include "app/cli_report.h"
#include "app/stop_signals.h"
#include "core/file/file_system.h"
#include "core/file/output_json.h"
#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/lesson/grading.h"
#include "core/printable.h"
#include "core/project/validate.h"
#include "core/version.h"
#include "core/workbook/workbook.h"
#include "words/goal_words.h"
#include "words/lesson_words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <utility>
#include <vector>

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

std::string resultOf(const Lesson& lesson, std::size_t step, const GoalResult& result) {
    return GoalWording().found(lesson.steps[step].goal, result, projectOf(lesson, step), true);
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
                                  step.most, resultOf(lesson, i, step.result)});
        }
    }
    return table;
}

/// The marks of a class as a workbook: a sheet with a row for each work, and one with a row for
/// each step.
xlsx::Book gradeBook(const Lesson& lesson, const std::vector<GradedWork>& works) {
    return {lesson.title.in(false),
            {},
            std::string("Sparkout ") + version,
            {sheetOf(gradeTable(lesson, works, {flagText, "; "}), "Grades"),
             sheetOf(stepTable(lesson, works), "Steps")}};
}

using nlohmann::ordered_json;

constexpr std::size_t mostWorks = 5000;
constexpr std::size_t mostTableBytes = 8u << 20;

/// The works of a folder, sorted by name; if it cannot be read, reports it and returns an empty
/// value.
std::optional<std::vector<std::string>> worksIn(const std::string& folder) {
    std::error_code error;
    std::vector<std::string> files;
    for (std::filesystem::directory_iterator at(pathFromUtf8(folder), error), end;
         !error && at != end; at.increment(error)) {
        if (at->path().extension() == ".sparkout-work") {
            files.push_back(utf8(at->path()));
        }
    }
    if (error) {
        print(stderr, printable(folder) + ": the folder cannot be read: " + error.message() + '\n');
        return std::nullopt;
    }
    if (files.size() > mostWorks) {
        print(stderr, printable(folder) + ": there are more than " + std::to_string(mostWorks)
                          + " works\n");
        return std::nullopt;
    }
    std::sort(files.begin(), files.end());
    return files;
}

/// Each work is read when it is marked; one that cannot be read is reported and marked as
/// unreadable.
ClassWorks worksOf(const std::vector<std::string>& files) {
    return {files.size(), [&files](std::size_t i) {
                return HandedIn{utf8(pathFromUtf8(files[i]).filename()),
                                readOrSay(files[i], limits::fileBytes).value_or(std::string())};
            }};
}

/// Reads the list of students and the teacher's table, if given; false if one has faults.
bool readWish(const manual::Given& given, GradeWish& wish) {
    if (given.has("--group")) {
        auto group = loadGroup(given.text("--group"));
        if (!group) {
            return false;
        }
        wish.group = std::move(*group);
    }
    if (!given.has("--answers")) {
        return true;
    }
    const auto content = readOrSay(given.text("--answers"), mostTableBytes);
    if (!content) {
        return false;
    }
    ReadBestTable table = readBestTable(*content);
    if (table.faultLine > 0) {
        print(stderr, printable(given.text("--answers")) + ':' + std::to_string(table.faultLine)
                          + ": this is not a line of a table of best answers\n");
        return false;
    }
    wish.best = std::move(table.rows);
    return true;
}

std::string fixedMinutes(double time_min) {
    constexpr int decimals = 3;
    return fixed(time_min, decimals) + " min";
}

ordered_json stepJson(const GradedStep& step) {
    ordered_json json = {{"goal", goalKey(step.result.kind)},
                         {"finding", findingKey(step.result.finding)},
                         {"points", step.points},
                         {"most", step.most},
                         {"hints_points", step.hints},
                         {"attempts", step.attempts},
                         {"late", step.isLate},
                         {"pending", step.isPending},
                         {"value", jsonOrNull(step.result.value)},
                         {"asked", jsonOrNull(step.result.asked)}};
    if (!step.answer.text.empty()) {
        json["text"] = step.answer.text;
    }
    return json;
}

std::string gradesJson(const std::vector<GradedWork>& works) {
    ordered_json list = ordered_json::array();
    for (const GradedWork& work : works) {
        ordered_json flags = ordered_json::array(), steps = ordered_json::array();
        for (const WorkFlag flag : work.flags) {
            flags.push_back(flagKey(flag));
        }
        for (const GradedStep& step : work.steps) {
            steps.push_back(stepJson(step));
        }
        list.push_back(
            {{"file", work.file},
             {"name", work.name},
             {"group", work.group},
             {"variant", work.variant > 0 ? ordered_json(work.variant) : ordered_json(nullptr)},
             {"flags", std::move(flags)},
             {"copied_from", work.copiedFrom},
             {"untrue_runs", work.untrueRuns},
             {"points", work.points},
             {"most", work.most},
             {"pending", work.pending},
             {"time_min", jsonOrNull(work.time_min)},
             {"best_min", jsonOrNull(work.best_min)},
             {"best_over_time", jsonOrNull(work.nearness())},
             {"steps", std::move(steps)}});
    }
    return ordered_json{{"works", std::move(list)}}.dump(
               2, ' ', false,
               ordered_json::error_handler_t::replace) // a file name may contain any bytes
           + '\n';
}

std::string gradesText(const Lesson& lesson, const std::vector<GradedWork>& works) {
    std::string text;
    for (const GradedWork& work : works) {
        const std::string& name = work.name.empty() ? work.file : work.name;
        text += printable(name) + (work.group.empty() ? "" : ", " + printable(work.group))
                + (work.variant > 0 ? ", variant " + std::to_string(work.variant) : std::string())
                + ": " + numberText(work.points) + " of " + numberText(work.most) + " points";
        text += work.pending > 0 ? ", " + numberText(work.pending) + " for the teacher" : "";
        if (work.time_min) {
            text += ", " + fixedMinutes(*work.time_min);
            text += work.best_min ? " (best " + fixedMinutes(*work.best_min) + ')' : "";
        }
        text += '\n';
        for (const WorkFlag flag : work.flags) {
            text += "  ! " + std::string(flagText(flag));
            if (flag == WorkFlag::copied) {
                for (const std::string& other : work.copiedFrom) {
                    text += (&other == &work.copiedFrom.front() ? ": " : ", ") + printable(other);
                }
            }
            text += '\n';
        }
        for (std::size_t i = 0; i < work.steps.size(); ++i) {
            const GradedStep& step = work.steps[i];
            text += "  step " + std::to_string(i + 1) + "  " + numberText(step.points) + "/"
                    + numberText(step.most) + "  " + resultOf(lesson, i, step.result) + '\n';
        }
    }
    return text;
}

int sayThere(const std::string& file) {
    print(stderr, printable(file) + ": exists; --force replaces it\n");
    return refused;
}

/// Does not overwrite a file by accident, since it may contain marks edited by hand.
int saveBook(const xlsx::Book& book, const manual::Given& given) {
    const std::string bytes = xlsx::bytesOf(book);
    if (bytes.empty()) {
        print(stderr, printable(given.text("-o")) + ": the table is too long for a workbook\n");
        return refused;
    }
    SafeFileWriter file(pathFromUtf8(given.text("-o")), given.has("--force")
                                                            ? SafeFileWriter::Existing::replaced
                                                            : SafeFileWriter::Existing::refused);
    if (file.write(bytes) && file.finish()) {
        print(stdout, printable(given.text("-o")) + '\n');
        return done;
    }
    if (file.error()->systemError == EEXIST) {
        return sayThere(given.text("-o"));
    }
    print(stderr, describe(*file.error()));
    return refused;
}

} // namespace

int runCourseGrade(const manual::Given& given) {
    if (given.has("--xlsx") && pathFromUtf8(given.text("-o")).extension() != ".xlsx") {
        return usageError("-o needs a name that ends with .xlsx: " + given.text("-o"));
    }
    std::error_code ignored; // a failure is reported by the writer
    if (given.has("--xlsx") && !given.has("--force")
        && std::filesystem::exists(pathFromUtf8(given.text("-o")), ignored)) {
        return sayThere(given.text("-o")); // before the time that marking takes
    }
    const auto lesson = loadLesson(given.operands[0]);
    GradeWish wish;
    if (!lesson || !readWish(given, wish)) {
        return refused;
    }
    const auto files = worksIn(given.operands[1]);
    if (!files) {
        return refused;
    }
    if (files->empty() && wish.group.empty()) {
        print(stderr, printable(given.operands[1]) + ": there are no works\n");
        return refused;
    }
    std::vector<GradedWork> works;
    {
        BatchWatch watch(static_cast<std::int64_t>(files->size()), false, "works");
        works =
            gradeClass(*lesson, worksOf(*files), wish, watch.stop(), [&watch](std::size_t marked) {
                *watch.done() = static_cast<std::int64_t>(marked);
            });
    }
    for (const GradedWork& work : works) {
        printIssues(work.file, work.issues);
    }
    int status = done;
    if (given.has("--xlsx")) {
        status = saveBook(gradeBook(*lesson, works), given);
    } else {
        print(stdout, given.has("--json")  ? gradesJson(works)
                      : given.has("--csv") ? gradesCsv(*lesson, works)
                                           : gradesText(*lesson, works));
    }
    if (caughtSignal() == 0 || works.size() >= files->size()) {
        return status;
    }
    print(stderr, "sparkout-cli: ended after " + std::to_string(works.size()) + " of "
                      + std::to_string(files->size()) + " works\n");
    return interrupted + caughtSignal();
}

} // namespace sparkout::cli
