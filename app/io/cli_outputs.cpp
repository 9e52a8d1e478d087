// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/io/cli_outputs.h"

#include "app/io/cli_report.h"
#include "core/digits.h"

namespace sparkout::cli {

std::string outputLine(const OutputRow& row, const OutputValue& value) {
    constexpr std::size_t labelWidth = 54;
    constexpr int digits = 4;
    std::string line = row.label;
    line += *row.unitShown() ? std::string(", ") + row.unitShown() : std::string();
    line += std::string(line.size() < labelWidth ? labelWidth - line.size() : 1, ' ');
    if (const auto* whole = std::get_if<std::int64_t>(&value)) {
        return line + std::to_string(*whole) + '\n';
    }
    if (const auto* number = std::get_if<double>(&value)) {
        const double shown = *number * row.shownFactor;
        return line + fixed(shown, decimalsOf(shown, digits)) + '\n';
    }
    return line + "-\n";
}

} // namespace sparkout::cli
