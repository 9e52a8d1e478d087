// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/file/text_encoding.h"

#include <QString>

#include <variant>
#include <vector>

/// Reading a measured profile from the text of a table.
namespace sparkout {

/// Why a text is not a valid profile.
struct ProfileCsvFault {
    enum class What { notANumber, outOfRange, count };
    What what = What::notANumber;
    int line = 0;  ///< from 1, for notANumber and outOfRange
    QString text;  ///< text found there
    int count = 0; ///< number of values, for What::count
};

using ProfileCsv = std::variant<std::vector<double>, ProfileCsvFault>;

/// The values of a table: a number on each line, or the last column of lines separated by
/// semicolons, tabs or commas. Decimal commas and points are distinguished from separators; blank
/// lines and a header line are skipped. The number of values must be allowed for
/// part.radii_per_section: even, 4…360.
[[nodiscard]] ProfileCsv readProfileCsv(const TableText& text);

[[nodiscard]] QString profileCsvFaultText(const ProfileCsvFault& fault);

} // namespace sparkout
