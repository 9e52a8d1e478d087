// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/grading.h"
#include "core/lesson/lesson.h"
#include "ui/tables/csv_table.h"
#include "ui/tables/table_model.h"

#include <vector>

namespace sparkout {

/// The marks of a class: a row a work, the points by step, their sum and what is to be looked at.
class MarksModel : public TableModel {
    Q_OBJECT

public:
    using TableModel::TableModel;

    void setMarks(const Lesson& lesson, std::vector<GradedWork> works);
    [[nodiscard]] const std::vector<GradedWork>& works() const { return m_works; }
    [[nodiscard]] const Lesson& lesson() const { return m_lesson; }
    /// As it stands here, its numbers as numbers, for a spreadsheet.
    [[nodiscard]] CsvTable table() const;
    /// What is to be looked at in a work, in one line.
    [[nodiscard]] static QString remarks(const GradedWork& work);

protected:
    [[nodiscard]] int rowsShown() const override;
    [[nodiscard]] int columnsShown() const override;
    [[nodiscard]] QVariant cell(int row, int column, int role) const override;
    [[nodiscard]] QVariant head(int column, int role) const override;

private:
    enum Column { name, group, variant, firstStep };
    enum class After { points, most, pending, time, remarks, count_ };

    [[nodiscard]] int steps() const { return static_cast<int>(m_lesson.steps.size()); }
    [[nodiscard]] QString text(const GradedWork& work, int column) const;
    [[nodiscard]] static QString after(const GradedWork& work, After column);
    [[nodiscard]] CsvCell value(const GradedWork& work, int column) const;

    Lesson m_lesson;
    std::vector<GradedWork> m_works;
};

} // namespace sparkout
