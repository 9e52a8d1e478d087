// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/batch_watch.h"
#include "app/cli_io.h"
#include "app/cli_report.h"
#include "app/stop_signals.h"
#include "core/batch/sweep_run.h"
#include "core/digits.h"
#include "core/file/csv_line.h"
#include "core/project/validate.h"
#include "core/quality/result_names.h"
#include "words/issue_words.h"

#include <string>

namespace sparkout::cli {

namespace {

std::string placeOf(const SweepQuantity& quantity) {
    return sectionOrPart(quantity.zone, quantity.section);
}

/// A row for each point, with the value and the margin of every result.
std::string sweepCsv(const SweepResult& sweep) {
    CsvLine line;
    const auto head = [&line](const std::string& name, const std::string& unit) {
        line.text(unit.empty() ? name : name + " [" + unit + ']');
    };
    for (const SweptInput& input : sweep.inputs) {
        head(input.axis.input, input.unit);
    }
    line.text("status").text("ok");
    for (const SweepQuantity& quantity : sweep.quantities) {
        const std::string name = quantity.name + ' ' + placeOf(quantity);
        head(name, quantity.unit);
        head(name + " margin", {});
    }
    std::string text = line.end();
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        const SweepPoint& point = sweep.points[i];
        for (const double value : sweep.valuesAt(i)) {
            line.number(value);
        }
        line.text(sweepStatusKey(point.status)).text(point.good ? "true" : "false");
        for (std::size_t q = 0; q < sweep.quantities.size(); ++q) {
            const SweepValue value = point.values.empty() ? SweepValue{} : point.values[q];
            line.number(value.value).number(value.margin);
        }
        text += line.end();
    }
    return text;
}

/// A line for each point: its values, its time, its minimum margin.
std::string sweepText(const SweepResult& sweep) {
    std::string text;
    for (const SweptInput& input : sweep.inputs) {
        text += input.axis.input + (input.unit.empty() ? "  " : " [" + input.unit + "]  ");
    }
    text += "status  time [s]  minimum margin [%]\n";
    for (std::size_t i = 0; i < sweep.points.size(); ++i) {
        const SweepPoint& point = sweep.points[i];
        for (const double value : sweep.valuesAt(i)) {
            text += plainNumber(value) + "  ";
        }
        text += sweepStatusKey(point.status);
        for (std::size_t q = 0; q < point.values.size(); ++q) {
            const std::string& name = sweep.quantities[q].name;
            if (name == "time" || name == "least_margin") {
                text += "  " + fixed(point.values[q].value, 2);
            }
        }
        text += point.status == SweepStatus::done && !point.good ? "  unfit\n" : "\n";
    }
    return text;
}

int runSweepOf(const Project& project, const std::string& name, const manual::Given& given) {
    const Issues issues = checkSweep(project);
    printIssues(name, issues);
    if (!issues.empty()) {
        return refused;
    }
    SweepResult sweep;
    {
        SweepOptions run;
        run.threads = given.integer("--threads").value_or(0);
        BatchWatch watch(pointsOf(project), given.has("--progress"), "points");
        run.stop = watch.stop();
        run.done = watch.done();
        sweep = runSweep(project, run);
    }
    print(stdout, given.has("--json")  ? sweepJson(sweep, issueSentence)
                  : given.has("--csv") ? sweepCsv(sweep)
                                       : sweepText(sweep));
    return caughtSignal() == 0 ? done : interrupted + caughtSignal();
}

} // namespace

int runSweepCommand(const manual::Given& given) {
    const Surfaces surfaces(given);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    if (const int failed = surfaces.oneFor({"--csv"})) {
        return failed;
    }
    return surfaces.run([&given](const Project& project, std::size_t, const std::string& name) {
        return runSweepOf(project, name, given);
    });
}

} // namespace sparkout::cli
