// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_measured.h"

#include "app/batch_watch.h"
#include "app/cli_io.h"
#include "app/cli_report.h"
#include "app/stop_signals.h"
#include "core/batch/batch_run.h"
#include "core/file/file_system.h"
#include "core/measured/adequacy.h"
#include "core/measured/calibration.h"
#include "core/measured/hold_out.h"
#include "core/measured/identification.h"
#include "core/measured/measured_table.h"
#include "core/printable.h"
#include "core/process/force.h"
#include "core/project/batch.h"
#include "core/project/part.h"
#include "core/project/validate.h"
#include "core/setup/setup.h"
#include "core/setup/setup_file.h"
#include "words/measured_words.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace sparkout::cli {

namespace {

/// Reads a table of measurements into a project; reports faults by line and column.
bool readInto(Project& project, const std::string& file) {
    const auto text = readOrSay(file, limits::measuredBytes);
    if (!text) {
        return false;
    }
    const MeasuredContext context{utf8(pathFromUtf8(file).filename()), project.part->diameter_mm,
                                  0};
    ReadMeasured read = readMeasured(*text, proposeTable(*text), context);
    printFaults(file, read.faults);
    if (!read.faults.empty()) {
        return false;
    }
    Measured& measured = project.measured ? *project.measured : project.measured.emplace();
    std::ranges::move(read.data.parts, std::back_inserter(measured.parts));
    std::ranges::move(read.data.traces, std::back_inserter(measured.traces));
    return true;
}

std::string rowText(const Project& project, const AdequacyRow& row) {
    const MeasuredStatistics& parts = row.measured;
    std::string text = placeKey(project, parts.place, First::inTexts) + ", " + keyOf(parts.quantity)
                       + ": n = " + std::to_string(parts.count) + ", mean " + fixed(parts.mean, 2);
    if (row.mean95) {
        text += " ± " + fixed((row.mean95->high - row.mean95->low) / 2, 2);
    }
    text += " µm";
    if (row.predicted) {
        text += "; predicted " + fixed(row.predicted->low, 2) + "…" + fixed(row.predicted->high, 2)
                + " µm";
    }
    if (row.bias95) {
        text += "; bias " + fixed(row.bias95->low, 2) + "…" + fixed(row.bias95->high, 2)
                + " µm, limit " + fixed(row.biasLimit, 2) + " µm";
    }
    if (row.scatter) {
        constexpr double most = 1e4; // exceeded if almost no scatter is predicted
        text += "; F = " + (row.scatter->ratio > most ? "over 10000" : fixed(row.scatter->ratio, 2))
                + " (" + fixed(row.scatter->low, 2) + "…" + fixed(row.scatter->high, 2) + ")";
    }
    if (row.share) {
        constexpr double perCent = 100;
        text += "; " + std::to_string(row.share->inside) + " of " + std::to_string(row.share->count)
                + " inside (" + fixed(perCent * row.share->interval.low, 0) + "…"
                + fixed(perCent * row.share->interval.high, 0) + " %)";
    }
    return text + ": " + textOf(row.verdict) + '\n';
}

/// Names lone readings beyond the range of all others; otherwise empty.
std::string overRangeText(const FitResiduals& group) {
    constexpr int digits = 4, ofTime = 3;
    std::string readings;
    for (const TraceReading& one : group.overRange) {
        readings += (readings.empty() ? "" : ", ") + fixed(one.value, digits) + ' '
                    + unitOf(group.source) + " at " + fixed(one.time_s, ofTime) + " s";
    }
    return readings.empty() ? std::string()
                            : std::string("over range: ") + wordsOf(group.source).text + ": "
                                  + readings + ": " + overRangeAdvice() + '\n';
}

std::string fitText(const Project& project, const Identification& found,
                    const std::vector<FittedParameter>& requested) {
    std::string text;
    constexpr int digits = 4;
    for (const FittedValue& value : found.values) {
        const std::string unit = unitOf(value.parameter.kind);
        text += parameterName(value.parameter) + ": " + fixed(value.value, digits) + " ("
                + fixed(value.interval95.low, digits) + "…" + fixed(value.interval95.high, digits)
                + ")" + (unit.empty() ? "" : " " + unit) + ", "
                + wordsOf(value.parameter.kind, hasThreshold(project)).text + '\n';
    }
    for (const FittedValue& value : found.values) {
        if (!value.isUsual()) {
            text += "does not fit: " + parameterName(value.parameter) + ": "
                    + fixed(value.value, digits) + "; usual: " + fixed(value.usual->low, digits)
                    + "…" + fixed(value.usual->high, digits) + '\n';
        }
    }
    for (const FitResiduals& group : found.residuals) {
        text += std::string(wordsOf(group.source).text) + ": residuals of "
                + std::to_string(group.values.size()) + " values, RMS " + fixed(group.rms, 5) + ' '
                + unitOf(group.source);
        text += group.noise ? ", noise of the trace " + fixed(std::sqrt(group.noise->variance()), 5)
                                  + ' ' + unitOf(group.source)
                            : "";
        text += '\n';
    }
    for (const FitResiduals& group : found.residuals) {
        text += overRangeText(group);
        if (group.lack.isLacking()) {
            text += std::string("does not fit: ") + wordsOf(group.source).text + ": "
                    + fixed(group.lack.ratio, 1) + " times the noise, at most "
                    + fixed(group.lack.most, 1) + " by chance: " + wordsOf(group.unlike.kind).text
                    + (group.unlike.stage >= 0
                           ? " (stage " + std::to_string(group.unlike.stage + 1) + ")"
                           : "")
                    + '\n';
        }
    }
    if (found.forceLaw) {
        const ForceLawChoice& law = *found.forceLaw;
        text += std::string("force law: ") + wordsOf(law.supported).text + " ("
                + std::to_string(law.revolutions)
                + " revolutions; AIC of the sources' law minus that with a threshold "
                + fixed(law.aicDifference, 1) + "; RMS of the residuals "
                + fixed(law.sourcesRms_um, 3) + " and " + fixed(law.thresholdRms_um, 3) + " µm)"
                + (law.revolutionsMore
                       ? "; a spark-out longer by " + std::to_string(*law.revolutionsMore)
                             + " revolutions would separate them"
                       : "")
                + '\n';
    }
    for (const OutOfStep& one : found.outOfStep) {
        constexpr double normal95 = 1.96;
        text += std::string("left out: ") + wordsOf(one.kind).text + " seems to be "
                + fixed(one.amount, digits) + " ± " + fixed(normal95 * one.error, digits) + ' '
                + unitOf(one.kind) + " and was not fitted; with " + wordsOf(one.kind).key + " too, "
                + parameterName(requested[one.parameter]) + " would be " + fixed(one.value, digits)
                + '\n';
    }
    if (found.status != IdentificationStatus::fitted) {
        text += std::string(wordsOf(found.status).text) + '\n';
    }
    for (const Unidentified& one : found.unidentified) {
        std::string names;
        for (const std::size_t i : one.parameters) {
            names += (names.empty() ? "" : ", ") + parameterName(requested[i]);
        }
        text += (one.isProduct ? "determined only as a product: " : "undetermined: ") + names + "; "
                + wordsOf(one.advice).text + '\n';
    }
    return text;
}

std::string holdOutText(const Project& project, const HoldOutRow& row) {
    constexpr int digits = 3;
    const auto number = [](double value) { return fixed(value, digits); };
    return "not used for the calibration, "
           + printable(project.measured->traces[static_cast<std::size_t>(row.trace)].source) + ": "
           + wordsOf(row.quantity).text + ": " + number(row.measured) + ' ' + unitOf(row.quantity)
           + ", predicted " + number(row.predicted) + " (" + number(row.predicted95.low) + "…"
           + number(row.predicted95.high) + "), difference " + number(row.difference95.low) + "…"
           + number(row.difference95.high) + (row.agrees() ? ": agrees\n" : ": does not agree\n");
}

/// Runs the batch for the prediction and judges; returns the exit status.
int judge(const Project& project, const std::string& name, const manual::Given& given,
          MeasuredAnswer& answer) {
    if (statisticsOfMeasured(project).empty()) {
        return done;
    }
    const Project predicting = predictingProject(project);
    const Issues issues = checkBatch(predicting);
    printIssues(name, issues);
    if (!issues.empty()) {
        return refused;
    }
    BatchOptions run;
    BatchWatch watch(predicting.batch->parts, given.has("--progress"), "parts");
    run.stop = watch.stop();
    run.done = watch.done();
    answer.rows = judgeAdequacy(project, runBatchUnchecked(predicting, run));
    return done;
}

int statusOf(const MeasuredAnswer& answer, const manual::Given& given) {
    if (answer.fit) {
        switch (answer.fit->status) {
        case IdentificationStatus::fitted: break;
        case IdentificationStatus::cannotTell:
            return given.has("--check") ? requirementFails : done;
        case IdentificationStatus::doesNotFit: return requirementFails;
        case IdentificationStatus::notRun:
            return answer.fit->issues.empty() ? cannotReachSize : refused;
        default: return refused;
        }
    }
    const bool agrees = std::ranges::all_of(answer.holdOut, &HoldOutRow::agrees);
    return given.has("--check") && !(agrees && speaksForModel(answer.rows)) ? requirementFails
                                                                            : done;
}

/// Saves the fitted inputs in their set-up.
int saveFound(const Project& project, const Identification& found, Setup setup, std::size_t surface,
              const manual::Given& given) {
    const std::string& data = !given.has("--data") ? given.operands.front() : given.text("--data");
    const Project made =
        withCalibration(project, found, utf8(pathFromUtf8(data).filename()), today());
    for (GroundSurface& other : setup.surfaces) {
        copyShared(made, other.project);
    }
    setup.surfaces[surface].project = made;
    return save(given.text("-o"), writeSetup(setup));
}

int measureOne(Project project, const Surfaces& surfaces, std::size_t surface,
               const std::string& name, const std::vector<FittedParameter>& parameters,
               const manual::Given& given) {
    if (given.has("--data") && !readInto(project, given.text("--data"))) {
        return refused;
    }
    if (!project.measured
        || (project.measured->parts.empty() && project.measured->traces.empty()
            && project.measured->summaries.empty())) {
        print(stderr, printable(name) + ": /measured: nothing is measured\n");
        return refused;
    }
    MeasuredAnswer answer{.rows = {}, .holdOut = {}, .fit = {}, .parameters = parameters};
    if (const int failed = judge(project, name, given, answer)) {
        return failed;
    }
    if (caughtSignal() == 0) {
        const BatchWatch watch(BatchWatch::uncounted, false, "cycles");
        answer.holdOut = holdOut(project, watch.stop());
    }
    if (!parameters.empty() && caughtSignal() == 0) {
        const BatchWatch watch(BatchWatch::uncounted, false, "cycles");
        answer.fit = identify(project,
                              {parameters,
                               {},
                               !answer.rows.empty(),
                               robustLossOf(given.text("--loss")).value_or(RobustLoss::none)},
                              watch.stop());
        printIssues(answer.fit->values.empty() ? name : name + ", with these values",
                    answer.fit->issues);
    }
    if (given.has("--json")) {
        print(stdout, measuredJson(project, answer));
    } else {
        for (const AdequacyRow& row : answer.rows) {
            print(stdout, rowText(project, row));
        }
        for (const HoldOutRow& row : answer.holdOut) {
            print(stdout, holdOutText(project, row));
        }
        print(stdout, answer.fit ? fitText(project, *answer.fit, parameters) : std::string());
    }
    if (caughtSignal() != 0) {
        return interrupted + caughtSignal();
    }
    if (given.has("-o")) {
        if (answer.fit->status != IdentificationStatus::fitted) {
            print(stderr,
                  printable(given.text("-o")) + ": not saved, since there are no usable values\n");
        } else if (const int failed =
                       saveFound(project, *answer.fit, surfaces.setup(), surface, given)) {
            return failed;
        }
    }
    return statusOf(answer, given);
}

} // namespace

int runMeasuredCommand(const manual::Given& given) {
    const bool statesForm = given.has("--roundness") || given.has("--profile");
    const bool findsStiffness = given.has("--stiffness-sheet") || given.has("--stiffness");
    const bool fits = given.has("--fit") || given.has("--data");
    if (int(statesForm) + int(given.has("--trial")) + int(findsStiffness) + int(fits) > 1) {
        return usageError("only one of --roundness, --trial, --stiffness and --fit");
    }
    if (isSameFile(given.text("-o"), given.operands.front())) {
        return usageError("-o would replace the project that is read: " + given.text("-o"));
    }
    std::vector<FittedParameter> parameters;
    const char* const wish = given.has("--trial") ? "--trial" : "--fit";
    if (given.has(wish)) {
        const auto requested = fittedParametersOf(given.text(wish));
        if (!requested) {
            return usageError(std::string(wish) + " needs parameters out of " + knownParameters()
                              + "; " + parameterHint());
        }
        parameters = *requested;
    }
    const Surfaces surfaces(given);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    if (const int failed = surfaces.oneFor({"--data", "-o", "--profile", "--stiffness"})) {
        return failed;
    }
    return surfaces.run([&](const Project& project, std::size_t surface, const std::string& name) {
        return statesForm       ? stateRoundness(project, name, given)
               : findsStiffness ? findStiffness(project, name, given)
               : given.has("--trial")
                   ? designTrialOf(project, name, parameters, given)
                   : measureOne(project, surfaces, surface, name, parameters, given);
    });
}

} // namespace sparkout::cli
