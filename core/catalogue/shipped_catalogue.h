// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/catalogue/catalogue.h"

#include <string_view>
#include <vector>

namespace sparkout {

/// The text of a catalogue that comes with the program, compiled in from resources/catalogue:
/// "machines", "wheels" or "materials"; empty for others.
[[nodiscard]] std::string_view shippedCatalogueText(std::string_view kind);

/// The entries that come with the program, in the order of their file. For MaterialEntry,
/// WheelEntry and MachineEntry.
template <class Entry>
[[nodiscard]] const std::vector<Entry>& shippedEntries();

/// The entry that is meant by a text: the one of that name, or the only one whose name has it as a
/// part. Cyrillic letters that look like Latin ones, × and x, small and capital letters, and blanks
/// are not told apart. Null: none, or several.
template <class Entry>
[[nodiscard]] const Entry* entryMeant(const std::vector<Entry>& entries, std::string_view text);

} // namespace sparkout
