// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/bilingual.h"

#include <vector>

/// What a teacher has of a lesson beside its tasks: the methodical guide is printed from it. It
/// stands in the teacher's file alone.
namespace sparkout {

/// A question for the defence of the work.
struct ControlQuestion {
    Bilingual question;
    Bilingual answer;
};

/// What students often get wrong, and what to say to it.
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
