// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/safe_file.h"
#include "core/search/search_journal.h"
#include "core/search/search_record_text.h"
#include "core/study/search.h"

#include <chrono>
#include <filesystem>
#include <functional>
#include <optional>
#include <utility>
#include <variant>

namespace sparkout {

/// Returns the question of a search, with its options as typed on the command line; the number of
/// threads and everything beyond the answer are left out.
[[nodiscard]] SearchQuestion searchQuestion(const Project& project, const SearchWish& wish);

/// Reason why the progress of a search cannot be kept: the file cannot be read or written, or its
/// contents are damaged or belong to another search.
using KeptSearchFault = std::variant<FileError, ReadSearchState>;

/// The progress of an isResumable() search in a file: read at first, written every second and at
/// the end, so that the search can be killed at any moment and resumed.
class KeptSearch {
public:
    static constexpr std::size_t mostBytes = std::size_t{1} << 20; ///< of the file

    KeptSearch(std::filesystem::path file, SearchQuestion question)
        : m_file(std::move(file)), m_question(std::move(question)) {}
    KeptSearch(const KeptSearch&) = delete;
    KeptSearch& operator=(const KeptSearch&) = delete;

    /// Called when the file can no longer be written, by one thread at a time.
    std::function<void(const FileError&)> onFailure;

    /// Reads the earlier progress, or creates the file where there is none. With a fault the file
    /// stays as it is.
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
    bool m_failed = false; ///< the last write failed and was reported
};

} // namespace sparkout
