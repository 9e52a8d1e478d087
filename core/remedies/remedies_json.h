// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/remedies/remedies.h"
#include "core/result.h"

#include <span>
#include <string>

namespace sparkout {

/// A remedy of a project.
struct RemedyOf {
    const Project& project;
    const Remedy& remedy;
};

/// The data of a conflict for its outputs.
struct RemedyConflictOf {
    const Project& project;
    const RemedyConflict& conflict;
};

[[nodiscard]] std::span<const Output<RemedyOf>> remedyOutputs();
/// The random stocks for which a remedy is good.
[[nodiscard]] std::span<const Output<Remedy>> remedyPhasesOutputs();
/// The random parts of the batch for a remedy.
[[nodiscard]] std::span<const Output<RemedyBatch>> remedyBatchOutputs();
[[nodiscard]] std::span<const Output<RemedyConflictOf>> remedyConflictOutputs();
[[nodiscard]] std::span<const Output<RemedyResult>> remedyResultOutputs();

/// The object of `remedies --json`.
[[nodiscard]] std::string remediesJson(const Project& project, const RemedyResult& found);

} // namespace sparkout
