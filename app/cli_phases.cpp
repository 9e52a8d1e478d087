// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/batch_watch.h"
#include "app/cli_io.h"
#include "app/cli_report.h"
#include "app/stop_signals.h"
#include "core/digits.h"
#include "core/phases/phase_decision.h"
#include "core/printable.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/project/wheel.h"
#include "core/quality/requirement.h"
#include "core/quality/result_names.h"
#include "core/units.h"
#include "words/search_words.h"

#include <cstddef>
#include <optional>
#include <string>

namespace sparkout::cli {

namespace {

constexpr int stockDigits = 6, deviationDigits = 2; // nm, 10 nm

std::string placeOf(const Project& project, std::size_t place) {
    return sectionOrPart(project.operation->travels ? static_cast<Zone>(place) : Zone::section,
                         static_cast<int>(place), First::inTexts);
}

std::string rangeText(const StockRange& range) {
    return fixed(range.from_mm, stockDigits) + "…" + fixed(range.to_mm, stockDigits) + " mm";
}

std::string whyText(RunStatus status, const std::optional<ConstraintResult>& worst) {
    if (status != RunStatus::completed) {
        return "the cycle does not end by itself";
    }
    return worst ? std::string(requirementOf(worst->kind).key) + " in "
                       + whereText(*worst, First::inTexts)
                 : std::string();
}

std::string pieceText(const Project& project, const DecidedPiece& each) {
    std::string steps;
    for (const int count : each.piece.counts) {
        steps += (steps.empty() ? "" : "+") + std::to_string(count);
    }
    std::string text = rangeText({each.piece.from_mm, each.piece.to_mm}) + "  " + steps + "  "
                       + SearchWording().time(each.time_s);
    const auto um = [](double value_mm) {
        return fixed(value_mm * units::umPerMm, deviationDigits);
    };
    for (std::size_t place = 0; place < each.low.deviations.size(); ++place) {
        const DeviationRange &low = each.low.deviations[place], &high = each.high.deviations[place];
        text += "  " + placeOf(project, place) + ' ' + um(low.least_mm) + "…" + um(low.most_mm)
                + " → " + um(high.least_mm) + "…" + um(high.most_mm) + " µm";
    }
    return text + (each.holdsWhole() ? "  fit" : each.holds ? "  unfit in part" : "  unfit") + '\n';
}

std::string phasesText(const Project& project, const PhaseDecision& decision) {
    if (decision.hasTooMany) {
        return "not decided          the range has more than " + std::to_string(mostDecidedPieces)
               + " pieces: choose a narrower one with --from and --to\n";
    }
    std::string text;
    for (const DecidedPiece& each : decision.pieces) {
        text += pieceText(project, each);
    }
    if (decision.holds()) {
        return text + fitForStocks(true, rangeText(decision.range))
               + (project.wheel->runout ? ", at four angles of the wheel" : "") + '\n';
    }
    for (const FailingStocks& each : decision.failing) {
        text += fitForStocks(false, rangeText(each.stocks))
                + (each.wheel_deg ? " with the wheel at " + fixed(*each.wheel_deg, 0) + "°" : "")
                + ": " + whyText(each.status, each.worst) + '\n';
    }
    return text;
}

int decideOne(const Project& project, const std::string& name, const manual::Given& given) {
    if (!canDecidePhases(project)) {
        print(stderr, printable(name)
                          + ": /gauge/control: the phases of the stock are decided only under "
                            "gauge control\n");
        return refused;
    }
    StockRange range = usualPhases(project);
    range.from_mm = given.number("--from").value_or(range.from_mm);
    range.to_mm = given.number("--to").value_or(range.to_mm);
    if (range.from_mm > range.to_mm) {
        return usageError("--from " + plainNumber(range.from_mm) + " lies above --to "
                          + plainNumber(range.to_mm));
    }
    PhaseDecision decision;
    {
        BatchWatch watch(1, false, "phases");
        decision = decidePhases(project, range, watch.stop());
    }
    if (caughtSignal() != 0) {
        return interrupted + caughtSignal();
    }
    print(stdout, given.has("--json") ? phasesJson(decision) : phasesText(project, decision));
    return given.has("--check") && !decision.holds() ? requirementFails : done;
}

} // namespace

int runPhasesCommand(const manual::Given& given) {
    const Surfaces surfaces(given);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    return surfaces.run([&given](const Project& project, std::size_t, const std::string& name) {
        return decideOne(project, name, given);
    });
}

} // namespace sparkout::cli
