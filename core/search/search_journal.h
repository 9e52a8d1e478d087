// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/search/optimise.h"

#include <cstddef>
#include <functional>
#include <optional>
#include <utility>
#include <vector>

namespace sparkout {

/// Record of full searches, by which they can be resumed.
struct SearchRecord {
    /// Results of the finished searches in the order in which they were begun. One answer takes
    /// several searches where levels are added or it must hold in further scenarios.
    std::vector<SearchCheckpoint> finished;
    std::optional<SearchCheckpoint> begun; ///< the unfinished search after these
};

/// Records the full searches for one answer, and supplies the results of recorded ones: the same
/// project and options give the answer that they would have given without a stop, from where the
/// search was stopped. A record with a cycle that is not in the grid is discarded and the search
/// repeated, as is a record whose best cycle, run once to check it, is not feasible or differs in
/// time or margin.
class SearchJournal {
public:
    explicit SearchJournal(SearchRecord record = {}) : m_record(std::move(record)) {}

    /// Called after each step of the record, by one thread at a time.
    std::function<void(const SearchRecord&)> onStep;

    [[nodiscard]] const SearchRecord& record() const {
        return m_record;
    } ///< only while no search is running
    /// Returns whether a part of the record was discarded and searched anew.
    [[nodiscard]] bool hasRefused() const { return m_hasRefused; }
    /// Called by optimise().
    [[nodiscard]] SearchSummary search(const Project& project, const SearchOptions& options);

private:
    SearchRecord m_record;
    std::size_t m_asked = 0; ///< number of searches so far
    bool m_hasRefused = false;
};

} // namespace sparkout
