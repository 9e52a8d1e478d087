// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/tables/xlsx_book.h"

#include <array>

/// A whole result as sheets: its inputs, what came out, and what happened pass by pass.
namespace sparkout {

enum class ResultPart { inputs, cycle, stages, zones, profiles, requirements, trace };
inline constexpr std::array allResultParts{
    ResultPart::inputs,   ResultPart::cycle,        ResultPart::stages, ResultPart::zones,
    ResultPart::profiles, ResultPart::requirements, ResultPart::trace};

[[nodiscard]] QString partName(ResultPart part, Operation operation); ///< in the present language
[[nodiscard]] const char* partKey(ResultPart part); ///< on the command line: "inputs"

/// One table, as a CSV file holds it; of the trace all zones, pass by pass.
[[nodiscard]] Sheet partSheet(const OutcomePtr& outcome, ResultPart part);

/// The parts as sheets of a workbook; of the trace one a zone or section.
[[nodiscard]] Book bookOf(const OutcomePtr& outcome, const std::vector<ResultPart>& parts);

/// Rows of the trace; 0 where the run was too long to be recorded.
[[nodiscard]] std::size_t traceRows(const Outcome& outcome);

/// The same object as that of `sparkout-cli simulate --json`.
[[nodiscard]] QByteArray resultJsonBytes(const Outcome& outcome);

} // namespace sparkout
