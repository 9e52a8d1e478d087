// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/make_variants.h"
#include "core/course/variant.h"
#include "core/course/work.h"
#include "core/tables/table_text.h"

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

/// The tables that variants are given out with: the sheet of assignments, to be printed and pinned
/// up, and the teacher's table of best answers, which no student is to have.
namespace sparkout {

/// A row of the teacher's table, as it is read again for marking.
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
    std::size_t faultLine = 0; ///< of a line that is none of such a table; 0: it was read
};

/// CSV: variant, name, group, and the value of each input that is varied.
[[nodiscard]] std::string assignmentsCsv(const Lesson& lesson, const std::vector<Work>& works);

/// CSV: its first line says whose it is; then for each variant levels, best time and margin, the
/// best cycle, the answers of the steps by the engine, and the digest.
[[nodiscard]] std::string bestTableCsv(const Lesson& lesson, const std::vector<Work>& works,
                                       const std::vector<MadeVariant>& variants);

/// Reads the teacher's table again, in either dialect.
[[nodiscard]] ReadBestTable readBestTable(const TableText& table);

/// The name of a student's file: number, name, extension; of letters that any system takes.
[[nodiscard]] std::string workFileName(const Work& work, std::size_t number);

} // namespace sparkout
