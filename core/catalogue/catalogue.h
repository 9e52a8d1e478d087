// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/issue.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/project.h"
#include "core/project/wheel.h"

#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

/// Catalogues of materials, wheels and machines: one UTF-8 JSON file for each kind, read and
/// written by the tables of the project. An entry gives some values of a Material, Wheel or
/// Machine, with a source for every number. The shipped catalogues are in resources/catalogue, the
/// user's own in files of the same form.

namespace sparkout {

/// Orders names numerically: 50×… before 400×…, unlike the order of characters. A number that
/// begins with 0 is treated as decimals: "1.05" comes before "1.5". Negative: a comes first; 0:
/// they are equal. The order is that of strverscmp() in the GNU library.
[[nodiscard]] int naturalOrder(std::string_view a, std::string_view b);

// An entry of a catalogue: a material, wheel or machine with a source for each of its numbers.

/// The source of a number in an entry. For a number that the entry does not give, it marks the
/// number as unknown: a project that takes the entry has none.
struct ValueSource {
    std::string key;    ///< key of the value, "stiffness_n_um/headstock" for a nested one
    std::string source; ///< key of core/SOURCES.md; empty: an estimate, to be calibrated
    std::optional<std::vector<double>> range; ///< plausible range [lowest, highest], in its unit
    std::string note;                         ///< conditions of validity
    std::string note_ru;                      ///< for the Russian window; empty: `note` serves both
};

/// A material's thermal data over temperature, for temperatures other than at_c.
struct ThermalData {
    double at_c = 400;                   ///< temperature of the entry's λ and Ω [°C]
    std::optional<double> density_kg_m3; ///< ρ [kg/m³]
    NumberRows conductivity_w_mk_at_c;   ///< rows of [°C, W/(m·K)]
    NumberRows heat_capacity_j_kgk_at_c; ///< rows of [°C, J/(kg·K)]
    std::string source;                  ///< key of core/SOURCES.md
};

struct MaterialEntry {
    std::string name;
    std::string note, note_ru; ///< its use
    Material value;
    std::vector<ValueSource> sources; ///< one for each given number of `value`
    std::optional<ThermalData> thermal;
};

struct WheelEntry {
    std::string name;
    std::string note, note_ru; ///< its use
    Wheel value;
    std::vector<ValueSource> sources;
};

struct MachineEntry {
    std::string name;
    std::string note, note_ru; ///< its use
    Machine value;
    std::vector<ValueSource> sources;
};

template <>
const StructInfo& tableOf<ValueSource>();
template <>
const StructInfo& tableOf<ThermalData>();
template <>
const StructInfo& tableOf<MaterialEntry>();
template <>
const StructInfo& tableOf<WheelEntry>();
template <>
const StructInfo& tableOf<MachineEntry>();

inline constexpr int catalogueVersion = 1;

template <class Entry>
struct CatalogueRead {
    std::optional<std::vector<Entry>> entries; ///< given without errors
    Issues issues;
};

/// Reads a catalogue's text strictly: unknown and doubled keys, wrong types, values outside the
/// hard limits, a number without its source and a source without its number are faults.
/// For MaterialEntry, WheelEntry and MachineEntry.
template <class Entry>
[[nodiscard]] CatalogueRead<Entry> readCatalogue(std::string_view text);

/// The text of a catalogue: of each value the numbers with a source, and its texts. Equal entries
/// give equal bytes.
template <class Entry>
[[nodiscard]] std::string writeCatalogue(const std::vector<Entry>& entries);

/// The text of a catalogue, read back and compared, or the faults with which it would be refused.
template <class Entry>
[[nodiscard]] std::variant<std::string, Issues> checkedCatalogue(const std::vector<Entry>& entries);

/// The shipped entries and the user's own, of which each replaces a shipped one with its name.
/// Ordered by name, with numbers by value.
template <class Entry>
[[nodiscard]] std::vector<Entry> mergedEntries(const std::vector<Entry>& shipped,
                                               const std::vector<Entry>& own);

/// Copies the values of an entry into the project, and removes values that the entry marks as
/// unknown or that an object of it, such as a machine's limits, lacks; all others are unchanged.
template <class Entry>
void applyEntry(const Entry& entry, Project& project);

/// An entry with the project's values: "save as mine". Its numbers are estimates until sources are
/// given.
template <class Entry>
[[nodiscard]] Entry entryOf(const Project& project, const std::string& name);

/// The source of a value by its key; null if the entry does not give it.
[[nodiscard]] const ValueSource* sourceOf(const std::vector<ValueSource>& sources,
                                          std::string_view key);

/// Whether a number is an estimate, to be calibrated.
[[nodiscard]] inline bool isEstimate(const ValueSource& source) {
    return source.source.empty();
}

/// λ [W/(m·K)] and Ω = λ/(ρ·c) [mm²/s] at a temperature, linear between the rows; empty outside
/// them or without data.
struct ThermalPoint {
    double conductivity_w_mk = 0, diffusivity_mm2_s = 0;
};
[[nodiscard]] std::optional<ThermalPoint> thermalAt(const ThermalData& data, double celsius);

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
