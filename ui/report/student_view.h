// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"
#include "core/lesson/work.h"
#include "ui/report/format/report.h"
#include "ui/table/csv_table.h"

#include <QCoreApplication>

#include <cstddef>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace sparkout::report {

/// Selects what papers for students may show: a lesson without answers, inputs that no step hides,
/// and no hidden views.
class StudentView {
    Q_DECLARE_TR_FUNCTIONS(StudentView)
public:
    explicit StudentView(const Lesson& lesson);

    [[nodiscard]] const Lesson& lesson() const { return m_lesson; } ///< forStudents()
    /// Whether a step hides an input, or anything below a path.
    [[nodiscard]] bool hides(std::string_view path) const;
    [[nodiscard]] bool hidesAnyOf(std::string_view group) const;
    [[nodiscard]] bool hides(std::size_t step, Hideable thing) const;
    /// The inputs of a project that the model reads: name, symbol, value, unit.
    [[nodiscard]] Table inputs(const Project& project) const;

    /// A cell of inputTable() in the notation of papers.
    [[nodiscard]] static QString cellOf(const CsvCell& cell);
    /// Predictions of a work that were not handed in, by their steps: until then no result may be
    /// shown.
    [[nodiscard]] static std::vector<std::size_t> unpredicted(const Work& work);

private:
    Lesson m_lesson;
};

} // namespace sparkout::report
