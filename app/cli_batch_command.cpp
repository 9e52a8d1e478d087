// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli_batch_command.h"

#include "app/cli_batch.h"
#include "app/io/batch_watch.h"
#include "app/io/cli_io.h"
#include "app/io/cli_surfaces.h"
#include "app/io/stop_signals.h"
#include "core/batch/batch_check.h"
#include "core/batch/batch_json.h"
#include "core/batch/batch_state_reader.h"
#include "core/files/file_system.h"
#include "core/files/safe_file_writer.h"
#include "core/format/blanks_csv.h"
#include "core/format/project_file.h"
#include "core/format/strict_json.h"
#include "core/printable.h"
#include "core/project/batch.h"
#include "core/study/part_rows_file.h"
#include "words/issue_words.h"

#include <algorithm>
#include <cerrno>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace sparkout::cli {

namespace {

int printBatch(const BatchResult& result, const std::optional<SobolIndices>& indices,
               const Options& options) {
    print(stdout, options.json  ? batchJson(result, indices)
                  : options.csv ? batchCsv(result)
                                : batchText(result, indices));
    return options.check && result.statistics.bad > 0 ? requirementFails : done;
}

/// Puts the measured blanks of a CSV into the batch; false: refused, which is said.
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

/// Puts what the command line says in place of what the file says.
bool putOptions(const Options& options, Project& project) {
    if (!project.batch && options.measured.empty()) {
        return true; // which checkBatch() refuses
    }
    Batch& batch = project.batch ? *project.batch : project.batch.emplace();
    batch.parts = options.parts.value_or(batch.parts);
    batch.seed = options.seed.value_or(batch.seed);
    batch.scenarios = options.scenarios.value_or(batch.scenarios);
    return options.measured.empty() || putMeasuredFile(options.measured, batch);
}

/// Whether the project has a batch that can be run; says what is wrong with it.
bool isReady(const Project& project, const std::string& name, const Options& options) {
    const Issues issues = checkBatch(project);
    printIssues(name, issues);
    if (!issues.empty()) {
        return false;
    }
    if (options.sensitivity && (project.batch->correlation || scatteredFactors(project).empty())) {
        print(stderr, printable(name) + ": Sobol indices need factors that are not correlated\n");
        return false;
    }
    return true;
}

/// Parts of the batch and of the sensitivity, which the progress is told of.
std::int64_t partsToRun(const ScenarioSource& source, const Options& options, PartRange range) {
    const auto factors = static_cast<std::int64_t>(source.factors().size());
    return range.end - range.first + options.sensitivity.value_or(0) * (factors + 2);
}

/// Says why the file of --rows failed, if it did.
bool failed(const PartRowsFile& rows) {
    if (const auto& error = rows.error()) {
        print(stderr, error->systemError == EEXIST
                          ? printable(error->path) + ": there already; --force replaces it\n"
                          : describe(*error));
    }
    return rows.error().has_value();
}

int runBatchOf(Project project, const std::string& name, const Options& options) {
    if (!putOptions(options, project) || !isReady(project, name, options)) {
        return refused;
    }
    const ScenarioSource source(project);
    const auto [shard, shards] = options.shard.value_or(std::pair(1, 1));
    BatchResult result;
    std::optional<SobolIndices> indices;
    std::optional<PartRowsFile> rows;
    if (!options.rows.empty()) {
        rows.emplace(pathFromUtf8(options.rows),
                     options.force ? SafeFileWriter::Existing::replaced
                                   : SafeFileWriter::Existing::refused,
                     PartRowsFile::Form{});
        if (failed(*rows)) {
            return refused;
        }
    }
    {
        BatchOptions run;
        run.threads = options.threads.value_or(0);
        run.range = shardRange(source.parts(), shard, shards);
        run.meanWidth_um = options.untilWidth_um;
        BatchWatch watch(partsToRun(source, options, *run.range), options.progress);
        run.stop = watch.stop();
        run.done = watch.done();
        if (rows) {
            run.sink = rows->begin(source, run.stop);
        }
        result = runBatch(project, run);
        if (options.sensitivity && !run.stop.stop_requested()) {
            indices = sobolIndices(project, *options.sensitivity, run);
        }
    }
    if (rows && (failed(*rows) || (caughtSignal() == 0 && !rows->finish() && failed(*rows)))) {
        return refused;
    }
    int status = done;
    if (options.shard) {
        print(stdout, writeBatchState(result));
    } else {
        status = printBatch(result, indices, options);
    }
    if (caughtSignal() == 0) {
        return status;
    }
    print(stderr, "sparkout-cli: ended after " + std::to_string(result.statistics.parts) + " of "
                      + std::to_string(source.parts()) + " parts\n");
    return interrupted + caughtSignal();
}

} // namespace

int runBatchCommand(const Options& options) {
    if (!options.rows.empty()
        && (replacesProject(options.rows, options.operand)
            || (!options.measured.empty() && isSameFile(options.rows, options.measured)))) {
        return usageError("--rows would replace what is read: " + options.rows);
    }
    const Surfaces surfaces(options.operand, options.surface);
    if (surfaces.status() != done) {
        return surfaces.status();
    }
    for (const auto& [isGiven, option] :
         {std::pair(!options.rows.empty(), "--rows"),
          std::pair(options.shard.has_value(), "--shard"), std::pair(options.csv, "--csv"),
          std::pair(!options.measured.empty(), "--measured")}) {
        if (const int failed = isGiven ? surfaces.oneFor(option) : done) {
            return failed;
        }
    }
    return surfaces.run(
        [&options](Project project, std::size_t, const std::string& name) {
            return runBatchOf(std::move(project), name, options);
        },
        options.json);
}

int runBatchMerge(const Options& options) {
    std::vector<std::string> files = options.operands;
    files.insert(files.begin(), options.operand);
    BatchJoiner joiner;
    for (const std::string& file : files) {
        constexpr std::size_t largestShard = std::size_t{256} << 20;
        const auto content = readOrSay(file, largestShard);
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
    return printBatch(joined.result, {}, options);
}

} // namespace sparkout::cli
