// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/teaching_guide.h"

#include <array>

namespace sparkout {

template <>
const StructInfo& tableOf<ControlQuestion>() {
    static const std::array rows{
        SPARKOUT_FIELD(ControlQuestion, question, .label = "Question"),
        SPARKOUT_FIELD(ControlQuestion, answer, .label = "Answer"),
    };
    static const StructInfo info = makeTable<ControlQuestion>("Control question", rows);
    return info;
}

template <>
const StructInfo& tableOf<TypicalMistake>() {
    static const std::array rows{
        SPARKOUT_FIELD(TypicalMistake, text, .label = "Text",
                       .hint = "What students often get wrong, and what to say to it."),
    };
    static const StructInfo info = makeTable<TypicalMistake>("Typical mistake", rows);
    return info;
}

template <>
const StructInfo& tableOf<TeachingGuide>() {
    static const std::array rows{
        SPARKOUT_FIELD(TeachingGuide, minutes, .label = "Time norm", .unit = "min",
                       .hard = {1, 10000}, .hint = "Of the whole work, by a student."),
        SPARKOUT_FIELD(TeachingGuide, questions, .label = "Control questions", .hard = {0, 100},
                       .sparse = true, .hint = "For the defence of the work."),
        SPARKOUT_FIELD(TeachingGuide, mistakes, .label = "Typical mistakes", .hard = {0, 100},
                       .sparse = true),
    };
    static const StructInfo info = makeTable<TeachingGuide>("Guide for the teacher", rows);
    return info;
}

} // namespace sparkout
