// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"

#include <QString>

#include <vector>

namespace sparkout::report {

/// A text of a lesson, in its markup, as blocks: paragraphs whose indices stand below the line,
/// formulas, items of lists, tables.
class LessonMarkup {
public:
    /// Formulas are numbered on from `formulas`, where one is given.
    [[nodiscard]] static std::vector<Block> blocks(const QString& markup, int* formulas = nullptr);
    /// All of it in one line.
    [[nodiscard]] static QString inOneLine(const QString& markup);
};

} // namespace sparkout::report
