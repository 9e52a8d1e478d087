// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/batch_watch.h"
#include "app/cli_io.h"
#include "app/cli_report.h"
#include "app/stop_signals.h"
#include "core/project/batch.h"
#include "core/project/optimisation.h"
#include "core/quality/result_names.h"
#include "core/setup/dressing_interval.h"

#include <cstdint>
#include <optional>
#include <string>

namespace sparkout::cli {

namespace {

std::string endText(const Setup& setup, const WornFailure& end) {
    const std::string& surface = setup.surfaces[end.surface].name;
    std::string text = "ends by              part " + std::to_string(end.part);
    text += surface.empty() ? "" : ", " + surface;
    text += end.scenario ? ", part " + std::to_string(*end.scenario + 1) + " of its batch: " : ": ";
    if (!end.issues.empty()) {
        return text + "the worn wheel is refused\n";
    }
    if (!end.worst) {
        return text + "it does not reach size\n";
    }
    const Requirement& row = requirementOf(end.worst->kind);
    return text + row.key + " in " + whereText(*end.worst, First::inTexts) + ", "
           + fixed(end.worst->value, row.digits.printed) + ' ' + row.unit + ", limit "
           + fixed(end.worst->limit, row.digits.printed) + '\n';
}

std::string partsText(const DressingInterval& interval) {
    if (interval.isEndless) {
        return "any number: the wheel does not get duller, and every part is good";
    }
    const std::string parts = std::to_string(interval.parts);
    return interval.end ? parts : "at least " + parts;
}

std::string dressingText(const Setup& setup, const DressingInterval& interval) {
    std::string text = "parts to a dressing  " + partsText(interval) + '\n';
    if (interval.end) {
        text += endText(setup, *interval.end);
    }
    text += "a part removes       " + fixed(interval.partVolume_mm3, 1) + " mm³\n";
    const BestIntervals best = bestIntervals(setup, interval);
    if (best.quickest) {
        text += "quickest after       " + std::to_string(best.quickest->parts) + " parts, "
                + fixed(best.quickest->value, 2) + " s a part with dressing\n";
        text += "cheapest after       " + std::to_string(best.cheapest->parts) + " parts, "
                + fixed(best.cheapest->value, 4) + " a part\n";
    }
    return text;
}

/// The reason why there is no answer; empty if there is one.
std::optional<std::string> refusal(const DressingInterval& interval) {
    switch (interval.fault) {
    case DressingFault::none: return std::nullopt;
    case DressingFault::noWear:
        return "/wear: not given; a dulling or a grinding ratio determines the wear of the wheel";
    case DressingFault::firstFails: return "the first part after dressing does not reach size";
    }
    return std::nullopt;
}

} // namespace

int runDressingCommand(const manual::Given& given) {
    const auto setup = loadSetup(given.operands.front());
    if (!setup) {
        return refused;
    }
    DressingInterval interval;
    {
        DressingOptions run;
        BatchWatch watch(run.most, given.has("--progress"), "parts");
        run.scenarios = choiceOf<Scenarios>(given, "--scenarios");
        run.stop = watch.stop();
        run.onPart = [&watch](std::int64_t part) { *watch.done() = part; };
        interval = dressingInterval(*setup, run);
    }
    if (interval.isStopped) {
        return interrupted + caughtSignal();
    }
    if (!interval.issues.empty()) {
        printIssues(given.operands.front(), interval.issues);
        return refused;
    }
    if (const auto why = refusal(interval)) {
        print(stderr, given.operands.front() + ": " + *why + '\n');
        return interval.fault == DressingFault::noWear ? refused : cannotReachSize;
    }
    print(stdout,
          given.has("--json") ? dressingJson(*setup, interval) : dressingText(*setup, interval));
    return given.has("--check") && interval.parts == 0 ? requirementFails : done;
}

} // namespace sparkout::cli
