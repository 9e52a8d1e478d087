// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/batch/batch_statistics.h"
#include "core/batch/batch_summary.h"
#include "core/batch/judgement.h"
#include "core/batch/sensitivity.h"
#include "core/file/safe_file.h"
#include "core/issue.h"
#include "core/project/given_factors.h"
#include "core/study/outcome.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace sparkout {

/// A CSV file with a row for every part of a batch, written during the run, as there may be more
/// parts than fit into memory. The file exists once it is finished.
class PartRowsFile {
public:
    /// Format of numbers and words, and the heads of the columns.
    struct Form {
        PartTable::Dialect dialect = {};
        std::function<std::vector<std::string>(const PartColumns&)> head = PartTable::keys;
    };
    /// Receives the finished share of the parts; returns false to end the run.
    using KeepGoing = std::function<bool(double share)>;

    PartRowsFile(const std::filesystem::path& path, SafeFileWriter::Existing existing, Form form)
        : m_file(path, existing), m_form(std::move(form)) {}

    /// Writes the head of the table and returns the sink for BatchOptions::sink, which ends the
    /// batch when the file cannot be written. The file must outlive the sink.
    [[nodiscard]] PartSink begin(const ScenarioSource& source, const std::stop_token& stop);
    bool finish() { return m_file.finish(); } ///< false: see error()
    /// Writes the whole batch of a project to the file. Returns false when it was stopped or
    /// refused, or after an error: see error().
    [[nodiscard]] bool runBatch(const Project& project, BatchOptions options,
                                const KeepGoing& keepGoing);

    [[nodiscard]] const std::optional<FileError>& error() const { return m_file.error(); }

private:
    SafeFileWriter m_file;
    Form m_form;
    std::unique_ptr<PartTable> m_table;
};

/// All results of one batch, as an immutable value. With issues nothing was run.
struct BatchOutcome {
    Issues issues; ///< reasons why the batch cannot be run
    BatchResult result;
    BatchSummary summary;
    std::vector<std::optional<RankRegression>> regressions; ///< by characteristic
    std::vector<GivenFactor> factors;
    std::vector<std::vector<double>> drawn; ///< values of the factors, by recorded part
    std::vector<Undecided> notDecided;      ///< requirements that cannot be decided for any part

    [[nodiscard]] bool ran() const { return issues.empty(); }

    // Quantities of a part by number: the factors, then the characteristics.
    [[nodiscard]] std::size_t quantityCount() const {
        return factors.size() + summary.characteristics.size();
    }
    [[nodiscard]] const Characteristic* characteristicOf(std::size_t quantity) const; ///< or null
    /// Returns a quantity of the part in a kept row.
    [[nodiscard]] double valueOf(std::size_t row, std::size_t quantity) const;
    [[nodiscard]] bool isOutside(std::size_t row, std::size_t quantity) const; ///< its limits
};

using BatchOutcomePtr = std::shared_ptr<const BatchOutcome>;

/// Checks and runs the batch of a project, in this thread.
[[nodiscard]] BatchOutcomePtr runWholeBatch(const Project& project,
                                            const BatchOptions& options = {});

/// Returns the number of parts in the batch of a project.
[[nodiscard]] std::int64_t partsOf(const Project& project);

/// Returns the number of parts needed for Sobol indices.
[[nodiscard]] std::int64_t partsOfIndices(const Project& project, int points);

/// Judges an outcome for every stock within one infeed, for a batch of the same inputs, and by
/// measured parts compared with a predicting batch; both batches may be null. Decides the stocks
/// itself, since reports wait for the decision.
[[nodiscard]] Judgement judgementOf(const Outcome& outcome, const BatchOutcome* batch = nullptr,
                                    const BatchOutcome* predicting = nullptr);

/// The judgements of a run by a batch.
struct BatchJudgement {
    Issues issues;                    ///< reasons why the batch cannot be run
    std::optional<JudgedBatch> batch; ///< of the project's batch; empty if it has none
    /// Of the project's measured parts, if there are any; empty also after a stop.
    std::optional<MeasuredBias> measured;
};

/// Runs the batch of a project for judge(). It is run once: measured parts are predicted by the
/// batch of predictingProject(), whose parts are the same and as good. Without a batch and measured
/// parts nothing is run.
[[nodiscard]] BatchJudgement judgeBatchOf(const Project& project, const BatchOptions& options = {});

} // namespace sparkout
