// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/batch/usual_batch.h"
#include "core/project/batch.h"
#include "core/project/given_factors.h"

/// Edits of a project that have to do with its batch.
namespace sparkout {

/// The forms in which a factor scatters.
enum class FactorForm { constant, uniform, normal, triangular, measured, grows };

/// The form that is given; a uniform factor of equal ends is a constant.
[[nodiscard]] FactorForm formOf(const Factor& factor);

/// A factor of the project's batch in another form between about the same ends; a constant gets
/// some room.
[[nodiscard]] Factor withForm(const Project& project, FactorKind kind, FactorForm form);

/// A normal factor of the project's batch, truncated to three standard deviations or not at all.
[[nodiscard]] Factor withTruncation(const Project& project, FactorKind kind, bool truncated);

/// The project whose batch has this law of a factor, or lets it be; the correlations of the other
/// factors stay.
[[nodiscard]] Project withFactor(Project project, FactorKind kind, std::optional<Factor> law);

/// The project with another correlation of two of its given factors; none that is not 0: no matrix.
[[nodiscard]] Project withCorrelation(Project project, std::size_t first, std::size_t second,
                                      double value);

/// The project with the inputs of a part of its batch; names, batch, search and kept runs stay.
[[nodiscard]] Project withPart(Project project, const BatchResult& batch, std::int64_t part);

/// Whether two projects make the same batch: nothing but names, notes, search and kept runs differ.
[[nodiscard]] bool sameBatch(const Project& a, const Project& b);

} // namespace sparkout
