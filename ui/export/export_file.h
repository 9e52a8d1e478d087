// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/export/result_parts.h"
#include "ui/export/study_book.h"

#include <optional>

namespace sparkout {

enum class ExportFormat { xlsx, csvRussian, csvEnglish, json };
inline constexpr std::array allExportFormats{ExportFormat::xlsx, ExportFormat::csvRussian,
                                             ExportFormat::csvEnglish, ExportFormat::json};

/// What of a result goes into a file, and how. A CSV file holds one part; JSON has one object,
/// which no choice of parts changes.
struct ExportChoice {
    ExportFormat format = ExportFormat::xlsx;
    std::vector<ResultPart> parts;

    [[nodiscard]] bool hasTrace() const;
};

[[nodiscard]] QString exportSuffix(ExportFormat format);
[[nodiscard]] QString exportFilter(ExportFormat format); ///< of the file dialog

/// Why it cannot be exported, known before anything is written; empty: it can.
[[nodiscard]] QString exportObstacle(const OutcomePtr& outcome, const ExportChoice& choice);

/// Makes the bytes, in any thread; the words are those of the language of now.
[[nodiscard]] std::function<QByteArray(const KeepGoing&)> exportWork(const OutcomePtr& outcome,
                                                                     const ExportChoice& choice);

/// The same of a batch, sweep or search; JSON has none.
[[nodiscard]] std::function<QByteArray(const KeepGoing&)> studyWork(const Study& study,
                                                                    ExportFormat format);

} // namespace sparkout
