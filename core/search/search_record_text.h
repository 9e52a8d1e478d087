// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/search_journal.h"

#include <optional>
#include <string>
#include <string_view>

/// The record of a full search as text, from which another run of the program can resume it.
namespace sparkout {

inline constexpr const char* searchStateFormat = "sparkout-search";
inline constexpr int searchStateVersion = 1;

/// The question that a record belongs to: only the same question has the same answer.
struct SearchQuestion {
    std::string engine;  ///< buildId()
    std::string project; ///< projectDigest()
    std::string options; ///< as typed
    friend bool operator==(const SearchQuestion&, const SearchQuestion&) = default;
};

/// Returns one line of JSON with its checksum; equal records give equal bytes.
[[nodiscard]] std::string writeSearchState(const SearchQuestion& question,
                                           const SearchRecord& record);

/// Reason why a search cannot be resumed from a text.
enum class SearchStateFault {
    none,
    otherFormat,  ///< not a search record
    otherVersion, ///< a version that this program does not read
    changed,      ///< truncated, or the checksum does not match the contents
    badValue,     ///< a value is invalid; see ReadSearchState::value
    otherEngine,
    otherProject,
    otherOptions
};

/// A value of a text that is out of range or has the wrong type.
struct BadStateValue {
    std::string path;  ///< JSON pointer, "/finished/0/evaluations"
    std::string found; ///< as written in the text
    std::string least, most;
};

struct ReadSearchState {
    SearchStateFault fault = SearchStateFault::none;
    SearchQuestion question; ///< as far as it was read
    BadStateValue value;     ///< the invalid value
    SearchRecord record;
};

/// Reads a record for the given question. SearchJournal checks whether its cycles belong to the
/// grid and have the times stated.
[[nodiscard]] ReadSearchState readSearchState(std::string_view text, const SearchQuestion& asked);

} // namespace sparkout
