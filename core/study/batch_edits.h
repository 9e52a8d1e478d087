// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/batch/usual_batch.h"
#include "core/project/batch.h"
#include "core/project/given_factors.h"

/// Edits of a project's batch.
namespace sparkout {

/// Forms of the distribution of a factor.
enum class FactorForm { constant, uniform, normal, triangular, measured, grows };

/// Returns the form of a factor; a uniform factor with equal ends is a constant.
[[nodiscard]] FactorForm formOf(const Factor& factor);

/// Returns a factor of the project's batch in another form with about the same ends; a constant is
/// widened.
[[nodiscard]] Factor withForm(const Project& project, FactorKind kind, FactorForm form);

/// Returns a normal factor of the project's batch, truncated to three standard deviations or not at
/// all.
[[nodiscard]] Factor withTruncation(const Project& project, FactorKind kind, bool truncated);

/// Returns the project whose batch has this law of a factor, or none; the correlations of the other
/// factors are unchanged.
[[nodiscard]] Project withFactor(Project project, FactorKind kind, std::optional<Factor> law);

/// Returns the project with another correlation of two of its given factors; the matrix is
/// removed when every correlation is 0.
[[nodiscard]] Project withCorrelation(Project project, std::size_t first, std::size_t second,
                                      double value);

/// Returns the project with the inputs of a part of its batch; names, batch, search and kept runs
/// stay.
[[nodiscard]] Project withPart(Project project, const BatchResult& batch, std::int64_t part);

/// Returns whether two projects make the same batch: only names, notes, search and kept runs
/// differ.
[[nodiscard]] bool sameBatch(const Project& a, const Project& b);

} // namespace sparkout
