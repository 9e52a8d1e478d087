// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"
#include "ui/report/course/paper_writer.h"
#include "ui/report/course/student_view.h"

#include <QCoreApplication>

#include <cstddef>

namespace sparkout::report {

/// Places on paper for the answer to a step of a lesson.
class AnswerFields {
    Q_DECLARE_TR_FUNCTIONS(AnswerFields)
public:
    static void write(PaperWriter& paper, const StudentView& view, std::size_t step);

private:
    static Table freeInputs(const StudentView& view, std::size_t step);
};

} // namespace sparkout::report
