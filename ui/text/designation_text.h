// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/iso286.h"
#include "core/project/project.h"
#include "core/project/wheel.h"

#include <QString>

#include <optional>

namespace sparkout {

struct Field;
struct Part;

/// A typed size with its tolerance field, 30h6 or, for the part's own diameter, h6: its meaning, or
/// the reason why it is invalid.
struct TypedSize {
    std::optional<SizeDesignation> size;
    SizeDeviations deviations;
    QString text; ///< the deviations in words, or the reason; empty without text
};
[[nodiscard]] TypedSize readSize(const QString& typed, const Part& part);

/// The symbol of an input of the part: deviations of holes, ES and EI, are in capitals.
[[nodiscard]] QString symbolOf(const Field& field, const Part& part);

/// The standard field with the limits of a part, "30h6"; empty if there is none.
[[nodiscard]] QString fieldOf(const Part& part);

/// The parts of a wheel's marking in words: "25А white fused alumina; grit F60, …".
[[nodiscard]] QString markingExplained(const WheelMarking& marking);

/// The changes that filling in a wheel from its marking would make: "Grain size 0.25 → 0.26 mm";
/// empty if there are none.
[[nodiscard]] QString markingChanges(const WheelMarking& marking, const Wheel& wheel);

} // namespace sparkout
