// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/quality/constraints.h"
#include "core/simulation/result.h"

#include <string>

/// Names in files and on the command line, independent of the language.
namespace sparkout {

[[nodiscard]] const char* zoneKey(Zone zone); ///< "rz1", "section"
[[nodiscard]] const char* stepKey(Step step); ///< "E1"; empty for none
[[nodiscard]] const char* statusKey(RunStatus status);
[[nodiscard]] const char* formKey(LongitudinalForm form);

/// The number of the first section, and of the first part of a batch: in files 0, in texts 1.
enum class First { inFiles, inTexts };

/// "nz", "section 2".
[[nodiscard]] std::string sectionName(Zone zone, int section, First first = First::inFiles);

/// "rz1", "section 3", or "part" for a section below 0.
[[nodiscard]] std::string sectionOrPart(Zone zone, int section, First first = First::inFiles);

/// A place in the cycle: "nz E1 stage 1 double stroke 27".
[[nodiscard]] std::string placeText(const Place& place, First first = First::inFiles);

/// The worst place of a requirement: a place in the cycle, "rz1", "part", "stage 2", "cycle".
[[nodiscard]] std::string whereText(const ConstraintResult& constraint,
                                    First first = First::inFiles);

} // namespace sparkout
