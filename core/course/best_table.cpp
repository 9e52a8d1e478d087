// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/course/best_table.h"

#include "core/course/work_seal.h"
#include "core/lesson/goal_check.h"
#include "core/measured/table_text.h"
#include "core/printable.h"
#include "core/project/cycle.h"
#include "core/project/validate.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <utility>

namespace sparkout {

namespace {

constexpr const char* forTeacher = "For the teacher only: best answers, not for students";
constexpr std::array keyColumns{"variant",    "name",          "group",
                                "levels",     "best_time_min", "best_margin_percent",
                                "best_cycle", "digest"};
constexpr std::size_t readColumns = 8;

std::string line(const std::vector<std::string>& cells) {
    std::string text;
    for (const std::string& cell : cells) {
        text += (text.empty() ? "" : ",") + cell;
    }
    return text + '\n';
}

/// What a column of a varied input is called.
std::string headingOf(const VariedInput& input) {
    return csvCell(!input.path.empty()  ? input.path
                   : input.sets.empty() ? std::string("set")
                                        : input.sets.front().values.front().path);
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

/// What the engine answers to a step of a variant as it is given.
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

/// A cell as it was written: csvCell() puts an apostrophe before what looks like a formula.
std::string written(std::string_view cell) {
    const bool isMarked = cell.size() > 1 && cell[0] == '\'' && readsAsFormula(cell.substr(1));
    return std::string(isMarked ? cell.substr(1) : cell);
}

std::optional<int> wholeIn(std::string_view cell) {
    int value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    return error == std::errc() && end == cell.data() + cell.size() ? std::optional(value)
                                                                    : std::nullopt;
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
    std::vector<std::string> headings{"variant", "name", "group"};
    const std::vector<VariedInput> inputs =
        lesson.variants ? lesson.variants->inputs : std::vector<VariedInput>();
    std::transform(inputs.begin(), inputs.end(), std::back_inserter(headings), headingOf);
    std::string text = line(headings);
    for (const Work& work : works) {
        std::vector<std::string> cells{std::to_string(work.variant), csvCell(work.name),
                                       csvCell(work.group)};
        const VariantLevels levels = work.variantLevels();
        for (std::size_t i = 0; i < levels.size(); ++i) {
            const std::string name = inputs[i].nameOf(levels[i]);
            cells.push_back(inputs[i].sets.empty() ? name : csvCell(name));
        }
        text += line(cells);
    }
    return text;
}

std::string bestTableCsv(const Lesson& lesson, const std::vector<Work>& works,
                         const std::vector<MadeVariant>& variants) {
    std::string text = line({csvCell(forTeacher), csvCell(lesson.title.in(false))});
    std::vector<std::string> headings(keyColumns.begin(), keyColumns.end());
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        headings.push_back("step " + std::to_string(i + 1) + " ("
                           + goalKey(lesson.steps[i].goal.kind()) + ")");
    }
    text += line(headings);
    for (std::size_t i = 0; i < works.size(); ++i) {
        const Work& work = works[i];
        const auto& best = variants[i].best;
        const auto best_min = best ? std::optional(best->time_min) : std::nullopt;
        std::vector<std::string> cells{
            std::to_string(work.variant),
            csvCell(work.name),
            csvCell(work.group),
            levelsText(variants[i].levels),
            numberOr(best_min),
            numberOr(best ? std::optional(best->margin_percent) : std::nullopt),
            csvCell(best ? cycleText(best->project) : std::string()),
            variantDigest(work.lesson)};
        const Lesson marked = withVariant(lesson, variants[i].levels, best_min);
        for (std::size_t step = 0; step < lesson.steps.size(); ++step) {
            cells.push_back(csvCell(engineAnswer(marked, step)));
        }
        text += line(cells);
    }
    return text;
}

ReadBestTable readBestTable(std::string_view text) {
    ReadBestTable read;
    TableLines lines(text);
    std::vector<std::string_view> cells;
    bool isBelowHeadings = false;
    char delimiter = ',';
    char decimal = '.';
    while (!lines.atEnd()) {
        const std::string_view row = lines.next();
        if (row.find_first_not_of(" \t\r,;") == std::string_view::npos) {
            continue;
        }
        if (!isBelowHeadings) {
            delimiter = row.find(';') != std::string_view::npos ? ';' : ',';
            decimal = delimiter == ';' ? ',' : '.';
            splitCells(row, delimiter, cells);
            isBelowHeadings = cells.size() >= readColumns
                              && std::equal(keyColumns.begin(), keyColumns.end(), cells.begin());
            if (!isBelowHeadings && lines.number() > 1) {
                read.faultLine = lines.number();
                return read;
            }
            continue;
        }
        splitCells(row, delimiter, cells);
        const auto variant = cells.size() < readColumns ? std::nullopt : wholeIn(cells[0]);
        const auto levels = variant ? levelsIn(cells[3]) : std::nullopt;
        if (!levels) {
            read.faultLine = lines.number();
            return read;
        }
        const auto number = [&](std::string_view cell) {
            const auto plain = cellNumber(cell, '.');
            return plain ? plain : cellNumber(cell, decimal);
        };
        read.rows.push_back({*variant, written(cells[1]), written(cells[2]), *levels,
                             number(cells[4]), number(cells[5]), std::string(cells[7])});
    }
    if (!isBelowHeadings) {
        read.faultLine = std::max<std::size_t>(lines.number(), 1);
    }
    return read;
}

std::string workFileName(const Work& work, std::size_t number) {
    constexpr std::size_t most = 100; // bytes of the name
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
            --end; // not inside a character
        }
        name.resize(end);
    }
    std::string digits = std::to_string(number);
    digits.insert(0, digits.size() < 3 ? 3 - digits.size() : 0, '0');
    return digits + '-' + name + ".sparkout-work";
}

} // namespace sparkout
