// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/studies.h"
#include "ui/tables/xlsx_book.h"

#include <QString>

#include <optional>
#include <vector>

/// What a batch, a sweep or a search came to, as tables: nothing is computed here.
namespace sparkout {

enum class StudyKind { batch, sweep, search };
inline constexpr std::array allStudyKinds{StudyKind::batch, StudyKind::sweep, StudyKind::search};

/// One that was run, with all it has to be told with. Exactly one outcome is given.
struct Study {
    BatchOutcomePtr batch = {};
    SobolIndicesPtr indices = {}; ///< of the batch, where they were computed
    SweepResultPtr sweep = {};
    SearchOutcomePtr search = {};
    std::optional<double> before_s = {}; ///< the time of the cycle that the search is held against

    [[nodiscard]] StudyKind kind() const {
        return batch ? StudyKind::batch : sweep ? StudyKind::sweep : StudyKind::search;
    }
    [[nodiscard]] const Project& project() const {
        return batch ? batch->result.project : sweep ? sweep->project : search->project;
    }
};

[[nodiscard]] const char* studyKey(StudyKind kind); ///< on the command line
[[nodiscard]] QString studyName(StudyKind kind);    ///< "Batch"
[[nodiscard]] QString studyNote(StudyKind kind);    ///< what its sheets hold

/// Every table on a sheet of its own.
[[nodiscard]] Book studyBook(const Study& study);

/// The one that a CSV file holds: a row a characteristic, a point or a cycle.
[[nodiscard]] Sheet studyMainSheet(const Study& study);

} // namespace sparkout
