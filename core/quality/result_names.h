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

/// "nz", "section 2" (from 0).
[[nodiscard]] std::string sectionName(Zone zone, int section);

/// "rz1", "section 3" (from 0), or "part" for a section below 0.
[[nodiscard]] std::string sectionOrPart(Zone zone, int section);

/// A place in the cycle: "nz E1 stage 1 double stroke 27".
[[nodiscard]] std::string placeText(const Place& place);

/// The worst place of a requirement: a place in the cycle, "rz1", "part", "stage 2", "cycle".
[[nodiscard]] std::string whereText(const ConstraintResult& constraint);

} // namespace sparkout
