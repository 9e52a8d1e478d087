// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/quality/result_names.h"

#include "core/quality/cycle_constraints.h"

#include <array>

namespace sparkout {

const char* zoneKey(Zone zone) {
    constexpr std::array keys{"rz1", "nz", "rz2", "section"};
    return keys[static_cast<std::size_t>(zone)];
}

const char* stepKey(Step step) {
    constexpr std::array keys{"", "E1", "E2", "E3", "E4", "E5"};
    return keys[static_cast<std::size_t>(step)];
}

const char* statusKey(RunStatus status) {
    switch (status) {
    case RunStatus::completed: return "completed";
    case RunStatus::cannotReachSize: return "cannot_reach_size";
    case RunStatus::tooLong: return "too_long";
    case RunStatus::stopped: return "stopped";
    case RunStatus::notSolved: return "not_solved";
    case RunStatus::groundAway: return "ground_away";
    case RunStatus::refused: return "refused";
    }
    return "";
}

const char* formKey(LongitudinalForm form) {
    constexpr std::array keys{"straight", "taper", "barrel", "saddle"};
    return keys[static_cast<std::size_t>(form)];
}

std::string sectionName(Zone zone, int section, First first) {
    return zone == Zone::section ? "section " + std::to_string(section + static_cast<int>(first))
                                 : zoneKey(zone);
}

std::string sectionOrPart(Zone zone, int section, First first) {
    return section < 0 ? "part" : sectionName(zone, section, first);
}

std::string placeText(const Place& place, First first) {
    const bool plunge = place.zone == Zone::section;
    return sectionName(place.zone, place.section, first) + (plunge ? "" : " ") + stepKey(place.step)
           + " stage " + std::to_string(place.stage) + (plunge ? " revolution " : " double stroke ")
           + std::to_string(place.cycleCount);
}

std::string whereText(const ConstraintResult& constraint, First first) {
    if (constraint.at) {
        return placeText(*constraint.at, first);
    }
    switch (requirementOf(constraint.kind).scope) {
    case ConstraintScope::section: return sectionName(constraint.zone, constraint.section, first);
    case ConstraintScope::part: return "part";
    case ConstraintScope::pass:
    case ConstraintScope::setting: break;
    }
    return constraint.stage > 0 ? "stage " + std::to_string(constraint.stage) : "cycle";
}

} // namespace sparkout
