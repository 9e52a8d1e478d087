// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/teaching_guide.h"

#include "core/text.h"

#include <array>

namespace sparkout {

template <>
const StructInfo& tableOf<ControlQuestion>() {
    static const std::array rows{
        SPARKOUT_FIELD(ControlQuestion, question, .label = SPARKOUT_NOOP("Input", "Question")),
        SPARKOUT_FIELD(ControlQuestion, answer, .label = SPARKOUT_NOOP("Input", "Answer")),
    };
    static const StructInfo info =
        makeTable<ControlQuestion>(SPARKOUT_NOOP("Struct", "Control question"), rows);
    return info;
}

template <>
const StructInfo& tableOf<TypicalMistake>() {
    static const std::array rows{
        SPARKOUT_FIELD(TypicalMistake, text, .label = SPARKOUT_NOOP("Input", "Text"),
                       .hint = SPARKOUT_NOOP(
                           "Input", "Frequent mistakes of students, and how to respond to them.")),
    };
    static const StructInfo info =
        makeTable<TypicalMistake>(SPARKOUT_NOOP("Struct", "Typical mistake"), rows);
    return info;
}

template <>
const StructInfo& tableOf<TeachingGuide>() {
    static const std::array rows{
        SPARKOUT_FIELD(TeachingGuide, minutes, .label = SPARKOUT_NOOP("Input", "Time norm"),
                       .unit = "min", .hard = {1, 10000},
                       .hint = SPARKOUT_NOOP("Input", "Of the whole work, by a student.")),
        SPARKOUT_FIELD(TeachingGuide, questions,
                       .label = SPARKOUT_NOOP("Input", "Control questions"), .hard = {0, 100},
                       .sparse = true,
                       .hint = SPARKOUT_NOOP("Input", "For the defence of the work.")),
        SPARKOUT_FIELD(TeachingGuide, mistakes, .label = SPARKOUT_NOOP("Input", "Typical mistakes"),
                       .hard = {0, 100}, .sparse = true),
    };
    static const StructInfo info =
        makeTable<TeachingGuide>(SPARKOUT_NOOP("Struct", "Guide for the teacher"), rows);
    return info;
}

} // namespace sparkout
