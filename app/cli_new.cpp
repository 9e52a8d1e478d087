// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/cli_io.h"
#include "app/cli_report.h"
#include "core/digits.h"
#include "core/file/file_system.h"
#include "core/file/project_file.h"
#include "core/phases/phase_decision.h"
#include "core/printable.h"
#include "core/project/cycle.h"
#include "core/project/iso286.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/operation.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/simulation/simulate.h"
#include "core/study/new_project.h"
#include "core/units.h"
#include "words/search_words.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <variant>

namespace sparkout::cli {

namespace {

/// The title made from a designation: "35k6 × 28".
std::string titleOf(const manual::Given& given) {
    return given.operands.front() + " × " + plainNumber(*given.number("--length"));
}

/// The drawing described by the options; reports faults.
std::optional<StartingDrawing> drawingIn(const manual::Given& given, int& status) {
    const auto designation = parseSizeDesignation(given.operands.front());
    if (!designation) {
        status = usageError("new needs a size with its field, as 35k6 or 60H7: "
                            + given.operands.front());
        return std::nullopt;
    }
    auto drawing = drawingOf(*designation);
    if (!drawing) {
        print(stderr, printable(given.operands.front())
                          + ": this tolerance field is not known; allowed: nominal sizes up to 500 "
                            "mm, grades IT4…IT14, deviations d…p and D…P of ISO 286\n");
        status = refused;
        return std::nullopt;
    }
    drawing->name = titleOf(given);
    if (given.has("--bore")) {
        drawing->surface = Surface::internal;
    }
    drawing->operation = choiceOf<Operation>(given, "--operation");
    drawing->length_mm = *given.number("--length");
    drawing->stock_mm = *given.number("--stock");
    drawing->tolerance.roughness_ra_um = given.number("--ra");
    const std::string& shoulder = given.text("--shoulder");
    drawing->ends.freeAtHeadstock = shoulder != "headstock" && shoulder != "both";
    drawing->ends.freeAtTailstock = shoulder != "tailstock" && shoulder != "both";
    return drawing;
}

/// Prints the issues of a project that is not written, with the options in the place of its inputs.
void printRefusal(const std::string& size, Issues issues) {
    static constexpr std::array<std::pair<std::string_view, std::string_view>, 8> options{
        {{"/machine", "--machine"},
         {"/wheel", "--wheel"},
         {"/material", "--material"},
         {"/part/length_mm", "--length"},
         {"/part/shaft", "--length"},
         {"/part/stock_mm", "--stock"},
         {"/part/tolerance/roughness_ra_um", "--ra"},
         {"/part/diameter_mm", ""}}};
    const auto optionOf = [](std::string_view path) {
        const auto found = std::ranges::find_if(
            options, [path](const auto& each) { return path.starts_with(each.first); });
        return found == options.end() ? path : found->second;
    };
    for (Issue& issue : issues) {
        issue.path = issue.code == IssueCode::wheelTooNarrow ? "--operation traverse, or --wheel"
                                                             : optionOf(issue.path);
        if (auto* const bounds = std::get_if<Bounds>(&issue.limit)) {
            bounds->field = optionOf(bounds->field);
        }
    }
    printIssues(size, issues);
}

/// "0.81 mm/min; stock 0.1 mm; 12 s" or "spark-out of 16 revolutions; stock 0.001 mm; 4 s".
std::string stageText(const Project& project, const Stage& stage, double time_s) {
    std::string text;
    if (const auto steps = stage.sparkOutSteps()) {
        text = "spark-out of " + std::to_string(*steps)
               + (project.operation->travels ? " double strokes" : " revolutions");
    } else {
        for (const StageFeed& feed : project.operation->feeds) {
            text += (text.empty() ? "" : ", ") + plainNumber((stage.*feed.value).value_or(0)) + ' '
                    + tableOf<Stage>().find(feed.key)->unit;
        }
    }
    return text + "; stock " + plainNumber(stage.stock_mm) + " mm; " + SearchWording().time(time_s);
}

/// "the depth of the burnt layer: 6.0 µm instead of the usual 15.0 µm".
std::string roughText(const StartingCycle& start) {
    const auto inMicrometres = [](double depth_mm) {
        return fixed(depth_mm * units::umPerMm, 1) + " µm";
    };
    return std::string(roughBoundText(start.bound)) + ": " + inMicrometres(start.roughDepth_mm)
           + (start.bound == RoughBound::table
                  ? ""
                  : " instead of the usual " + inMicrometres(start.usualDepth_mm))
           + (start.isExceeded ? ", which the machine's lowest feed exceeds" : "");
}

std::string stocksText(const PhaseDecision& decision) {
    if (!decision.isDecided) {
        return "not decided";
    }
    const auto range = [](const StockRange& stocks) {
        constexpr int digits = 4;
        return fixed(stocks.from_mm, digits) + "…" + fixed(stocks.to_mm, digits) + " mm";
    };
    if (decision.holds()) {
        return fitForStocks(true, range(decision.range));
    }
    std::string failing;
    for (const StockRange& each : decision.failingRanges()) {
        failing += (failing.empty() ? "" : ", ") + range(each);
    }
    return fitForStocks(false, failing);
}

std::string labelled(const std::string& label, const std::string& value) {
    constexpr std::size_t column = 21;
    return label + std::string(label.size() < column ? column - label.size() : 1, ' ') + value
           + '\n';
}

std::string startText(const StartingCycle& start) {
    const Project& project = start.project;
    std::string text =
        labelled("machine", project.machine->name + ", " + project.wheel->marking + ", "
                                + project.material->grade)
        + labelled("work speed", plainNumber(project.machine->work_speed_rpm) + " rev/min");
    const auto& stages = project.cycle->stages;
    const SimulationResult result = simulate(project);
    for (std::size_t i = 0; i < stages.size(); ++i) {
        text += labelled("stage " + std::to_string(i + 1),
                         stageText(project, stages[i], result.timeByStage_s[i]));
    }
    text += labelled("rough depth limited by", roughText(start))
            + labelled("machining time", SearchWording().time(result.time_s));
    return text + labelled("cycle", stocksText(decidePhases(project, usualPhases(project))));
}

} // namespace

int runNewCommand(const manual::Given& given) {
    int status = done;
    const auto drawing = drawingIn(given, status);
    if (!drawing) {
        return status;
    }
    Issues issues;
    const auto entries =
        startingEntries({given.text("--machine"), given.text("--wheel"), given.text("--material")},
                        *drawing, issues);
    if (!entries) {
        printRefusal(given.operands.front(), std::move(issues));
        return refused;
    }
    std::error_code ignored;
    if (!given.has("--force") && std::filesystem::exists(pathFromUtf8(given.text("-o")), ignored)) {
        print(stderr, printable(given.text("-o")) + ": exists; --force replaces it\n");
        return refused;
    }
    const StartingAnswer answer = drawnProject(*drawing, *entries);
    if (!answer.start) {
        printRefusal(given.operands.front(), answer.issues);
        return refused;
    }
    printIssues(given.operands.front(), answer.issues);
    if (const int failed = save(given.text("-o"), writeProject(answer.start->project))) {
        return failed;
    }
    print(stdout, startText(*answer.start));
    return done;
}

} // namespace sparkout::cli
