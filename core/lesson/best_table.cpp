// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/best_table.h"

#include "core/file/csv_line.h"
#include "core/file/text_table.h"
#include "core/lesson/goal_check.h"
#include "core/project/cycle.h"
#include "core/project/validate.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <utility>

namespace sparkout {

namespace {

constexpr const char* forTeacher = "For the teacher only: best answers, not for students";
constexpr std::array keyColumns{"variant",    "name",          "group",
                                "levels",     "best_time_min", "best_margin_percent",
                                "best_cycle", "digest"};
constexpr std::size_t readColumns = 8;

/// The heading of a varied input's column.
std::string headingOf(const VariedInput& input) {
    return !input.path.empty()  ? input.path
           : input.sets.empty() ? std::string("set")
                                : input.sets.front().values.front().path;
}

std::string numberOr(const std::optional<double>& value) {
    return value ? numberText(*value) : std::string();
}

std::string levelsText(const VariantLevels& levels) {
    std::string text;
    for (const std::size_t level : levels) {
        text += (text.empty() ? "" : " ") + std::to_string(level);
    }
    return text;
}

std::string cycleText(const Project& project) {
    std::string text;
    for (const Stage& stage : project.cycle->stages) {
        text += text.empty() ? "" : "; ";
        for (const StageFeed& feed : project.operation->feeds) {
            if (const auto& value = stage.*feed.value) {
                text += std::string(feed.key) + ' ' + numberText(*value) + ' ';
            }
        }
        text += "stock_mm " + numberText(stage.stock_mm);
        if (const auto steps = stage.sparkOutSteps()) {
            text += std::string(" ") + Stage::sparkOutKey + ' ' + std::to_string(*steps);
        }
    }
    return text;
}

/// The engine's answer to a step of a variant as given.
std::string engineAnswer(const Lesson& lesson, std::size_t step) {
    const Goal& goal = lesson.steps[step].goal;
    std::string text;
    if (goal.choice) {
        for (std::size_t i = 0; i < goal.choice->options.size(); ++i) {
            if (goal.choice->options[i].right) {
                text += (text.empty() ? "" : " ") + std::to_string(i + 1);
            }
        }
        return text;
    }
    if (goal.time) {
        return "<= " + numberOr(goal.time->below_min) + " min";
    }
    if (!isAnsweredByEngine(goal.kind())) {
        return goal.figure ? numberText(goal.figure->value) : std::string();
    }
    const GoalResult result = checkStep(lesson, step, {});
    const Project& project =
        lesson.base.surfaces[static_cast<std::size_t>(lesson.steps[step].surface) - 1].project;
    if (goal.order) {
        for (const std::size_t place : result.order) {
            const PlaceName name = placeName(project, place);
            text +=
                (text.empty() ? "" : " > ")
                + (name.zone ? std::string(PlaceName::words()[place].key) : std::to_string(place));
        }
        return text;
    }
    if (goal.curve) {
        for (const ComparedPoint& point : result.curve) {
            text +=
                (text.empty() ? "" : "; ") + numberText(point.at) + ": " + numberText(point.value);
        }
        return text;
    }
    return numberOr(result.value);
}

std::optional<int> wholeIn(std::string_view cell) {
    int value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return error == std::errc() && end == cell.data() + cell.size() ? std::optional(value)
                                                                    : std::nullopt;
}

bool isHeadings(const std::vector<std::string_view>& cells) {
    return cells.size() >= readColumns
           && std::equal(keyColumns.begin(), keyColumns.end(), cells.begin());
}

/// The delimiter with which the headings appear in one of the first rows; the first row names the
/// lesson.
std::optional<char> delimiterOf(std::string_view text) {
    constexpr int firstRows = 3;
    for (const char delimiter : {',', ';', '\t'}) {
        TableReader rows(text, delimiter);
        for (int row = 0; row < firstRows && rows.next(); ++row) {
            if (isHeadings(rows.cells())) {
                return delimiter;
            }
        }
    }
    return std::nullopt;
}

std::optional<VariantLevels> levelsIn(std::string_view cell) {
    VariantLevels levels;
    while (!cell.empty()) {
        const std::size_t space = cell.find(' ');
        const auto level = wholeIn(cell.substr(0, space));
        if (!level || *level < 0) {
            return std::nullopt;
        }
        levels.push_back(static_cast<std::size_t>(*level));
        cell = space == std::string_view::npos ? std::string_view() : cell.substr(space + 1);
    }
    return levels;
}

} // namespace

std::string assignmentsCsv(const Lesson& lesson, const std::vector<Work>& works) {
    const std::vector<VariedInput> inputs =
        lesson.variants ? lesson.variants->inputs : std::vector<VariedInput>();
    CsvLine line;
    line.text("variant").text("name").text("group");
    for (const VariedInput& input : inputs) {
        line.text(headingOf(input));
    }
    std::string text = line.end();
    for (const Work& work : works) {
        line.whole(work.variant).text(work.name).text(work.group);
        const VariantLevels levels = work.variantLevels();
        for (std::size_t i = 0; i < levels.size(); ++i) {
            if (inputs[i].sets.empty()) {
                line.number(*inputs[i].valuesAt(levels[i]).front().number);
            } else {
                line.text(inputs[i].nameOf(levels[i]));
            }
        }
        text += line.end();
    }
    return text;
}

std::string bestTableCsv(const Lesson& lesson, const std::vector<Work>& works,
                         const std::vector<MadeVariant>& variants) {
    CsvLine line;
    std::string text = line.text(forTeacher).text(lesson.title.in(false)).end();
    for (const char* const key : keyColumns) {
        line.text(key);
    }
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        line.text("step " + std::to_string(i + 1) + " (" + goalKey(lesson.steps[i].goal.kind())
                  + ")");
    }
    text += line.end();
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    for (std::size_t i = 0; i < works.size(); ++i) {
        const Work& work = works[i];
        const auto& best = variants[i].best;
        const auto best_min = best ? std::optional(best->time_min) : std::nullopt;
        line.whole(work.variant).text(work.name).text(work.group);
        line.text(levelsText(variants[i].levels)).number(best_min.value_or(none));
        line.number(best ? best->margin_percent : none);
        line.text(best ? cycleText(best->project) : std::string());
        line.text(variantDigest(work.lesson));
        const Lesson marked = withVariant(lesson, variants[i].levels, best_min);
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            line.text(engineAnswer(marked, step));
        }
        text += line.end();
    }
    return text;
}

ReadBestTable readBestTable(const TableText& table) {
    ReadBestTable read;
    const std::optional<char> delimiter = delimiterOf(table.utf8());
    if (!delimiter) {
        read.faultLine = 1;
        return read;
    }
    TableReader rows(table.utf8(), *delimiter);
    while (rows.next() && !isHeadings(rows.cells())) {
    }
    while (rows.next()) {
        const std::vector<std::string_view>& cells = rows.cells();
        if (rows.isEmpty()) {
            continue;
        }
        const auto variant = cells.size() < readColumns ? std::nullopt : wholeIn(cells[0]);
        const auto levels = variant ? levelsIn(cells[3]) : std::nullopt;
        if (!levels) {
            read.faultLine = rows.line();
            return read;
        }
        const auto number = [](std::string_view cell) {
            const auto plain = cellNumber(cell, '.');
            return plain ? plain : cellNumber(cell, ',');
        };
        read.rows.push_back({*variant, std::string(cells[1]), std::string(cells[2]), *levels,
                             number(cells[4]), number(cells[5]), std::string(cells[7])});
    }
    return read;
}

std::string workFileName(const Work& work, std::size_t number) {
    constexpr std::size_t most = 100; // bytes of a name
    std::string name;
    for (const char c : work.name) {
        const auto byte = static_cast<unsigned char>(c);
        const bool isPlain = byte >= 0x80 || (c >= '0' && c <= '9') || (c >= 'A' && c <= 'Z')
                             || (c >= 'a' && c <= 'z') || c == '-';
        name += isPlain ? c : '_';
    }
    if (name.size() > most) {
        std::size_t end = most;
        while (end > 0 && (static_cast<unsigned char>(name[end]) & 0xC0) == 0x80) {
            --end; // inside a character
        }
        name.resize(end);
    }
    std::string digits = std::to_string(number);
    digits.insert(0, digits.size() < 3 ? 3 - digits.size() : 0, '0');
    return digits + '-' + name + ".sparkout-work";
}

} // namespace sparkout
