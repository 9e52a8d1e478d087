// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/project/iso286.h"

#include <QString>

#include <optional>

namespace sparkout {

struct Field;
struct Part;

/// A size with its field as typed, 30h6 or, for the part's own diameter, h6: what it says, or why
/// it cannot be taken.
struct TypedSize {
    std::optional<SizeDesignation> size;
    SizeDeviations deviations;
    QString text; ///< the deviations in words, or the reason; empty when nothing is typed
};
[[nodiscard]] TypedSize readSize(const QString& typed, const Part& part);

/// The symbol of an input of the part: deviations of holes, ES and EI, are written in capitals.
[[nodiscard]] QString symbolOf(const Field& field, const Part& part);

/// The field whose limits a part has, "30h6"; empty when it is none of the standard's.
[[nodiscard]] QString fieldOf(const Part& part);

} // namespace sparkout
