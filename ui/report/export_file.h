// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/study/outcome.h"
#include "ui/report/study_book.h"
#include "ui/table/sheet.h"

#include <array>
#include <optional>

/// Results as files: a whole result as sheets (its inputs, its results, and its passes) or as JSON,
/// and studies as tables.
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

enum class ExportFormat { xlsx, csvRussian, csvEnglish, json };
inline constexpr std::array allExportFormats{ExportFormat::xlsx, ExportFormat::csvRussian,
                                             ExportFormat::csvEnglish, ExportFormat::json};

/// The parts and the format of an exported result. A CSV file has one part; JSON has one object,
/// independent of the parts.
struct ExportChoice {
    ExportFormat format = ExportFormat::xlsx;
    std::vector<ResultPart> parts;

    [[nodiscard]] bool hasTrace() const;
};

[[nodiscard]] QString exportSuffix(ExportFormat format);
[[nodiscard]] QString exportFilter(ExportFormat format); ///< for the file dialog

/// Why it cannot be exported, known before writing; empty if it can.
[[nodiscard]] QString exportObstacle(const OutcomePtr& outcome, const ExportChoice& choice);

/// Makes the bytes, on any thread, in the language at the call.
[[nodiscard]] std::function<QByteArray(const KeepGoing&)> exportWork(const OutcomePtr& outcome,
                                                                     const ExportChoice& choice);

/// For a batch, sweep or search, which have no JSON.
[[nodiscard]] std::function<QByteArray(const KeepGoing&)> studyWork(const Study& study,
                                                                    ExportFormat format);

} // namespace sparkout
