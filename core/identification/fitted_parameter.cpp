// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/fitted_parameter.h"

#include "core/identification/cycle_response.h"
#include "core/process/force.h"
#include "core/project/machine.h"
#include "core/project/part.h"

#include <algorithm>
#include <cstddef>

namespace sparkout {

bool isFactor(FittedKind kind) {
    return !isOfRecorder(kind) && kind != FittedKind::idle_power && kind != FittedKind::blank_runout
           && kind != FittedKind::gauge_setting && kind != FittedKind::count_;
}

bool actsOnDepths(FittedKind kind) {
    return isFactor(kind) && kind != FittedKind::chip_power && kind != FittedKind::friction_power;
}

bool isOfRecorder(FittedKind kind) {
    switch (kind) {
    case FittedKind::size_offset:
    case FittedKind::time_shift:
    case FittedKind::power_delay:
    case FittedKind::force_delay:
    case FittedKind::gauge_lag:
    case FittedKind::gauge_drift: return true;
    default: return false;
    }
}

bool isInput(FittedKind kind) {
    return !isOfRecorder(kind) && kind != FittedKind::idle_power;
}

double plausibleRange(FittedKind kind) {
    constexpr double ratio = 2, offset_mm = 0.1, shift_s = 1, idle_kw = 1;
    switch (kind) {
    case FittedKind::idle_power: return idle_kw;
    case FittedKind::size_offset:
    case FittedKind::gauge_drift:
    case FittedKind::gauge_setting: return offset_mm;
    case FittedKind::time_shift:
    case FittedKind::power_delay:
    case FittedKind::force_delay:
    case FittedKind::gauge_lag: return shift_s;
    default: return ratio;
    }
}

const char* keyOf(FittedKind kind) {
    switch (kind) {
    case FittedKind::alpha: return "alpha";
    case FittedKind::beta: return "beta";
    case FittedKind::compliance: return "compliance";
    case FittedKind::flow_stress: return "flow_stress";
    case FittedKind::dullness: return "dullness";
    case FittedKind::chip_power: return "chip_power";
    case FittedKind::friction_power: return "friction_power";
    case FittedKind::idle_power: return "idle_power";
    case FittedKind::size_offset: return "size_offset";
    case FittedKind::time_shift: return "time_shift";
    case FittedKind::power_delay: return "power_delay";
    case FittedKind::force_delay: return "force_delay";
    case FittedKind::blank_runout: return "blank_runout";
    case FittedKind::gauge_lag: return "gauge_lag";
    case FittedKind::gauge_drift: return "gauge_drift";
    case FittedKind::gauge_setting: return "gauge_setting";
    case FittedKind::count_: break;
    }
    return "";
}

bool areApplicable(const Project& project, const std::vector<FittedParameter>& list) {
    for (std::size_t i = 0; i < list.size(); ++i) {
        const bool twice =
            std::any_of(list.begin(), list.begin() + static_cast<std::ptrdiff_t>(i),
                        [&](const FittedParameter& other) {
                            return other.kind == list[i].kind && other.place == list[i].place;
                        });
        const bool noPlace =
            list[i].place.has_value()
            && (list[i].kind != FittedKind::compliance || !hasPlaceCompliances(project)
                || *list[i].place < 0 || *list[i].place >= placeCount(project));
        const bool measuredForm = list[i].kind == FittedKind::blank_runout
                                  && project.part->profile == ProfileForm::measured;
        const bool threshold = hasThreshold(project);
        const bool notLinear =
            (list[i].kind == FittedKind::alpha || list[i].kind == FittedKind::beta)
            && project.machine->wheel_contact && !threshold;
        const bool notInForce =
            threshold
            && (list[i].kind == FittedKind::flow_stress || list[i].kind == FittedKind::dullness);
        if (twice || noPlace || measuredForm || notLinear || notInForce) {
            return false;
        }
    }
    return true;
}

} // namespace sparkout
