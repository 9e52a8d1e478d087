// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/files/safe_file.h"
#include "core/optimisation/search_journal.h"
#include "core/resume/search_state.h"
#include "core/study/search.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>
#include <variant>

namespace sparkout {

/// What a search is of, with the options as they would be typed: not how many threads it has, nor
/// what it does beyond its answer.
[[nodiscard]] SearchQuestion searchQuestion(const Project& project, const SearchWish& wish);

/// What keeps the progress of a search from being kept: the file cannot be read or written, or what
/// stands there is of something else or damaged.
using KeptSearchFault = std::variant<FileError, ReadSearchState>;

/// The progress of a search that isResumable() in a file: read at first, written every second and
/// at the end, so that the search can be killed at any moment and gone on with.
class KeptSearch {
public:
    KeptSearch(std::filesystem::path file, SearchQuestion question)
        : m_file(std::move(file)), m_question(std::move(question)) {}
    KeptSearch(const KeptSearch&) = delete;
    KeptSearch& operator=(const KeptSearch&) = delete;

    /// Called where the file cannot be written though it could be the time before, by one thread at
    /// a time.
    std::function<void(const FileError&)> onFailure;

    /// Reads what was done before, or begins the file where there is none. With a fault what stands
    /// there stays.
    [[nodiscard]] std::optional<KeptSearchFault> open();
    [[nodiscard]] const SearchQuestion& question() const { return m_question; }
    [[nodiscard]] SearchJournal& journal() { return m_journal; } ///< after open()
    void close() { write(m_journal.record()); }                  ///< after the search

private:
    void write(const SearchRecord& record);

    std::filesystem::path m_file;
    SearchQuestion m_question;
    SearchJournal m_journal;
    std::chrono::steady_clock::time_point m_written;
    bool m_failed = false; ///< it could not be written, which was said
};

} // namespace sparkout
