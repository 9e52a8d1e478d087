// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/batch_watch.h"
#include "app/cli_io.h"
#include "app/cli_measured.h"
#include "app/cli_report.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/examples.h"
#include "app/manual/given.h"
#include "app/manual/help_text.h"
#include "app/stop_signals.h"
#include "core/batch/judgement.h"
#include "core/file/file_system.h"
#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/printable.h"
#include "core/quality/verdict.h"
#include "core/setup/setup_run.h"
#include "core/simulation/simulate.h"
#include "core/study/whole_batch.h"
#include "core/version.h"
#include "words/judgement_words.h"

#include <cerrno>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout::cli {

namespace {

/// Writes the trace of a cycle by a second run, once its size is known.
int writeTrace(const SimulationResult& result, const std::string& name,
               const manual::Given& given) {
    if (result.visits > maxRecordedVisits) {
        print(stderr, printable(name) + ": the trace would have " + std::to_string(result.visits)
                          + " rows; allowed: at most " + std::to_string(maxRecordedVisits) + '\n');
        return refused;
    }
    Trajectory trajectory;
    const SimulationResult again = simulate(result.project, &trajectory);
    return save(given.text("--trace"), traceCsv(again, trajectory));
}

/// The judgement of a run, and the exit status for faults of its batch.
struct JudgedAnswer {
    Judgement judgement;
    int status = done;
};

/// Judges a run for every stock within one infeed and, with `--batch`, for the project's batch and
/// by its measured parts.
JudgedAnswer judged(const SurfaceRun& run, const std::string& name, const manual::Given& given) {
    BatchJudgement by;
    if (given.has("--batch") && run.isCompleted()) {
        BatchWatch watch(partsOf(run.result.project), false);
        BatchOptions how;
        how.stop = watch.stop();
        how.done = watch.done();
        by = judgeBatchOf(run.result.project, how);
        if (caughtSignal() != 0) {
            return {{}, interrupted + caughtSignal()};
        }
        printIssues(name, by.issues);
    }
    return {judge(run.result, run.constraints, judgeStocks(run.result), std::move(by.batch),
                  by.measured),
            by.issues.empty() ? done : refused};
}

std::string textOf(const SurfaceRun& run, const Judgement& judgement) {
    return resultText(run.result, run.constraints, JudgementWording().headline(judgement));
}

std::string jsonOf(const SurfaceRun& run, const Judgement& judgement) {
    return judgedResultJson(run.result, run.constraints, judgement);
}

int statusOf(const SurfaceRun& run, const std::string& name, const manual::Given& given) {
    if (!run.isCompleted()) {
        print(stderr, printable(name) + ": " + statusSentence(run.result) + '\n');
        return cannotReachSize;
    }
    return given.has("--check") && !run.holds() ? requirementFails : done;
}

int simulateOne(const Project& project, const std::string& name, const manual::Given& given) {
    printUntrueRuns(name, project);
    const SurfaceRun run = runSurface({}, project, {});
    if (given.has("--trace") && run.result.visits > maxRecordedVisits) {
        return writeTrace(run.result, name, given);
    }
    printIssues(name, remarksOn(run.result));
    const auto [judgement, judgedStatus] = judged(run, name, given);
    if (caughtSignal() != 0) {
        return judgedStatus;
    }
    print(stdout, given.has("--json") ? jsonOf(run, judgement) : textOf(run, judgement));
    if (given.has("--trace")) {
        if (const int failed = writeTrace(run.result, name, given)) {
            return failed;
        }
    }
    const int status = statusOf(run, name, given);
    return status == done ? judgedStatus : status;
}

/// Runs every surface with the wheel as the earlier surfaces leave it, and adds the times of the
/// part.
int simulateWhole(const Surfaces& surfaces, const manual::Given& given) {
    const SetupRun run = runSetup(surfaces.setup());
    std::vector<Judgement> judgements;
    int status = done;
    for (std::size_t i = 0; i < run.surfaces.size(); ++i) {
        const SurfaceRun& surface = run.surfaces[i];
        const std::string name = surfaces.nameOf(i);
        printUntrueRuns(name, surfaces.setup().surfaces[i].project);
        printIssues(name, remarksOn(surface.result));
        const auto [judgement, judgedStatus] = judged(surface, name, given);
        if (caughtSignal() != 0) {
            return judgedStatus;
        }
        judgements.push_back(judgement);
        if (!given.has("--json")) {
            print(stdout, surfaces.heading(i) + textOf(surface, judgement));
        }
        const int one = statusOf(surface, name, given);
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
    print(stdout, given.has("--json") ? setupJson(surfaces.setup(), run, surfaceJson)
                                      : setupText(surfaces.setup(), run));
    return status;
}

int runSimulate(const manual::Given& given) {
    if (given.has("--trace") && replacesProject(given.text("--trace"), given.operands.front())) {
        return usageError("--trace would replace a project: " + given.text("--trace"));
    }
    const Surfaces surfaces(given);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    if (const int failed = surfaces.oneFor({"--trace"})) {
        return failed;
    }
    return surfaces.isWhole() ? simulateWhole(surfaces, given)
                              : surfaces.run([&given](const Project& project, std::size_t,
                                                      const std::string& name) {
                                    return simulateOne(project, name, given);
                                });
}

/// The current content of an example's file.
enum class Standing { nothing, sameExample, another };

Standing standingAt(const std::string& file, const std::string& example) {
    const auto content = readFile(pathFromUtf8(file), limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&content)) {
        const bool absent = error->systemError == ENOENT || error->systemError == ENOTDIR;
        return absent ? Standing::nothing : Standing::another;
    }
    return std::get<std::string>(content) == example ? Standing::sameExample : Standing::another;
}

int runExamples(const manual::Given& given) {
    const std::string& folder = given.operands.front();
    std::error_code error; // a folder that cannot be made is reported by the first file
    std::filesystem::create_directory(pathFromUtf8(folder), error);
    std::vector<std::pair<std::string, const Example*>> absent;
    bool edited = false; // all files are checked before the first is written
    for (const Example& example : examples()) {
        std::string file = folder + "/" + example.name;
        const Standing standing = standingAt(file, example.content);
        if (standing == Standing::another && !given.has("--force")) {
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

int runValidate(const manual::Given& given) {
    return loadSetup(given.operands.front(), BatchFaults::errors) ? done : refused;
}

constexpr std::pair<std::string_view, int (*)(const manual::Given&)> commands[] = {
    {"new", runNewCommand},
    {"simulate", runSimulate},
    {"remedies", runRemediesCommand},
    {"optimize", runOptimise},
    {"validate", runValidate},
    {"batch", runBatchCommand},
    {"batch-merge", runBatchMerge},
    {"sweep", runSweepCommand},
    {"phases", runPhasesCommand},
    {"dressing", runDressingCommand},
    {"waves", runWavesCommand},
    {"measured", runMeasuredCommand},
    {"examples", runExamples},
    {"course check", runCourseCheck},
    {"course variants", runCourseVariants},
    {"course grade", runCourseGrade}};

int run(const std::vector<std::string>& arguments) {
    const manual::Program& program = manual::commandLineProgram();
    const manual::Reading reading(program, arguments);
    if (!reading.fault.empty()) {
        return usageError(reading.fault);
    }
    const manual::Given& given = reading.given;
    if (reading.asksForHelp) {
        print(stdout, manual::helpText(program, given.command()));
        return done;
    }
    if (given.command().name == std::string_view(program.name)) { // without a command
        print(stdout, "sparkout-cli " + std::string(version) + '\n');
        return done;
    }
    for (const auto& [name, runCommand] : commands) {
        if (name == given.command().name) {
            return runCommand(given);
        }
    }
    throw std::logic_error("a command of the table does nothing");
}

} // namespace

} // namespace sparkout::cli

int main(int argc, char** argv) {
    sparkout::cli::prepareConsole();
    const int status = sparkout::cli::run(sparkout::cli::argumentsOf(argc, argv));
    return sparkout::cli::outputTaken() ? status : sparkout::cli::refused;
}
