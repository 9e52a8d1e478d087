// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/catalogue/catalogue.h"

#include <string_view>
#include <vector>

namespace sparkout {

/// The text of a shipped catalogue, compiled in from resources/catalogue: "machines", "wheels" or
/// "materials"; empty for others.
[[nodiscard]] std::string_view shippedCatalogueText(std::string_view kind);

/// The shipped entries, in the order of their file. For MaterialEntry, WheelEntry and MachineEntry.
template <class Entry>
[[nodiscard]] const std::vector<Entry>& shippedEntries();

/// Finds the entry with this name, or those whose name contains the text. Cyrillic letters that
/// look like Latin ones, × and x, case and spaces make no difference.
template <class Entry>
[[nodiscard]] std::vector<const Entry*> entriesMeant(const std::vector<Entry>& entries,
                                                     std::string_view text);

/// The only one of these; null if there is none, or several.
template <class Entry>
[[nodiscard]] const Entry* entryMeant(const std::vector<Entry>& entries, std::string_view text);

} // namespace sparkout
