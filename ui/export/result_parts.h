// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/tables/xlsx_book.h"

#include <array>

/// A whole result as sheets: its inputs, its results, and its passes.
namespace sparkout {

enum class ResultPart { inputs, cycle, stages, zones, profiles, requirements, trace };
inline constexpr std::array allResultParts{
    ResultPart::inputs,   ResultPart::cycle,        ResultPart::stages, ResultPart::zones,
    ResultPart::profiles, ResultPart::requirements, ResultPart::trace};

[[nodiscard]] QString partName(ResultPart part, Operation operation); ///< translated
[[nodiscard]] const char* partKey(ResultPart part); ///< on the command line: "inputs"

/// One table, for a CSV file; the trace includes all zones, pass by pass.
[[nodiscard]] Sheet partSheet(const OutcomePtr& outcome, ResultPart part);

/// The parts as sheets of a workbook; the trace has one for each zone or section.
[[nodiscard]] Book bookOf(const OutcomePtr& outcome, const std::vector<ResultPart>& parts);

/// Number of rows of the trace; 0 if the run was too long to record.
[[nodiscard]] std::size_t traceRows(const Outcome& outcome);

/// The object of `sparkout-cli simulate --json`.
[[nodiscard]] QByteArray resultJsonBytes(const Outcome& outcome);

} // namespace sparkout
