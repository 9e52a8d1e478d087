// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/result.h"

#include <span>
#include <string>

namespace sparkout::cli {

/// "Stepless limit, min        1.552" in the unit of displayed texts; "-" without a value.
[[nodiscard]] std::string outputLine(const OutputRow& row, const OutputValue& value);

/// A line for each displayed output; sparse outputs only if they have a value.
template <class Owner>
[[nodiscard]] std::string outputLines(std::span<const Output<Owner>> rows, const Owner& owner) {
    std::string text;
    for (const Output<Owner>& row : rows) {
        const OutputValue value = row.of(owner);
        if (*row.label && !row.detail && (!row.stated || row.stated(owner))
            && !(row.sparse && value.index() == 0)) {
            text += outputLine(row, value);
        }
    }
    return text;
}

} // namespace sparkout::cli
