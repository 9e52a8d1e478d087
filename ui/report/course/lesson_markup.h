// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

#include <QString>

#include <vector>

namespace sparkout::report {

/// Converts the markup of a lesson's text into blocks: paragraphs with indices, formulas, list
/// items, tables.
class LessonMarkup {
public:
    /// Numbers formulas starting from `formulas`, if given.
    [[nodiscard]] static std::vector<Block> blocks(const QString& markup, int* formulas = nullptr);
    /// The whole text on one line.
    [[nodiscard]] static QString inOneLine(const QString& markup);
};

} // namespace sparkout::report
