// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/report/format/report.h"
#include "ui/report/handout/exercises.h"

#include <QCoreApplication>

namespace sparkout::report {

/// The exercises of the hand-out: the questions, and the key.
class ExerciseSheet {
    Q_DECLARE_TR_FUNCTIONS(ExerciseSheet)
public:
    static std::vector<Block> questions(const std::vector<Exercise>& exercises);
    static std::vector<Block> answers(const std::vector<Exercise>& exercises, Operation operation);
};

} // namespace sparkout::report
