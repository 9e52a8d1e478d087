// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/search_journal.h"

#include <optional>
#include <string>
#include <string_view>

/// The record of a full search as text, to be gone on with by another run of the program.
namespace sparkout {

inline constexpr const char* searchStateFormat = "sparkout-search";
inline constexpr int searchStateVersion = 1;

/// What a record is of: only the same question has the same answer.
struct SearchQuestion {
    std::string engine;  ///< buildId()
    std::string project; ///< projectDigest()
    std::string options; ///< as they would be typed
    friend bool operator==(const SearchQuestion&, const SearchQuestion&) = default;
};

/// One line of JSON with its checksum, bit for bit: equal records, equal bytes.
[[nodiscard]] std::string writeSearchState(const SearchQuestion& question,
                                           const SearchRecord& record);

/// Why a text is no record to go on with.
enum class SearchStateFault {
    none,
    otherFormat,  ///< not of this kind at all
    otherVersion, ///< of a version that this one does not read
    changed,      ///< cut off, or its checksum is not that of its contents
    badValue,     ///< a value is none that a search has; see ReadSearchState::value
    otherEngine,
    otherProject,
    otherOptions
};

/// A value of a text that is out of its range, or of another kind.
struct BadStateValue {
    std::string path;  ///< JSON pointer, "/finished/0/evaluations"
    std::string found; ///< as it stands there
    std::string least, most;
};

struct ReadSearchState {
    SearchStateFault fault = SearchStateFault::none;
    SearchQuestion question; ///< as far as it was read
    BadStateValue value;     ///< of a bad value
    SearchRecord record;
};

/// Reads it back, for the question that is asked now. Whether its cycles are of the grid and take
/// the times that stand there is for SearchJournal to find out.
[[nodiscard]] ReadSearchState readSearchState(std::string_view text, const SearchQuestion& asked);

} // namespace sparkout
