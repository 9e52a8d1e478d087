// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/bilingual.h"

#include <vector>

/// A teacher's material besides the tasks, from which the teaching guide is printed. Only the
/// teacher's file contains it.
namespace sparkout {

/// A question for the defence of the work.
struct ControlQuestion {
    Bilingual question;
    Bilingual answer;
};

/// A frequent mistake of students, and a reply to it.
struct TypicalMistake {
    Bilingual text;
};

struct TeachingGuide {
    int minutes = 90; ///< time norm of the whole work [min]
    std::vector<ControlQuestion> questions;
    std::vector<TypicalMistake> mistakes;
};

template <>
const StructInfo& tableOf<ControlQuestion>();
template <>
const StructInfo& tableOf<TypicalMistake>();
template <>
const StructInfo& tableOf<TeachingGuide>();

} // namespace sparkout
