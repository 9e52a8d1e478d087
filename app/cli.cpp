// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_batch_command.h"
#include "app/cli_dressing.h"
#include "app/cli_new.h"
#include "app/cli_optimise.h"
#include "app/cli_phases.h"
#include "app/cli_remedies.h"
#include "app/cli_sweep.h"
#include "app/course/cli_course.h"
#include "app/examples.h"
#include "app/io/batch_watch.h"
#include "app/io/cli_io.h"
#include "app/io/cli_kept_runs.h"
#include "app/io/cli_options.h"
#include "app/io/cli_report.h"
#include "app/io/cli_surfaces.h"
#include "app/io/console.h"
#include "app/io/stop_signals.h"
#include "app/manual/help_text.h"
#include "app/measured/cli_measured.h"
#include "core/batch/batch_run.h"
#include "core/files/file_system.h"
#include "core/files/safe_file.h"
#include "core/format/project_file.h"
#include "core/judgement/judgement.h"
#include "core/printable.h"
#include "core/project/batch.h"
#include "core/quality/remarks.h"
#include "core/setup/setup_json.h"
#include "core/simulation/simulate.h"
#include "core/version.h"
#include "words/judgement_json.h"
#include "words/judgement_words.h"

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout::cli {

namespace {

/// The trace of a cycle: a second run, now that its size is known.
int writeTrace(const SimulationResult& result, const std::string& name, const Options& options) {
    if (result.visits > maxRecordedVisits) {
        print(stderr, printable(name) + ": the trace would have " + std::to_string(result.visits)
                          + " rows; allowed: at most " + std::to_string(maxRecordedVisits) + '\n');
        return refused;
    }
    Trajectory trajectory;
    const SimulationResult again = simulate(result.project, &trajectory);
    return save(options.trace, traceCsv(again, trajectory));
}

/// How a run stands, and the exit status of what was wrong with its batch.
struct JudgedAnswer {
    Judgement judgement;
    int status = done;
};

/// Over every stock within one infeed and, with `--batch`, the batch of the project, if it has one.
JudgedAnswer judged(const SurfaceRun& run, const std::string& name, const Options& options) {
    const Project& project = run.result.project;
    std::optional<JudgedBatch> batch;
    int status = done;
    if (options.batch && project.batch && run.isCompleted()) {
        BatchResult result;
        {
            BatchWatch watch(project.batch->parts, false);
            BatchOptions how;
            how.stop = watch.stop();
            how.done = watch.done();
            result = runBatch(project, how);
        }
        if (caughtSignal() != 0) {
            return {{}, interrupted + caughtSignal()};
        }
        if (result.status == BatchStatus::refused) {
            printIssues(name, result.issues);
            status = refused;
        } else {
            batch = judgeBatch(result, summarise(result));
        }
    }
    return {judge(run.result, run.constraints, judgeStocks(run.result), std::move(batch)), status};
}

std::string textOf(const SurfaceRun& run, const Judgement& judgement) {
    return resultText(run.result, run.constraints, JudgementWording().headline(judgement));
}

std::string jsonOf(const SurfaceRun& run, const Judgement& judgement) {
    return judgedResultJson(run.result, run.constraints, judgement);
}

int statusOf(const SurfaceRun& run, const std::string& name, const Options& options) {
    if (!run.isCompleted()) {
        print(stderr, printable(name) + ": " + statusSentence(run.result) + '\n');
        return cannotReachSize;
    }
    return options.check && !run.holds() ? requirementFails : done;
}

int simulateOne(const Project& project, const std::string& name, const Options& options) {
    printUntrueRuns(name, project);
    const SurfaceRun run = runSurface({}, project, {});
    if (!options.trace.empty() && run.result.visits > maxRecordedVisits) {
        return writeTrace(run.result, name, options);
    }
    printIssues(name, remarksOn(run.result));
    const auto [judgement, judgedStatus] = judged(run, name, options);
    if (caughtSignal() != 0) {
        return judgedStatus;
    }
    print(stdout, options.json ? jsonOf(run, judgement) : textOf(run, judgement));
    if (!options.trace.empty()) {
        if (const int failed = writeTrace(run.result, name, options)) {
            return failed;
        }
    }
    const int status = statusOf(run, name, options);
    return status == done ? judgedStatus : status;
}

/// Every surface, each with the wheel as those before have left it, and the times of the part.
int simulateWhole(const Surfaces& surfaces, const Options& options) {
    const SetupRun run = runSetup(surfaces.setup());
    std::vector<Judgement> judgements;
    int status = done;
    for (std::size_t i = 0; i < run.surfaces.size(); ++i) {
        const SurfaceRun& surface = run.surfaces[i];
        const std::string name = surfaces.nameOf(i);
        printUntrueRuns(name, surfaces.setup().surfaces[i].project);
        printIssues(name, remarksOn(surface.result));
        const auto [judgement, judgedStatus] = judged(surface, name, options);
        if (caughtSignal() != 0) {
            return judgedStatus;
        }
        judgements.push_back(judgement);
        if (!options.json) {
            print(stdout, surfaces.heading(i) + textOf(surface, judgement));
        }
        const int one = statusOf(surface, name, options);
        status = status == done ? (one == done ? judgedStatus : one) : status;
    }
    if (!run.issues.empty()) {
        printIssues(surfaces.nameOf(run.surfaces.size()), run.issues);
        status = status == done ? static_cast<int>(refused) : status;
    }
    const auto surfaceJson = [&](const SurfaceRun& surface) {
        const auto place = static_cast<std::size_t>(&surface - run.surfaces.data());
        return jsonOf(surface, judgements[place]);
    };
    print(stdout, options.json ? setupJson(surfaces.setup(), run, surfaceJson)
                               : setupText(surfaces.setup(), run));
    return status;
}

int runSimulate(const Options& options) {
    if (!options.trace.empty() && replacesProject(options.trace, options.operand)) {
        return usageError("--trace would replace a project: " + options.trace);
    }
    const Surfaces surfaces(options.operand, options.surface);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    if (const int failed = options.trace.empty() ? done : surfaces.oneFor("--trace")) {
        return failed;
    }
    return surfaces.isWhole()
               ? simulateWhole(surfaces, options)
               : surfaces.run(
                   [&options](const Project& project, std::size_t, const std::string& name) {
                       return simulateOne(project, name, options);
                   },
                   options.json);
}

/// What stands where an example belongs.
enum class Standing { nothing, sameExample, another };

Standing standingAt(const std::string& file, const std::string& example) {
    const auto content = readFile(pathFromUtf8(file), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&content)) {
        const bool absent = error->systemError == ENOENT || error->systemError == ENOTDIR;
        return absent ? Standing::nothing : Standing::another;
    }
    return std::get<std::string>(content) == example ? Standing::sameExample : Standing::another;
}

int runExamples(const std::string& folder, bool force) {
    std::error_code error; // a folder that cannot be made is reported by the first file
    std::filesystem::create_directory(pathFromUtf8(folder), error);
    std::vector<std::pair<std::string, const Example*>> absent;
    bool edited = false; // all are looked at before the first is written
    for (const Example& example : examples()) {
        std::string file = folder + "/" + example.name;
        const Standing standing = standingAt(file, example.content);
        if (standing == Standing::another && !force) {
            print(stderr, printable(file) + ": differs from the example and is kept\n");
            edited = true;
        }
        if (standing != Standing::sameExample) {
            absent.emplace_back(std::move(file), &example);
        }
    }
    if (edited) {
        print(stderr, "sparkout-cli: nothing was written; --force replaces these files\n");
        return refused;
    }
    for (const auto& [file, example] : absent) {
        if (const int failed = save(file, example->content)) {
            return failed;
        }
        print(stdout, printable(file) + '\n');
    }
    return done;
}

int run(const std::vector<std::string>& arguments) {
    if (arguments.size() == 1 && arguments[0] == "--help") {
        print(stdout, manual::helpText(manual::commandLineProgram()));
        return done;
    }
    if (arguments.size() == 1 && arguments[0] == "--version") {
        print(stdout, "sparkout-cli " + std::string(version) + '\n');
        return done;
    }
    if (!arguments.empty() && arguments[0] == "optimize") {
        return runOptimise({arguments.begin() + 1, arguments.end()});
    }
    if (!arguments.empty() && arguments[0] == "course") {
        return runCourse({arguments.begin() + 1, arguments.end()});
    }
    Options options;
    if (const int failed = parse(arguments, options)) {
        return failed;
    }
    const std::string& command = options.command;
    if (!manual::commandNamed(manual::commandLineProgram(), command)) {
        return usageError(command.empty() ? "a command is needed" : "unknown command " + command);
    }
    if (options.operand.empty()) {
        return usageError(command
                          + (command == "examples" ? " needs a folder"
                             : command == "new"    ? " needs a size with its field, as 35k6"
                                                   : " needs a file"));
    }
    if (command == "new") {
        return runNewCommand(options);
    }
    if (command == "simulate") {
        return runSimulate(options);
    }
    if (command == "remedies") {
        return runRemediesCommand(options);
    }
    if (command == "batch") {
        return runBatchCommand(options);
    }
    if (command == "batch-merge") {
        return runBatchMerge(options);
    }
    if (command == "sweep") {
        return runSweepCommand(options);
    }
    if (command == "phases") {
        return runPhasesCommand(options);
    }
    if (command == "dressing") {
        return runDressingCommand(options);
    }
    if (command == "measured") {
        return runMeasuredCommand(options);
    }
    if (command == "validate") {
        return loadSetup(options.operand) ? done : refused;
    }
    return runExamples(options.operand, options.force);
}

} // namespace

} // namespace sparkout::cli

int main(int argc, char** argv) {
    sparkout::cli::prepareConsole();
    const int status = sparkout::cli::run(sparkout::cli::argumentsOf(argc, argv));
    return sparkout::cli::outputTaken() ? status : sparkout::cli::refused;
}
