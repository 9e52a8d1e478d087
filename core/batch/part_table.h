// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/characteristics.h"
#include "core/batch/scenario_source.h"
#include "core/tables/table_reader.h"

#include <array>
#include <stop_token>
#include <string>
#include <vector>

namespace sparkout {

/// The columns of a table of parts, besides the part's number, its outcome, whether it is good and
/// its least relative margin.
struct PartColumns {
    std::vector<GivenFactor> factors;
    std::vector<Characteristic> characteristics;
    std::vector<ConstraintKind> requirements; ///< by kind, anywhere on the part

    /// Runs the nominal part to find out which settings are required.
    [[nodiscard]] static PartColumns of(const ScenarioSource& source,
                                        const std::stop_token& stop = {});
};

/// "rz1", "section 3" (from 0), or "part".
[[nodiscard]] std::string placeKey(const Characteristic& characteristic);

/// Parts of a batch as lines of CSV.
class PartTable {
public:
    /// The format of numbers and words.
    struct Dialect {
        TableDialect table = {};
        std::string begin, lineEnd = "\n"; ///< of the file, of every line
        /// Completed, does not reach size, completed with strips uncut.
        std::array<std::string, 3> states{"completed", "cannot_reach_size", "strips_uncut"};
        std::string yes = "true", no = "false";
        int firstPart = 0; ///< number of the first part
    };

    PartTable(PartColumns columns, Dialect dialect)
        : m_columns(std::move(columns)), m_dialect(std::move(dialect)) {}

    /// Names of the columns in files: not translated.
    [[nodiscard]] static std::vector<std::string> keys(const PartColumns& columns);
    [[nodiscard]] std::string head(const std::vector<std::string>& names) const;
    /// Numbers that read back as the same double. Cells without a number are empty: for a part that
    /// does not reach size all but its factors, where strips stay uncut the sizes, form and
    /// roughness, and whatever is not required of this part.
    [[nodiscard]] std::string line(const PartRecord& record) const;

private:
    PartColumns m_columns;
    Dialect m_dialect;
};

} // namespace sparkout
