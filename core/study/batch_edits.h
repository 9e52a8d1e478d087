// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/batch/batch_run.h"
#include "core/batch/usual_batch.h"
#include "core/project/batch.h"
#include "core/project/given_factors.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

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

/// Moves the laws of a batch along with the inputs that they replace, where an edit changes such an
/// input but not its law: a law of the stock or of the part's temperature keeps its distance to the
/// input, all others, and that of a stock that would be negative, their ratio to it. A law that
/// would leave the allowed range of the input stays. The edit leads from `present` to `changed`;
/// `base` is the project before the edits that it is joined with. Returns the factors that moved.
[[nodiscard]] std::vector<FactorKind> moveLaws(Project& changed, const Project& present,
                                               const Project& base);

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
