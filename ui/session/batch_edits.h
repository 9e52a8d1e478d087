// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/project/given_factors.h"

/// Edits of a project that have to do with its batch.
namespace sparkout {

/// How a factor usually scatters about the project's own value of it, to start from.
[[nodiscard]] Factor usualFactor(FactorKind kind, const Project& project);

/// The project with a usual batch: 50 parts whose stock, runout and dullness scatter, as far as
/// every one of them is a valid project.
[[nodiscard]] Project withUsualBatch(Project project);

/// The project with the inputs of a part of its batch; names, batch, search and kept runs stay.
[[nodiscard]] Project withPart(Project project, const BatchResult& batch, std::int64_t part);

/// Whether two projects make the same batch: nothing but names, notes, search and kept runs differ.
[[nodiscard]] bool sameBatch(const Project& a, const Project& b);

} // namespace sparkout
