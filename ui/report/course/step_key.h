// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/lesson.h"
#include "ui/report/course/paper_writer.h"

#include <QCoreApplication>

#include <cstddef>

namespace sparkout::report {

/// The answer to a step of the teacher's lesson: the engine's, or the right options.
class StepKey {
    Q_DECLARE_TR_FUNCTIONS(StepKey)
public:
    static void write(PaperWriter& paper, const Lesson& lesson, std::size_t step);
};

} // namespace sparkout::report
