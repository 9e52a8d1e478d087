// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/project/card_entries.h"

#include "core/digits.h"
#include "core/project/part.h"
#include "core/text.h"

#include <array>
#include <cmath>
#include <numbers>

namespace sparkout {

std::optional<double> steelMass_kg(const Shaft& shaft) {
    constexpr double density_kg_mm3 = 7850e-9; // 7,850 kg/m³
    if (shaft.segments.empty()) {
        return std::nullopt;
    }
    double volume_mm3 = 0;
    for (const ShaftSegment& segment : shaft.segments) {
        volume_mm3 +=
            std::numbers::pi / 4 * segment.diameter_mm * segment.diameter_mm * segment.length_mm;
    }
    const double mass_kg = volume_mm3 * density_kg_mm3;
    const double scale = std::pow(10.0, decimalsOf(mass_kg, 3));
    return std::round(mass_kg * scale) / scale;
}

template <>
const StructInfo& tableOf<CardEntries>() {
    static const std::array rows{
        SPARKOUT_FIELD(CardEntries, part_number,
                       .label = SPARKOUT_NOOP("Input", "Designation of the part"), .sparse = true,
                       .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "The number of the drawing.")),
        SPARKOUT_FIELD(CardEntries, document_number,
                       .label = SPARKOUT_NOOP("Input", "Document number"), .sparse = true,
                       .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Designation of the operation card.")),
        SPARKOUT_FIELD(CardEntries, operation_number,
                       .label = SPARKOUT_NOOP("Input", "Operation number"), .sparse = true,
                       .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Number of the operation in the part's "
                                                      "route.")),
        SPARKOUT_FIELD(CardEntries, letter, .label = SPARKOUT_NOOP("Input", "Letter"),
                       .sparse = true, .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Letter of the document by GOST 3.1102, "
                                                      "for example A.")),
        SPARKOUT_FIELD(CardEntries, program, .label = SPARKOUT_NOOP("Input", "NC program"),
                       .sparse = true, .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Designation of the program of the numerical "
                                                      "control.")),
        SPARKOUT_FIELD(CardEntries, mass_kg, .label = SPARKOUT_NOOP("Input", "Mass of the part"),
                       .unit = "kg", .hard = {0, 100000, true}, .soft = {0.001, 2000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not given"), .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Mass by the drawing, or by the steps of the "
                                                      "shaft as solid steel.")),
        SPARKOUT_FIELD(CardEntries, blank, .label = SPARKOUT_NOOP("Input", "Profile and sizes"),
                       .sparse = true, .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Profile and sizes of the blank, for example "
                                                      "round bar ⌀50 × 325.")),
        SPARKOUT_FIELD(CardEntries, blank_mass_kg,
                       .label = SPARKOUT_NOOP("Input", "Mass of the blank"), .unit = "kg",
                       .hard = {0, 100000, true}, .soft = {0.001, 2000},
                       .nullMeaning = SPARKOUT_NOOP("Input", "not given"), .page = Page::part,
                       .hint = SPARKOUT_NOOP("Input", "Mass of the blank that the part is made "
                                                      "of.")),
    };
    static const StructInfo info =
        makeTable<CardEntries>(SPARKOUT_NOOP("Struct", "Operation card"), rows);
    return info;
}

} // namespace sparkout
