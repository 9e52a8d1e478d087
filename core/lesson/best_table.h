// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/file/text_encoding.h"
#include "core/lesson/make_variants.h"
#include "core/lesson/work.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// The tables for giving out variants: the sheet of assignments, for printing and posting, and the
/// teacher's table of best answers, which students must not have.
namespace sparkout {

/// A row of the teacher's table, read again for marking.
struct BestRow {
    int variant = 0;
    std::string name, group;
    VariantLevels levels;
    std::optional<double> best_min;
    std::optional<double> margin_percent;
    std::string digest; ///< variantDigest()
};

struct ReadBestTable {
    std::vector<BestRow> rows;
    std::size_t faultLine = 0; ///< first line that does not belong to such a table; 0: none
};

/// CSV: variant, name, group, and the value of each input that is varied.
[[nodiscard]] std::string assignmentsCsv(const Lesson& lesson, const std::vector<Work>& works);

/// CSV: its first line names the lesson; then for each variant levels, best time and margin, the
/// best cycle, the engine's answers to the steps, and the digest.
[[nodiscard]] std::string bestTableCsv(const Lesson& lesson, const std::vector<Work>& works,
                                       const std::vector<MadeVariant>& variants);

/// Reads the teacher's table again, in either dialect.
[[nodiscard]] ReadBestTable readBestTable(const TableText& table);

/// The name of a student's file: number, name, extension; in letters that any system accepts.
[[nodiscard]] std::string workFileName(const Work& work, std::size_t number);

} // namespace sparkout
