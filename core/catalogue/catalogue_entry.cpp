// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/catalogue/catalogue_entry.h"

#include "core/project/conditions.h"
#include "core/text.h"

namespace sparkout {

namespace {

Row nameRow() {
    return {.label = SPARKOUT_NOOP("Input", "Name"),
            .required = conditions::always,
            .hint = SPARKOUT_NOOP("Input", "Name to search by.")};
}

Row noteRow() {
    return {.label = SPARKOUT_NOOP("Input", "Note"),
            .hint = SPARKOUT_NOOP("Input",
                                  "Use of the entry, or the conditions for which it is valid.")};
}

Row russianNoteRow() {
    return {.label = SPARKOUT_NOOP("Input", "Note in Russian"),
            .hint = SPARKOUT_NOOP("Input", "The same for the Russian window.")};
}

Row sourcesRow() {
    return {.label = SPARKOUT_NOOP("Input", "Sources"),
            .hint = SPARKOUT_NOOP("Input", "Where each number comes from.")};
}

/// The rows that all kinds of entries share.
template <class Entry>
auto entryRows(const char* valueLabel) {
    return std::array{
        makeField<&Entry::name>("name", nameRow()), makeField<&Entry::note>("note", noteRow()),
        makeField<&Entry::note_ru>("note_ru", russianNoteRow()),
        makeField<&Entry::value>("value", Row{.label = valueLabel, .required = conditions::always}),
        makeField<&Entry::sources>("sources", sourcesRow())};
}

} // namespace

template <>
const StructInfo& tableOf<ValueSource>() {
    static const std::array rows{
        SPARKOUT_FIELD(ValueSource, key, .label = SPARKOUT_NOOP("Input", "Value"),
                       .required = conditions::always,
                       .hint = SPARKOUT_NOOP("Input", "Key of the number.")),
        SPARKOUT_FIELD(ValueSource, source, .label = SPARKOUT_NOOP("Input", "Source"),
                       .hint = SPARKOUT_NOOP("Input", "Key of the source; empty: an estimate, to "
                                                      "be calibrated.")),
        SPARKOUT_FIELD(ValueSource, range, .label = SPARKOUT_NOOP("Input", "Plausible range"),
                       .nullMeaning = SPARKOUT_NOOP("Input", "not stated"), .count = 2,
                       .hint = SPARKOUT_NOOP("Input", "Minimum and maximum value to expect.")),
        makeField<&ValueSource::note>("note", noteRow()),
        makeField<&ValueSource::note_ru>("note_ru", russianNoteRow()),
    };
    static const StructInfo info =
        makeTable<ValueSource>(SPARKOUT_NOOP("Struct", "Source of a value"), rows);
    return info;
}

template <>
const StructInfo& tableOf<ThermalData>() {
    static const std::array rows{
        SPARKOUT_FIELD(
            ThermalData, at_c, .label = SPARKOUT_NOOP("Input", "Temperature"), .symbol = "T",
            .unit = "°C", .hard = {-200, 1500},
            .hint = SPARKOUT_NOOP(
                "Input",
                "Temperature for which the entry's conductivity and diffusivity are given.")),
        SPARKOUT_FIELD(ThermalData, density_kg_m3, .label = SPARKOUT_NOOP("Input", "Density"),
                       .symbol = "ρ", .unit = "kg/m³", .hard = {100, 30000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not stated"),
                       .hint = SPARKOUT_NOOP("Input", "At room temperature.")),
        SPARKOUT_FIELD(ThermalData, conductivity_w_mk_at_c,
                       .label = SPARKOUT_NOOP("Input", "Conductivity over temperature"),
                       .symbol = "λ", .unit = "°C, W/(m·K)", .hard = {-200, 3000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not stated"), .count = 2,
                       .hint = SPARKOUT_NOOP("Input", "Rows of temperature and conductivity.")),
        SPARKOUT_FIELD(ThermalData, heat_capacity_j_kgk_at_c,
                       .label = SPARKOUT_NOOP("Input", "Heat capacity over temperature"),
                       .symbol = "c", .unit = "°C, J/(kg·K)", .hard = {-200, 10000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not stated"), .count = 2,
                       .hint = SPARKOUT_NOOP("Input", "Rows of temperature and heat capacity.")),
        SPARKOUT_FIELD(ThermalData, source, .label = SPARKOUT_NOOP("Input", "Source"),
                       .hint = SPARKOUT_NOOP("Input", "Key of the source.")),
    };
    static const StructInfo info =
        makeTable<ThermalData>(SPARKOUT_NOOP("Struct", "Heat data"), rows);
    return info;
}

template <>
const StructInfo& tableOf<MaterialEntry>() {
    static const auto rows = [] {
        const auto shared = entryRows<MaterialEntry>(SPARKOUT_NOOP("Input", "Material"));
        return std::array{
            shared[0],
            shared[1],
            shared[2],
            shared[3],
            shared[4],
            SPARKOUT_FIELD(MaterialEntry, thermal,
                           .label = SPARKOUT_NOOP("Input", "Heat data over temperature"),
                           .nullMeaning = SPARKOUT_NOOP("Input", "not stated"))};
    }();
    static const StructInfo info =
        makeTable<MaterialEntry>(SPARKOUT_NOOP("Struct", "Material of the catalogue"), rows);
    return info;
}

template <>
const StructInfo& tableOf<WheelEntry>() {
    static const auto rows = entryRows<WheelEntry>(SPARKOUT_NOOP("Input", "Wheel"));
    static const StructInfo info =
        makeTable<WheelEntry>(SPARKOUT_NOOP("Struct", "Wheel of the catalogue"), rows);
    return info;
}

template <>
const StructInfo& tableOf<MachineEntry>() {
    static const auto rows = entryRows<MachineEntry>(SPARKOUT_NOOP("Input", "Machine"));
    static const StructInfo info =
        makeTable<MachineEntry>(SPARKOUT_NOOP("Struct", "Machine of the catalogue"), rows);
    return info;
}

} // namespace sparkout
