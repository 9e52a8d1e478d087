// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/batch/part_table.h"
#include "core/files/safe_file_writer.h"

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

} // namespace sparkout
