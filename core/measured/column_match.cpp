// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/measured/column_match.h"

#include "core/file/text_table.h"
#include "core/project/measured.h"
#include "core/text.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <span>
#include <utility>

namespace sparkout {

namespace {

struct Name {
    std::string_view text; ///< in lower case
    ColumnQuantity quantity;
};

/// The names that headings are compared with, word for word.
std::span<const Name> headingNames() {
    using enum ColumnQuantity;
    static constexpr auto names = std::to_array<Name>({
        {"part", part},
        {"part no", part},
        {"part number", part},
        {"no", part},
        {"nr", part},
        {"number", part},
        {"№", part},
        {"n", part},
        {"деталь", part},
        {"номер", part},
        {"номер детали", part},
        {"zone or section", place},
        {"зона или сечение", place},
        {"№ детали", part},
        {"zone", place},
        {"section", place},
        {"place", place},
        {"зона", place},
        {"сечение", place},
        {"d", diameter},
        {"ø", diameter},
        {"diameter", diameter},
        {"диаметр", diameter},
        {"diameter deviation", diameter_deviation},
        {"deviation", diameter_deviation},
        {"отклонение", diameter_deviation},
        {"отклонение диаметра", diameter_deviation},
        {"roundness", roundness},
        {"roundness deviation", roundness},
        {"ront", roundness},
        {"круглость", roundness},
        {"некруглость", roundness},
        {"отклонение от круглости", roundness},
        {"runout", radial_runout},
        {"radial runout", radial_runout},
        {"биение", radial_runout},
        {"радиальное биение", radial_runout},
        {"cylindricity", cylindricity},
        {"цилиндричность", cylindricity},
        {"отклонение от цилиндричности", cylindricity},
        {"ra", roughness_ra},
        {"roughness", roughness_ra},
        {"шероховатость", roughness_ra},
        {"шероховатость ra", roughness_ra},
        {"roughness ra", roughness_ra},
        {"отклонение круглости", roundness},
        {"date", when},
        {"when", when},
        {"when measured", when},
        {"когда измерено", when},
        {"дата", when},
        {"note", note},
        {"примечание", note},
        {"t", time},
        {"time", time},
        {"время", time},
        {"time of the sample", time},
        {"время отсчёта", time},
        {"size", gauge_size},
        {"gauge", gauge_size},
        {"gauge size", gauge_size},
        {"размер", gauge_size},
        {"прибор", gauge_size},
        {"size at the gauge", gauge_size},
        {"размер у прибора", gauge_size},
        {"размер на приборе", gauge_size},
        {"размер по прибору", gauge_size},
        {"p", wheel_power},
        {"power", wheel_power},
        {"wheel power", wheel_power},
        {"мощность", wheel_power},
        {"мощность круга", wheel_power},
        {"мощность привода круга", wheel_power},
        {"мощность шпинделя", wheel_power},
        {"spindle power", wheel_power},
        {"i", spindle_current},
        {"current", spindle_current},
        {"spindle current", spindle_current},
        {"ток", spindle_current},
        {"ток шпинделя", spindle_current},
        {"f", normal_force},
        {"fn", normal_force},
        {"py", normal_force},
        {"p_y", normal_force},
        {"force", normal_force},
        {"normal force", normal_force},
        {"сила", normal_force},
        {"нормальная сила", normal_force},
    });
    return names;
}

constexpr double perThousand = 1e-3, thousand = 1e3;

/// The units of a quantity with their factors to the section's unit; its own comes first.
std::vector<std::pair<ColumnUnit, double>> unitsOf(ColumnQuantity quantity) {
    using enum ColumnQuantity;
    switch (quantity) {
    case diameter:
    case gauge_size: return {{ColumnUnit::mm, 1}, {ColumnUnit::um, perThousand}};
    case diameter_deviation:
    case roundness:
    case radial_runout:
    case cylindricity:
    case roughness_ra: return {{ColumnUnit::um, 1}, {ColumnUnit::mm, thousand}};
    case time: return {{ColumnUnit::s, 1}, {ColumnUnit::ms, perThousand}, {ColumnUnit::min, 60}};
    case wheel_power: return {{ColumnUnit::kw, 1}, {ColumnUnit::w, perThousand}};
    case spindle_current: return {{ColumnUnit::a, 1}};
    case normal_force: return {{ColumnUnit::n, 1}, {ColumnUnit::kn, thousand}};
    default: return {{ColumnUnit::none, 1}};
    }
}

/// The parts of a heading: its quantity, its unit and the zone.
struct HeadingParts {
    std::string name;
    std::optional<ColumnUnit> unit;
    std::optional<int> place;
};

constexpr std::string_view aroundName = " \t,;:."; ///< characters that are not part of a name

/// Removes "[mm]", "(mm)" or ", mm" from the end of a heading.
std::optional<ColumnUnit> takeUnit(std::string& heading) {
    const bool bracketed = heading.ends_with(']') || heading.ends_with(')');
    const std::size_t at =
        bracketed ? heading.find_last_of(heading.back() == ']' ? '[' : '(') : heading.rfind(',');
    if (at == std::string::npos) {
        return std::nullopt;
    }
    std::string text = heading.substr(at + 1);
    if (bracketed) {
        text.pop_back();
    }
    const auto unit = unitNamed(trimmed(text, aroundName));
    if (!unit && !bracketed) {
        return std::nullopt; // the text after the comma is not a unit
    }
    heading = trimmed(heading.substr(0, at), aroundName);
    return unit                                ? unit
           : trimmed(text, aroundName).empty() ? std::nullopt
                                               : std::optional(ColumnUnit::unknown);
}

HeadingParts partsOf(std::string_view heading) {
    HeadingParts parts;
    parts.name = lowerCase(trimmed(heading, aroundName));
    parts.unit = takeUnit(parts.name);
    const std::size_t space = parts.name.rfind(' ');
    if (space != std::string::npos) {
        const std::string last = parts.name.substr(space + 1);
        parts.place = last.find_first_of("0123456789") == 0 ? std::nullopt : zoneNamed(last);
        if (parts.place) {
            parts.name = trimmed(parts.name.substr(0, space), aroundName);
        }
    }
    // d1, d2, diameter 3: one of several.
    while (!parts.name.empty() && parts.name.back() >= '0' && parts.name.back() <= '9') {
        parts.name.pop_back();
    }
    parts.name = trimmed(parts.name, aroundName);
    return parts;
}

} // namespace

ColumnMatch matchHeading(std::string_view heading) {
    using enum ColumnQuantity;
    const HeadingParts parts = partsOf(heading);
    ColumnMatch match{std::string(heading), ignored, parts.unit.value_or(ColumnUnit::none),
                      parts.place};
    const std::span<const Name> names = headingNames();
    const auto found = std::ranges::find(names, std::string_view(parts.name), &Name::text);
    if (found != names.end()) {
        match.quantity = found->quantity;
    }
    // P [N] is a force; F [kW] and d [s] are nothing.
    if (match.unit != ColumnUnit::none && match.unit != ColumnUnit::unknown
        && isNumeric(match.quantity) && !factorOf(match.quantity, match.unit)) {
        match.quantity = match.unit == ColumnUnit::n || match.unit == ColumnUnit::kn ? normal_force
                         : match.unit == ColumnUnit::kw || match.unit == ColumnUnit::w ? wheel_power
                         : match.unit == ColumnUnit::a ? spindle_current
                                                       : ignored;
    }
    if (match.unit == ColumnUnit::none && isNumeric(match.quantity) && match.quantity != place) {
        match.unit = unitsOf(match.quantity).front().first;
    }
    return match;
}

std::vector<ColumnMatch> matchHeadings(std::string_view text, char delimiter) {
    TableReader rows(text, delimiter);
    std::vector<ColumnMatch> matches;
    if (rows.next()) {
        std::ranges::transform(rows.cells(), std::back_inserter(matches), matchHeading);
    }
    settleMatches(matches);
    return matches;
}

void settleMatches(std::vector<ColumnMatch>& matches) {
    using enum ColumnQuantity;
    const auto has = [&matches](ColumnQuantity quantity) {
        return std::ranges::find(matches, quantity, &ColumnMatch::quantity) != matches.end();
    };
    const bool isOfTraces = has(ColumnQuantity::time) && !has(part);
    for (ColumnMatch& match : matches) {
        if (isOfTraces && match.quantity == diameter) {
            match.quantity = gauge_size;
        } else if (!isOfTraces && match.quantity == ColumnQuantity::time) {
            match.quantity = when;
        }
    }
}

std::optional<double> factorOf(ColumnQuantity quantity, ColumnUnit unit) {
    if (unit == ColumnUnit::none) {
        return 1;
    }
    for (const auto& [allowed, factor] : unitsOf(quantity)) {
        if (allowed == unit) {
            return factor;
        }
    }
    return std::nullopt;
}

bool isNumeric(ColumnQuantity quantity) {
    using enum ColumnQuantity;
    switch (quantity) {
    case ignored:
    case part:
    case when:
    case note:
    case count_: return false;
    default: return true;
    }
}

bool isTrace(ColumnQuantity quantity) {
    using enum ColumnQuantity;
    return quantity == gauge_size || quantity == wheel_power || quantity == spindle_current
           || quantity == normal_force;
}

Bounds boundsOf(ColumnQuantity quantity) {
    using enum ColumnQuantity;
    const auto ofPart = [](const char* key) {
        const Field& field = *tableOf<MeasuredPart>().find(key);
        return Bounds{.range = field.hard, .unit = field.unit};
    };
    switch (quantity) {
    case diameter: return ofPart("diameters_mm");
    case roundness: return ofPart("roundness_um");
    case radial_runout: return ofPart("radial_runout_um");
    case cylindricity: return ofPart("cylindricity_um");
    case roughness_ra: return ofPart("roughness_ra_um");
    case place: return ofPart("place");
    case time: return {.range = tableOf<MeasuredTrace>().find("time_s")->hard, .unit = "s"};
    default: return {.range = tableOf<MeasuredTrace>().find("values")->hard};
    }
}

Keys unitsFor(ColumnQuantity quantity) {
    Keys keys{{}, Keys::Kind::choices};
    for (const auto& [unit, factor] : unitsOf(quantity)) {
        if (const std::string_view name = nameOf(unit); !name.empty()) {
            keys.keys.emplace_back(name);
        }
    }
    return keys;
}

std::optional<int> zoneNamed(std::string_view text) {
    constexpr auto zones = std::to_array<std::pair<std::string_view, int>>(
        {{"rz1", 0}, {"nz", 1}, {"rz2", 2}, {"рз1", 0}, {"нз", 1}, {"рз2", 2}});
    const std::string lower = lowerCase(text);
    for (const auto& [name, zone] : zones) {
        if (lower == name) {
            return zone;
        }
    }
    return std::nullopt;
}

} // namespace sparkout
