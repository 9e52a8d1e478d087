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

/// Where one number of an entry comes from. Of a number that the entry does not give it says that
/// it is not known: it has been sought, and a project that takes the entry has none.
struct ValueSource {
    std::string key;    ///< of the value, "stiffness_n_um/headstock" for one inside another
    std::string source; ///< key of core/SOURCES.md; empty: an estimate, to be calibrated
    std::optional<std::vector<double>> range; ///< [lowest, highest] it plausibly has, in its unit
    std::string note;                         ///< under which conditions it holds
    std::string note_ru; ///< the same for the Russian window; empty: `note` serves both
};

/// A material's heat data over temperature, for whoever wants another temperature than at_c.
struct ThermalData {
    double at_c = 400;                   ///< at which the entry's λ and Ω are taken [°C]
    std::optional<double> density_kg_m3; ///< ρ [kg/m³]
    NumberRows conductivity_w_mk_at_c;   ///< rows of [°C, W/(m·K)]
    NumberRows heat_capacity_j_kgk_at_c; ///< rows of [°C, J/(kg·K)]
    std::string source;                  ///< key of core/SOURCES.md
};

struct MaterialEntry {
    std::string name;
    std::string note, note_ru; ///< what it is used for
    Material value;
    std::vector<ValueSource> sources; ///< one for each number of `value` that is given
    std::optional<ThermalData> thermal;
};

struct WheelEntry {
    std::string name;
    std::string note, note_ru; ///< what it is used for
    Wheel value;
    std::vector<ValueSource> sources;
};

struct MachineEntry {
    std::string name;
    std::string note, note_ru; ///< what it is used for
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
