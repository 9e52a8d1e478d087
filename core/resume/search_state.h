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
    otherEngine,
    otherProject,
    otherOptions
};

struct ReadSearchState {
    SearchStateFault fault = SearchStateFault::none;
    SearchQuestion question; ///< as far as it was read
    SearchRecord record;
};

/// Reads it back, for the question that is asked now.
[[nodiscard]] ReadSearchState readSearchState(std::string_view text, const SearchQuestion& asked);

} // namespace sparkout
