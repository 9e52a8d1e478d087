// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/identification/fitted_parameter.h"

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

} // namespace sparkout
