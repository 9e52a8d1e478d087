// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/optimisation/optimise.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

/// What full searches have done, so that they can be gone on with.
struct SearchRecord {
    /// One after the other, as they were begun: what each found. An answer is searched in several
    /// where levels are added or it must hold in further scenarios.
    std::vector<SearchCheckpoint> finished;
    std::optional<SearchCheckpoint> begun; ///< the one after these
};

/// Records the full searches that one question asks for, and answers those that the record has:
/// the same project asked the same again gives the answer it would have given without a stop, from
/// where it was stopped. What in a record is of no cycle of the grid is searched anew. So it is
/// where the best cycle of a record does not hold, or takes another time or has another margin than
/// stand there: it is run once before it counts.
class SearchJournal {
public:
    explicit SearchJournal(SearchRecord record = {}) : m_record(std::move(record)) {}

    /// Called after each step of the record, by one thread at a time.
    std::function<void(const SearchRecord&)> onStep;

    [[nodiscard]] const SearchRecord& record() const { return m_record; } ///< while none is run
    /// Whether something in it was searched anew.
    [[nodiscard]] bool hasRefused() const { return m_hasRefused; }
    /// By optimise().
    [[nodiscard]] SearchSummary search(const Project& project, const SearchOptions& options);

private:
    SearchRecord m_record;
    std::size_t m_asked = 0; ///< searches so far
    bool m_hasRefused = false;
};

} // namespace sparkout
