// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tables/column_unit.h"

#include "core/tables/table_cell.h"

#include <algorithm>
#include <array>

namespace sparkout {

namespace {

struct UnitName {
    std::string_view text;
    ColumnUnit unit;
};

constexpr auto unitNames = std::to_array<UnitName>({
    {"mm", ColumnUnit::mm},   {"мм", ColumnUnit::mm},   {"um", ColumnUnit::um},
    {"µm", ColumnUnit::um},   {"μm", ColumnUnit::um},   {"мкм", ColumnUnit::um},
    {"s", ColumnUnit::s},     {"sec", ColumnUnit::s},   {"с", ColumnUnit::s},
    {"сек", ColumnUnit::s},   {"ms", ColumnUnit::ms},   {"мс", ColumnUnit::ms},
    {"min", ColumnUnit::min}, {"мин", ColumnUnit::min}, {"kw", ColumnUnit::kw},
    {"квт", ColumnUnit::kw},  {"w", ColumnUnit::w},     {"вт", ColumnUnit::w},
    {"n", ColumnUnit::n},     {"н", ColumnUnit::n},     {"kn", ColumnUnit::kn},
    {"кн", ColumnUnit::kn},   {"a", ColumnUnit::a},     {"а", ColumnUnit::a},
});

} // namespace

std::optional<ColumnUnit> unitNamed(std::string_view text) {
    const std::string lower = lowerCase(text);
    const auto* const found = std::ranges::find(unitNames, lower, &UnitName::text);
    return found == unitNames.end() ? std::nullopt : std::optional(found->unit);
}

std::string_view nameOf(ColumnUnit unit) {
    const auto* const found = std::ranges::find(unitNames, unit, &UnitName::unit);
    return found == unitNames.end() ? std::string_view() : found->text;
}

} // namespace sparkout
