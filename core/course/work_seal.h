// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/course/work.h"

#include <cstddef>
#include <optional>
#include <string>

/// The seals of a work: a chain of SHA-256 digests. The first covers the original lesson, the
/// lesson with the variant, name, group and number; each further one an entry and the seal before
/// it.
///
/// They prove: that a work with a broken chain was changed outside the program, even in one digit
/// of an old entry; that two works with the same entries are copies; that a work belongs to this
/// lesson and this variant.
///
/// They contain no secret. Any reader of this page can change a work and seal it again; the last
/// entries can be cut off; the times are those of the student's clock; and another person may have
/// done the work. So marking takes no number from a work: the answers are computed again from the
/// teacher's lesson, and variants are checked against the teacher's table, which the student does
/// not have.
namespace sparkout {

/// Identifies a lesson by its text as given to students, without a variant. The right options and
/// the rules for variants may be changed after works were given out.
[[nodiscard]] std::string lessonDigest(const Lesson& lesson);

/// Digest of a lesson with a variant, as given out.
[[nodiscard]] std::string variantDigest(const Lesson& issued);

/// The seal of a work without entries.
[[nodiscard]] std::string firstSeal(const Work& work);

/// The seal of an entry that follows another.
[[nodiscard]] std::string nextSeal(const std::string& before, const WorkEntry& entry);

void addEntry(Work& work, WorkEntry entry);

/// The first broken seal: 0 that of the work itself, otherwise the number of an entry from 1. Empty
/// if the chain is intact.
[[nodiscard]] std::optional<std::size_t> brokenSeal(const Work& work);

/// Digest of all entries, without seals, names and variant: equal if one work was copied from
/// another. Empty without entries.
[[nodiscard]] std::string contentDigest(const Work& work);

} // namespace sparkout
