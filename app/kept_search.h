// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/search_journal.h"
#include "core/resume/search_state.h"

#include <chrono>
#include <optional>
#include <string>

namespace sparkout::cli {

/// The progress of a full search in a file: read at first, written every second and at the end, so
/// that the search can be killed at any moment and gone on with.
class KeptSearch {
public:
    explicit KeptSearch(std::string file) : m_file(std::move(file)) {}

    /// Reads what was done before, or begins the file where there is none. Not `done`: what stands
    /// there is of something else or damaged and stays, or the file cannot be written; it is said.
    [[nodiscard]] int open(const SearchQuestion& question);
    [[nodiscard]] SearchJournal* journal() { return m_journal ? &*m_journal : nullptr; }
    /// After the search.
    void close();

private:
    void write(const SearchRecord& record);

    std::string m_file;
    SearchQuestion m_question;
    std::optional<SearchJournal> m_journal;
    std::chrono::steady_clock::time_point m_written;
    bool m_failed = false; ///< it could not be written, which was said
};

} // namespace sparkout::cli
