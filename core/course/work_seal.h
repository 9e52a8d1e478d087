// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/work.h"

#include <cstddef>
#include <optional>
#include <string>

/// The seals of a work: a chain of SHA-256 digests. The first covers the lesson it was made from,
/// the lesson with the variant, name, group and number; each further one an entry and the seal
/// before it.
///
/// What they can prove: that a work whose chain does not hold was changed by other means than the
/// program, were it one digit of an old entry; that two works with the same entries are copies;
/// that a work belongs to this lesson and this variant.
///
/// What they cannot: there is no secret in them. Whoever reads this page can change a work and seal
/// it anew; the last entries can be cut off; the times are those of the student's clock; and a
/// colleague may have set what the student handed in. So marking takes no number from a work: the
/// answers are computed again from the teacher's lesson, and variants are held against the
/// teacher's table, which the student does not have.
namespace sparkout {

/// By which a lesson is known again: of its text as students may have it, without a variant. Which
/// options are right and how variants are drawn may be changed after works were given out.
[[nodiscard]] std::string lessonDigest(const Lesson& lesson);

/// Of a lesson with a variant in place, as it was given out.
[[nodiscard]] std::string variantDigest(const Lesson& issued);

/// The seal of a work without entries.
[[nodiscard]] std::string firstSeal(const Work& work);

/// The seal of an entry that follows another.
[[nodiscard]] std::string nextSeal(const std::string& before, const WorkEntry& entry);

/// Adds an entry with its seal.
void addEntry(Work& work, WorkEntry entry);

/// What the first seal that does not hold belongs to: 0 the work itself, else the number of an
/// entry from 1. Nothing: the chain holds.
[[nodiscard]] std::optional<std::size_t> brokenSeal(const Work& work);

/// Of all entries, without seals, names and variant: alike where one work was copied from another.
/// Empty without entries.
[[nodiscard]] std::string contentDigest(const Work& work);

} // namespace sparkout
