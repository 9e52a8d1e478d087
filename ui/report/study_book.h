// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/session/studies.h"
#include "ui/table/sheet.h"

#include <QString>

#include <optional>
#include <vector>

/// The results of a batch, a sweep or a search as tables, without further computation.
namespace sparkout {

enum class StudyKind { batch, sweep, search };
inline constexpr std::array allStudyKinds{StudyKind::batch, StudyKind::sweep, StudyKind::search};

/// A completed study with the data for its description. Exactly one outcome is given.
struct Study {
    BatchOutcomePtr batch = {};
    SobolIndicesPtr indices = {}; ///< indices of the batch, if they were computed
    SweepResultPtr sweep = {};
    SearchOutcomePtr search = {};
    std::optional<double> before_s = {}; ///< time of the cycle compared with the search

    [[nodiscard]] StudyKind kind() const {
        return batch ? StudyKind::batch : sweep ? StudyKind::sweep : StudyKind::search;
    }
    [[nodiscard]] const Project& project() const {
        return batch ? batch->result.project : sweep ? sweep->project : search->project;
    }
};

[[nodiscard]] const char* studyKey(StudyKind kind); ///< on the command line
[[nodiscard]] QString studyName(StudyKind kind);    ///< "Batch"
[[nodiscard]] QString studyNote(StudyKind kind);    ///< the contents of its sheets

/// Every table on a sheet of its own.
[[nodiscard]] Book studyBook(const Study& study);

/// The table for a CSV file: a row for each characteristic, point or cycle.
[[nodiscard]] Sheet studyMainSheet(const Study& study);

} // namespace sparkout
