// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>
#include <string>

namespace sparkout {

struct Shaft;

/// Entries in the heads of the operation card and the sketch sheet that no cycle uses. All may be
/// empty.
struct CardEntries {
    std::string part_number;      ///< designation of the part
    std::string document_number;  ///< designation of the card
    std::string operation_number; ///< number of the operation in the route of the part
    std::string letter;           ///< letter of the document
    std::string program;          ///< designation of the NC program
    std::optional<double> mass_kg;
    std::string blank; ///< profile and sizes
    std::optional<double> blank_mass_kg;
};

/// The mass of a shaft by its segments, solid, of steel, to three digits; empty without segments.
/// An estimate: chamfers, keyways and bores are not known.
[[nodiscard]] std::optional<double> steelMass_kg(const Shaft& shaft);

template <>
const StructInfo& tableOf<CardEntries>();

} // namespace sparkout
