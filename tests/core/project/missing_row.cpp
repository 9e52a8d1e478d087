// SPDX-License-Identifier: GPL-3.0-or-later
// Compiled by two tests: with EVERY_ROW it must compile, without it must not.
#include "core/field.h"
#include "core/indirect.h"

#include <array>
#include <optional>
#include <vector>

namespace sparkout {

struct Motor {
    double power_kw = 0;
};

template <>
const StructInfo& tableOf<Motor>() {
    static const std::array rows{SPARKOUT_FIELD(Motor, power_kw, .label = "Power")};
    static const StructInfo info = makeTable<Motor>("Motor", rows);
    return info;
}

struct Spindle {
    std::string name;
    double speed_rpm = 0;
    std::optional<double> power_kw; ///< the member without a row
    std::vector<double> levels;
    Indirect<Motor> motor;
    OptionalIndirect<Motor> spare;
};

template <>
const StructInfo& tableOf<Spindle>() {
    static const std::array rows{
        SPARKOUT_FIELD(Spindle, name, .label = "Name"),
        SPARKOUT_FIELD(Spindle, speed_rpm, .label = "Speed"),
#ifdef EVERY_ROW
        SPARKOUT_FIELD(Spindle, power_kw, .label = "Power"),
#endif
        SPARKOUT_FIELD(Spindle, levels, .label = "Levels"),
        SPARKOUT_FIELD(Spindle, motor, .label = "Motor"),
        SPARKOUT_FIELD(Spindle, spare, .label = "Spare motor"),
    };
    static const StructInfo info = makeTable<Spindle>("Spindle", rows);
    return info;
}

} // namespace sparkout
