// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <optional>

namespace sparkout {

/// The components of the standard times of a set-up. A time given as a total replaces its sum
/// (piece_time.h).
struct SetupTimes {
    double approach_s = 0;               ///< wheel to a surface [s]
    double retreat_s = 0;                ///< wheel from it [s]
    double gauging_s = 0;                ///< measuring a surface after its cycle [s]
    double positioning_s = 0;            ///< table from one surface to the next [s]
    double handling_s = 0;               ///< clamping and taking off a part [s]
    std::optional<double> main_min;      ///< T_o; not given: the cycles' times [min]
    std::optional<double> auxiliary_min; ///< T_a; not given: the sum of the times above [min]
    double service_percent = 0;          ///< share of T_o + T_a for service and rest [%]
    double preparation_min = 0;          ///< T_p, for the batch [min]
    int batch_size = 1;                  ///< number of parts that share it
    std::optional<double> piece_min;     ///< T_1; not given: (T_o + T_a)·(1 + service/100) [min]
    friend bool operator==(const SetupTimes&, const SetupTimes&) = default;
};

template <>
const StructInfo& tableOf<SetupTimes>();

} // namespace sparkout
