// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_optimise_report.h"

#include "app/io/cli_outputs.h"
#include "app/io/cli_report.h"
#include "core/digits.h"
#include "core/project/cycle.h"
#include "core/project/machine.h"
#include "core/project/validate.h"
#include "core/study/search_outputs.h"
#include "words/search_words.h"

namespace sparkout::cli {

namespace {

std::string stageLine(const Operation& operation, const Stage& stage, std::size_t number) {
    std::string feeds;
    if (const auto steps = stage.sparkOutSteps()) {
        feeds = "spark-out, " + std::to_string(*steps)
                + (operation->countsStrokes ? " double strokes" : " revolutions");
    } else if (stage.continuousFeed_mm_min() > 0) {
        feeds = plainNumber(stage.continuousFeed_mm_min()) + " mm/min continuous";
    } else {
        const double radial = *(stage.*operation->radial().value);
        feeds = operation->perMinute ? fixed(radial, 3) + " mm/min"
                                     : fixed(radial, 4) + " mm per double stroke";
    }
    if (const StageFeed* axial = operation->axial()) {
        feeds += ", " + fixed(*(stage.*axial->value), 0) + " mm/min axial";
    }
    return "  stage " + std::to_string(number) + ": " + feeds + "; stock "
           + fixed(stage.stock_mm, 4) + " mm\n";
}

std::string machineLines(const SearchOutcome& outcome) {
    std::string text;
    for (const FreeSetting& each : freeSettings(outcome.project, outcome.answer()->machine)) {
        const Field& row = *tableOf<Machine>().find(each.key);
        text +=
            std::string("  ") + row.label + ": " + plainNumber(each.value) + ' ' + row.unit + '\n';
    }
    return text;
}

/// The requirements that the file's own cycle violates.
std::string givenLines(const GivenCycle& given) {
    std::string names;
    for (const ConstraintKind kind : given.fails) {
        names += (names.empty() ? "The file's cycle breaks: " : ", ")
                 + std::string(requirementOf(kind).key);
    }
    return given.isStopped ? "The result of the file's cycle is not known: stopped before.\n"
           : !given.time_s ? "The file's cycle does not end by itself.\n"
           : names.empty() ? ""
                           : names + ".\n";
}

/// Time against margin: a line for each cycle.
std::string frontLines(const SearchOutcome& outcome) {
    const SearchWording words;
    std::string text = words.front(outcome) + '\n';
    for (const FoundCycle* each : outcome.front()) {
        text += "  " + words.time(each->time_s) + ", margin "
                + words.percent(each->leastRelativeMargin)
                + " %, stages: " + std::to_string(each->cycle.stages.size()) + '\n';
    }
    return text;
}

} // namespace

std::string optimiseText(const SearchOutcome& outcome) {
    std::string text;
    for (const std::string& sentence : SearchWording().answer(outcome, outcome.given.time_s)) {
        text += sentence + '\n';
    }
    text += givenLines(outcome.given);
    const Cycle& cycle = outcome.answer()->cycle;
    for (std::size_t z = 0; z < cycle.stages.size(); ++z) {
        text += stageLine(outcome.project.operation, cycle.stages[z], z + 1);
    }
    text += machineLines(outcome) + outputLines(searchOutputs(), outcome);
    return outcome.wishesFront ? text + frontLines(outcome) : text;
}

} // namespace sparkout::cli
