// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_batch_command.h"
#include "app/cli_optimise.h"
#include "app/cli_phases.h"
#include "app/cli_remedies.h"
#include "app/cli_sweep.h"
#include "app/course/cli_course.h"
#include "app/examples.h"
#include "app/io/cli_io.h"
#include "app/io/cli_kept_runs.h"
#include "app/io/cli_options.h"
#include "app/io/cli_report.h"
#include "app/io/cli_surfaces.h"
#include "app/measured/cli_measured.h"
#include "core/files/safe_file.h"
#include "core/format/project_file.h"
#include "core/printable.h"
#include "core/quality/remarks.h"
#include "core/quality/result_json.h"
#include "core/setup/setup_json.h"
#include "core/simulation/simulate.h"
#include "core/version.h"

#include <cerrno>
#include <csignal>
#include <filesystem>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout::cli {

namespace {

constexpr const char* helpText =
    R"(sparkout-cli: cylindrical grinding cycles, computed pass by pass

  sparkout-cli simulate FILE [--surface NAME|N|all] [--json] [--check] [--trace OUT.csv]
  sparkout-cli remedies FILE [--surface NAME|N|all] [--json]
  sparkout-cli optimize FILE [--surface NAME|N|all] [--robust] [--refine]
                        [--method search|full|dp|labels] [--stages N,…]
                        [--time-limit S] [--threads N] [--json] [-o OUT.sparkout]
  sparkout-cli validate FILE
  sparkout-cli batch FILE [--surface NAME|N|all] [option…] [--shard I/N | --json | --csv]
  sparkout-cli batch-merge SHARD… [--json | --csv] [--check]
  sparkout-cli sweep FILE [--surface NAME|N|all] [--threads N] [--json | --csv] [--progress]
  sparkout-cli phases FILE [--surface NAME|N|all] [--from MM] [--to MM] [--json] [--check]
  sparkout-cli measured FILE [--surface NAME|N|all] [--data TABLE.csv] [--fit PARAMETER,…]
                        [--json] [--check] [--progress]
  sparkout-cli measured FILE [--surface NAME|N|all] [--json] --roundness [--profile TABLE.csv]
                        | --trial PARAMETER,… | --stiffness-sheet
                        | --stiffness TABLE.csv [--indicator part|system]
  sparkout-cli examples DIR [--force]
  sparkout-cli course check FILE [--json]
  sparkout-cli course variants LESSON --group LIST.csv --seed S -d DIR [--force]
  sparkout-cli course grade LESSON DIR [--group LIST.csv] [--answers TABLE.csv] [--csv | --json]
  sparkout-cli --version | --help

simulate   runs the cycle of a project file
  --json     prints one JSON object
  --check    exit status 4 when a requirement fails
  --trace    writes a row for every visit of a radius
             kept runs of the file whose numbers are not the engine's are named on stderr
remedies   finds changes of one setting after which a cycle that fails holds everything, or
           one that is close to a limit has room: up to three, each run, the quickest
           first; where none of the values tried helps, why, with the requirements that fail
  --json     prints one JSON object
optimize   finds the quickest cycle of the file's grid that holds every requirement
  --robust   it must hold for every stock within half an infeed of the stated one, which is
             decided under gauge control; under position control it is tried on 500 of them
             drawn afresh, with the confidence stated; a file whose optimisation says
             scenarios corners or batch is searched for those without it
  --refine   from the grid's best on between its levels, in the machine's steps: a
             quicker cycle that holds, if one is met; it is not proved
  --method   search: proves the answer from few runs; full: runs every cycle;
             for plunge grinding also two heuristics, which prove nothing and may
             find no cycle where there is one: dp, the dynamic programming that
             was published, and labels, which keeps more ways to each stock level
  --stages   numbers of stages to try, instead of the file's
  --time-limit  ends search and refinement after so many seconds, as Ctrl+C does: the
             best so far stays, with the time that no cycle is quicker than
  --threads  of the full search, instead of one a processor; the answer is the same
  --json     prints one JSON object
  -o         writes the project with the cycle found
validate   checks a project file: one line a fault
batch      runs the batch of a project file: its parts differ by the factors given there
  --parts N            parts, instead of the file's
  --seed S             seed, instead of the file's
  --scenarios HOW      corners, latin_hypercube, sobol or random, instead of the file's
  --measured BLANKS    CSV whose columns are headed by factors (stock_mm, initial_runout_mm, …):
                       their values take the place of the file's laws
  --until-width W      ends as soon as every 95 % interval of a mean is W µm wide at most
  --sensitivity N      Sobol indices, from N·(factors + 2) parts more
  --threads N          threads, instead of one a processor; the answer is the same
  --rows OUT.csv       writes a row for every part: its factors, every quantity, every
                       requirement held or not; the same for any number of threads, and
                       no file at all when it is ended by Ctrl+C
  --force              --rows may take the place of a file
  --shard I/N          runs the I-th of N shards and prints it for batch-merge
  --json, --csv        prints one JSON object, or a row for every characteristic
  --check              exit status 4 when a part fails a requirement
  --progress           tells the progress on stderr, also when that is no terminal
           Ctrl+C ends it; what is done until then is evaluated and printed
batch-merge
           joins the shards of a batch: the answer is that of one run; a changed,
           missing, doubled or foreign shard is named and refused. For a cluster with
           Slurm see batch.sbatch among the help's files
sweep      runs the sweep of a project file: one or two inputs varied over their ranges
  --threads N          threads, instead of one a processor; the answer is the same
  --json, --csv        prints one JSON object, or a row for every point
phases     decides for which stocks of the blank the cycle holds every requirement, under gauge
           control: where the last step of a stage falls changes with the stock, and the size
           with it. Every stock of the range is decided, none is sampled
  --from, --to         stocks per side in mm, instead of half the largest infeed of a stage below
                       and above the stock in the file
  --json               prints one JSON object
  --check              exit status 4 when it fails for a stock
measured   holds what was measured, in the file's section measured, against the predicted batch:
           for each zone or section and quantity the mean with its 95 % interval, the
           predicted range, Fisher's ratio of the variances, the share of the parts inside
  --data     reads a table of parts or traces, too: a CSV file in either dialect whose headings
             name quantities and units ("Diameter, mm", "Диаметр, мм", "t, s", "P [kW]"), or lines
             time|key|value
  --fit      finds parameters from the traces and diameters: alpha, beta, compliance (of all, or
             compliance:N of one zone or section), flow_stress, dullness, chip_power,
             friction_power, idle_power, size_offset, time_shift, blank_runout; names what the
             data cannot tell and what to measure
  --roundness  instead: the form of each zone or section after the cycle as a roundness machine
             states it, about the four reference circles, not filtered and after the Gaussian
             filter of ISO 16610-21 at 15, 50 and 150 undulations per revolution
  --profile  the same of a recorded section beside it: a table of angle [°] and radius [mm], or
             of deviations where the heading names µm
  --trial    instead: which short trial of 24 tells these parameters best, by feed, spark-out and
             what is recorded, with the 95 % intervals to expect
  --stiffness-sheet  instead: the steps, places and load of a stiffness trial
  --stiffness  instead: stiffness of headstock and tailstock from a table of place [mm], load [N]
             and deflection [µm]
  --indicator  part: it shows the part against the bed; system: against the wheel head, whose
             stiffness three places give too, with two it is the file's
  --json     prints one JSON object
  --check    exit status 4 when the model disagrees with the parts, or the data cannot tell
             a parameter
examples   writes the example projects into a folder, which is made if need be;
           where one of them was edited there, nothing is written
  --force    replaces those that were edited
course     laboratory works for a class; a lesson is a file .sparkout-lesson
  check      of a lesson: its faults, and what each step finds in its project as given; of a
             student's work (.sparkout-work): its seals and answers; of a project: its kept runs.
             Exit status 4 when a seal is broken or a kept run's numbers are not the engine's
  variants   makes a work for each student of a list (CSV with name and group): valid, not solved
             as given, solved by a proved best cycle near to the lesson's in time and margin, no
             two alike; the same seed gives the same. Beside them assignments.csv to hand out and
             teacher-best-answers.csv to keep. Where no variant is found, says which condition
             refused how many of the tries, with exit status 5
  grade      marks the works of a folder: every answer computed again from the lesson, points by
             step, hints paid, time beside the proved best; edited, foreign and copied works
             named, with --group the missing ones too
  --answers  the table of best answers; without it they are searched for
  --csv, --json  a row for every work, or one JSON object
  --force    works that are there are replaced

A file may hold several surfaces of a part that are ground in one set-up. simulate, remedies,
optimize, batch, sweep, phases and measured take each in its order, or the one that --surface
names, by its name or its number from 1; the wheel comes to it as the surfaces before have
left it. A time limit holds for each surface.

Sections of a plunge and parts of a batch are counted from 0, as in the file; in the window and
its reports from 1.

Exit status: 0 done; 1 the input is refused; 2 usage; 3 the cycle cannot reach size;
4 a requirement fails (--check); 5 no cycle of the grid is feasible; 130 or 143 a batch,
sweep or search for remedies ended by Ctrl+C or SIGTERM, or a decision on phases.

A batch on a cluster, here with Slurm: batch.sbatch in resources/help.
)";

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
    print(stdout, options.json ? resultJson(run.result, run.constraints)
                               : resultText(run.result, run.constraints));
    if (!options.trace.empty()) {
        if (const int failed = writeTrace(run.result, name, options)) {
            return failed;
        }
    }
    return statusOf(run, name, options);
}

/// Every surface, each with the wheel as those before have left it, and the times of the part.
int simulateWhole(const Surfaces& surfaces, const Options& options) {
    const SetupRun run = runSetup(surfaces.setup());
    int status = done;
    for (std::size_t i = 0; i < run.surfaces.size(); ++i) {
        const SurfaceRun& surface = run.surfaces[i];
        const std::string name = surfaces.nameOf(i);
        printUntrueRuns(name, surfaces.setup().surfaces[i].project);
        printIssues(name, remarksOn(surface.result));
        if (!options.json) {
            print(stdout, surfaces.heading(i) + resultText(surface.result, surface.constraints));
        }
        const int one = statusOf(surface, name, options);
        status = status == done ? one : status;
    }
    if (!run.issues.empty()) {
        printIssues(surfaces.nameOf(run.surfaces.size()), run.issues);
        status = status == done ? static_cast<int>(refused) : status;
    }
    print(stdout,
          options.json ? setupJson(surfaces.setup(), run) : setupText(surfaces.setup(), run));
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
    const auto content = readFile(file, limits::fileBytes);
    if (const auto* error = std::get_if<FileError>(&content)) {
        const bool absent = error->systemError == ENOENT || error->systemError == ENOTDIR;
        return absent ? Standing::nothing : Standing::another;
    }
    return std::get<std::string>(content) == example ? Standing::sameExample : Standing::another;
}

int runExamples(const std::string& folder, bool force) {
    std::error_code error; // a folder that cannot be made is reported by the first file
    std::filesystem::create_directory(folder, error);
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
        print(stdout, helpText);
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
    if (command != "simulate" && command != "validate" && command != "remedies"
        && command != "batch" && command != "batch-merge" && command != "sweep"
        && command != "measured" && command != "phases" && command != "examples") {
        return usageError(command.empty() ? "a command is needed" : "unknown command " + command);
    }
    if (options.operand.empty()) {
        return usageError(command + (command == "examples" ? " needs a folder" : " needs a file"));
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
    std::signal(SIGPIPE, SIG_IGN); // a closed pipe is a write error, reported as one
    const int status = sparkout::cli::run({argv + (argc > 0 ? 1 : 0), argv + argc});
    return sparkout::cli::outputTaken() ? status : sparkout::cli::refused;
}
