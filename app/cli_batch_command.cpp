// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands.h"

#include "app/batch_watch.h"
#include "app/cli_batch.h"
#include "app/cli_io.h"
#include "app/stop_signals.h"
#include "core/batch/batch_outputs.h"
#include "core/batch/batch_run.h"
#include "core/batch/batch_state.h"
#include "core/file/blanks_csv.h"
#include "core/file/file_system.h"
#include "core/file/project_file.h"
#include "core/file/safe_file.h"
#include "core/file/strict_json.h"
#include "core/printable.h"
#include "core/project/batch.h"
#include "core/study/whole_batch.h"
#include "words/issue_words.h"

#include <algorithm>
#include <cerrno>
#include <charconv>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout::cli {

namespace {

/// Parses "I/N" with 1 ≤ I ≤ N; empty for any other text.
std::optional<std::pair<int, int>> shardOf(std::string_view text) {
    const char* const end = text.data() + text.size();
    int shard = 0, shards = 0;
    const auto first = std::from_chars(text.data(), end, shard);
    if (first.ec != std::errc() || first.ptr == end || *first.ptr != '/') {
        return std::nullopt;
    }
    const auto second = std::from_chars(first.ptr + 1, end, shards);
    const bool isWhole = second.ec == std::errc() && second.ptr == end;
    return isWhole && shard >= 1 && shard <= shards ? std::optional(std::pair(shard, shards))
                                                    : std::nullopt;
}

int printBatch(const BatchResult& result, const std::optional<SobolIndices>& indices,
               const manual::Given& given) {
    print(stdout, given.has("--json")  ? batchJson(result, indices)
                  : given.has("--csv") ? batchCsv(result)
                                       : batchText(result, indices));
    return given.has("--check") && result.statistics.bad > 0 ? requirementFails : done;
}

/// Puts the measured blanks of a CSV file into the batch; reports a refusal and returns false.
bool putMeasuredFile(const std::string& file, Batch& batch) {
    const auto content = readOrSay(file, limits::fileBytes);
    if (!content) {
        return false;
    }
    const auto blanks = readMeasuredBlanks(*content);
    if (const auto* fault = std::get_if<TableFault>(&blanks)) {
        print(stderr, printable(file) + ": line " + std::to_string(fault->line) + ": "
                          + (fault->text.empty()
                                 ? "no heading is a factor, as stock_mm"
                                 : "not understood: "
                                       + Wording().detail(quoted(nlohmann::json(fault->text))))
                          + '\n');
        return false;
    }
    const auto& columns = std::get<std::vector<MeasuredColumn>>(blanks);
    for (const MeasuredColumn& column : columns) {
        print(stderr, printable(file) + ": " + std::to_string(column.values.size()) + " values of "
                          + factorKey(column.kind) + '\n');
    }
    putMeasured(columns, batch);
    return true;
}

/// Overrides the batch of the file by the options of the command line.
bool putOptions(const manual::Given& given, Project& project) {
    if (!project.batch && !given.has("--measured")) {
        return true; // checkBatch() refuses it
    }
    Batch& batch = project.batch ? *project.batch : project.batch.emplace();
    batch.parts = given.integer("--parts").value_or(batch.parts);
    batch.seed = given.integer("--seed").value_or(batch.seed);
    batch.scenarios = choiceOf<Scenarios>(given, "--scenarios").value_or(batch.scenarios);
    return !given.has("--measured") || putMeasuredFile(given.text("--measured"), batch);
}

/// Whether the project has a batch that can be run; otherwise reports the faults.
bool isReady(const Project& project, const std::string& name, const manual::Given& given) {
    const Issues issues = checkBatch(project);
    printIssues(name, issues);
    if (!issues.empty()) {
        return false;
    }
    if (given.integer("--sensitivity")
        && (project.batch->correlation || scatteredFactors(project).empty())) {
        print(stderr, printable(name) + ": Sobol indices need factors that are not correlated\n");
        return false;
    }
    return true;
}

/// The number of parts of the batch and of the sensitivity, for the progress.
std::int64_t partsToRun(const ScenarioSource& source, const manual::Given& given, PartRange range) {
    const auto factors = static_cast<std::int64_t>(source.factors().size());
    return range.end - range.first + given.integer("--sensitivity").value_or(0) * (factors + 2);
}

/// Reports a failure of the file of --rows, if there is one.
bool failed(const PartRowsFile& rows) {
    if (const auto& error = rows.error()) {
        print(stderr, error->systemError == EEXIST
                          ? printable(error->path) + ": exists; --force replaces it\n"
                          : describe(*error));
    }
    return rows.error().has_value();
}

int runBatchOf(Project project, const std::string& name, const manual::Given& given) {
    if (!putOptions(given, project) || !isReady(project, name, given)) {
        return refused;
    }
    const ScenarioSource source(project);
    const auto shardGiven = shardOf(given.text("--shard"));
    const auto [shard, shards] = shardGiven.value_or(std::pair(1, 1));
    BatchResult result;
    std::optional<SobolIndices> indices;
    std::optional<PartRowsFile> rows;
    if (given.has("--rows")) {
        rows.emplace(pathFromUtf8(given.text("--rows")),
                     given.has("--force") ? SafeFileWriter::Existing::replaced
                                          : SafeFileWriter::Existing::refused,
                     PartRowsFile::Form{});
        if (failed(*rows)) {
            return refused;
        }
    }
    {
        BatchOptions run;
        run.threads = given.integer("--threads").value_or(0);
        run.range = shardRange(source.parts(), shard, shards);
        run.meanWidth_um = given.number("--until-width");
        BatchWatch watch(partsToRun(source, given, *run.range), given.has("--progress"));
        run.stop = watch.stop();
        run.done = watch.done();
        if (rows) {
            run.sink = rows->begin(source, run.stop);
        }
        result = runBatch(project, run);
        if (given.integer("--sensitivity") && !run.stop.stop_requested()) {
            indices = sobolIndices(project, *given.integer("--sensitivity"), run);
        }
    }
    if (rows && (failed(*rows) || (caughtSignal() == 0 && !rows->finish() && failed(*rows)))) {
        return refused;
    }
    int status = done;
    if (shardGiven) {
        print(stdout, writeBatchState(result));
    } else {
        status = printBatch(result, indices, given);
    }
    if (caughtSignal() == 0) {
        return status;
    }
    print(stderr, "sparkout-cli: ended after " + std::to_string(result.statistics.parts) + " of "
                      + std::to_string(source.parts()) + " parts\n");
    return interrupted + caughtSignal();
}

} // namespace

int runBatchCommand(const manual::Given& given) {
    if (given.has("--shard") && !shardOf(given.text("--shard"))) {
        return usageError(given.refusal("--shard"));
    }
    if (given.has("--shard")
        && (given.has("--until-width") || given.has("--sensitivity") || given.has("--check"))) {
        return usageError("--shard excludes --until-width, --sensitivity and --check");
    }
    if (given.has("--rows")
        && (replacesProject(given.text("--rows"), given.operands.front())
            || (given.has("--measured")
                && isSameFile(given.text("--rows"), given.text("--measured"))))) {
        return usageError("--rows would replace what is read: " + given.text("--rows"));
    }
    const Surfaces surfaces(given, BatchFaults::left);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    if (const int failed = surfaces.oneFor({"--rows", "--shard", "--csv", "--measured"})) {
        return failed;
    }
    return surfaces.run([&given](Project project, std::size_t, const std::string& name) {
        return runBatchOf(std::move(project), name, given);
    });
}

int runBatchMerge(const manual::Given& given) {
    const std::vector<std::string>& files = given.operands;
    BatchJoiner joiner;
    for (const std::string& file : files) {
        const auto content = readOrSay(file, limits::shardBytes);
        if (!content) {
            return refused;
        }
        ReadBatchState shard = readBatchState(*content);
        if (!shard) {
            print(stderr, printable(file) + ": " + stateSentence(shard.fault)
                              + (shard.issue ? ": " + printable(shard.issue->path) + ": "
                                                   + issueSentence(*shard.issue)
                                             : std::string())
                              + '\n');
            return refused;
        }
        joiner.add(std::move(*shard.result));
    }
    const JoinedBatch joined = joiner.join();
    if (joined.fault != JoinFault::none) {
        print(stderr, joinText(joined, joiner.shards(), files));
        return refused;
    }
    return printBatch(joined.result, {}, given);
}

} // namespace sparkout::cli
