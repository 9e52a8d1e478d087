// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/machine.h"
#include "core/project/material.h"
#include "core/project/wheel.h"

#include <optional>
#include <string>
#include <vector>

/// An entry of a catalogue: a material, wheel or machine with a source for each of its numbers.
namespace sparkout {

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

} // namespace sparkout
