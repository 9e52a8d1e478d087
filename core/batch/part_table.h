// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/part_record.h"
#include "core/batch/scenario_source.h"
#include "core/tables/table_reader.h"

#include <array>
#include <stop_token>
#include <string>
#include <vector>

namespace sparkout {

/// What a table of parts has columns for, beside the number of the part, what became of it, whether
/// it is good and its least relative margin.
struct PartColumns {
    std::vector<GivenFactor> factors;
    std::vector<Characteristic> characteristics;
    std::vector<ConstraintKind> requirements; ///< by kind, wherever on the part

    /// Runs the nominal part, which says what of the settings is required.
    [[nodiscard]] static PartColumns of(const ScenarioSource& source,
                                        const std::stop_token& stop = {});
};

/// "rz1", "section 3" (from 0), or "part".
[[nodiscard]] std::string placeKey(const Characteristic& characteristic);

/// Parts of a batch as lines of CSV.
class PartTable {
public:
    /// How numbers and words are written.
    struct Dialect {
        TableDialect table = {};
        std::string begin, lineEnd = "\n"; ///< of the file, of every line
        /// Done, does not reach size, done but strips stay uncut.
        std::array<std::string, 3> states{"completed", "cannot_reach_size", "strips_uncut"};
        std::string yes = "true", no = "false";
        int firstPart = 0; ///< its number
    };

    PartTable(PartColumns columns, Dialect dialect)
        : m_columns(std::move(columns)), m_dialect(std::move(dialect)) {}

    /// Names of the columns in files: the same in every language.
    [[nodiscard]] static std::vector<std::string> keys(const PartColumns& columns);
    [[nodiscard]] std::string head(const std::vector<std::string>& names) const;
    /// Numbers read back as the same double. Cells stay empty where there is no number: of a part
    /// that does not reach size all but its factors, where strips stay uncut the sizes, form and
    /// roughness, and what is not required of this part.
    [[nodiscard]] std::string line(const PartRecord& record) const;

private:
    PartColumns m_columns;
    Dialect m_dialect;
};

} // namespace sparkout
