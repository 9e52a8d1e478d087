// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <cstddef>
#include <optional>
#include <span>

namespace sparkout {

/// A zone or section as named in a file: "rz1", "nz", "rz2", or the number of a section from 0; as
/// an input a CountOrWord.
struct PlaceName {
    std::optional<int> zone;    ///< index of the word
    std::optional<int> section; ///< counted from 0
    friend bool operator==(const PlaceName&, const PlaceName&) = default;

    [[nodiscard]] bool isGiven() const { return zone || section; }
    /// The index in SimulationResult::sections.
    [[nodiscard]] std::size_t index() const {
        return static_cast<std::size_t>(zone.value_or(section.value_or(0)));
    }

    [[nodiscard]] static std::span<const Choice> words();
    [[nodiscard]] static Phrase expected();
    [[nodiscard]] static PlaceName ofNumber(int number) { return {std::nullopt, number}; }
    [[nodiscard]] static PlaceName ofWord(std::size_t word) {
        return {static_cast<int>(word), std::nullopt};
    }
    [[nodiscard]] int* number() { return section ? &*section : nullptr; }
    [[nodiscard]] std::optional<std::size_t> word() const {
        return zone ? std::optional(static_cast<std::size_t>(*zone)) : std::nullopt;
    }
};

struct Project;

/// The name of a place of a project by its index.
[[nodiscard]] PlaceName placeName(const Project& project, std::size_t index);
/// Whether a project has such a place.
[[nodiscard]] bool hasPlace(const Project& project, const PlaceName& place);

} // namespace sparkout
