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

/// A CSV file with a row for every part of a batch, written while the parts are run: there may be
/// more than the memory holds. It is there once it is finished.
class PartRowsFile {
public:
    /// How numbers, words and the heads of the columns are written.
    struct Form {
        PartTable::Dialect dialect = {};
        std::function<std::vector<std::string>(const PartColumns&)> head = PartTable::keys;
    };
    /// The share of the parts that is done; false: no more of them are wanted.
    using KeepGoing = std::function<bool(double share)>;

    PartRowsFile(const std::filesystem::path& path, SafeFileWriter::Existing existing, Form form)
        : m_file(path, existing), m_form(std::move(form)) {}

    /// Writes the head of the table and says what takes the parts, for BatchOptions::sink: it wants
    /// no more when the file cannot be written. The file must outlive it.
    [[nodiscard]] PartSink begin(const ScenarioSource& source, const std::stop_token& stop);
    bool finish() { return m_file.finish(); } ///< false: see error()
    /// Runs the whole batch of a project into the file. False: it was stopped, refused, or see
    /// error().
    [[nodiscard]] bool runBatch(const Project& project, BatchOptions options,
                                const KeepGoing& keepGoing);

    [[nodiscard]] const std::optional<FileError>& error() const { return m_file.error(); }

private:
    SafeFileWriter m_file;
    Form m_form;
    std::unique_ptr<PartTable> m_table;
};

} // namespace sparkout
