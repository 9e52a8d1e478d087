// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/lesson/place_name.h"

#include "core/issue.h"
#include "core/project/project.h"

#include <array>

namespace sparkout {

static_assert(CountOrWord<PlaceName>);

std::span<const Choice> PlaceName::words() {
    static constexpr std::array words{Choice{"rz1", "РЗ1"}, Choice{"nz", "НЗ"},
                                      Choice{"rz2", "РЗ2"}};
    return words;
}

Phrase PlaceName::expected() {
    return Phrase::zoneOrSection;
}

PlaceName placeName(const Project& project, std::size_t index) {
    return project.operation->hasZones ? PlaceName::ofWord(index)
                                       : PlaceName::ofNumber(static_cast<int>(index));
}

bool hasPlace(const Project& project, const PlaceName& place) {
    const bool isOfKind =
        project.operation->hasZones ? place.zone.has_value() : place.section.has_value();
    return isOfKind && place.index() < static_cast<std::size_t>(placeCount(project));
}

} // namespace sparkout
