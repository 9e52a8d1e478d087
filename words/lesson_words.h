// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/lesson/goal_check.h"
#include "core/lesson/grading.h"
#include "core/lesson/make_variants.h"
#include "core/lesson/work.h"
#include "core/study/run_comparison.h"

#include <string>

/// Texts about lessons, variants and marks, in English: for the command line, and translated in the
/// window.

namespace sparkout {

/// The objects of `course check --json`.
[[nodiscard]] std::string lessonCheckJson(const CheckedSteps& checked);
[[nodiscard]] std::string workCheckJson(const Work& work, const CheckedSteps& checked);

/// The text of a work's flag; context "Grading".
[[nodiscard]] const char* flagText(WorkFlag flag);

/// The reason for rejecting levels; context "Variants".
[[nodiscard]] const char* variantFaultText(VariantFault fault);

/// Why a lesson has no variants; context "Variants".
[[nodiscard]] const char* lessonFaultText(LessonFault fault);

/// The fault of a line in a list of students; context "Grading".
[[nodiscard]] const char* groupFaultText(GroupFault::Kind kind);

/// A kept run whose numbers differ from the engine's, in English.
[[nodiscard]] std::string keptRunSentence(const KeptRunCheck& check);

} // namespace sparkout
