// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/result_parts.h"
#include "ui/export/study_book.h"

#include <optional>

namespace sparkout {

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
