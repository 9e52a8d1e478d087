// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QString>

#include <optional>

/// Values of any input as texts, without their units and with all their digits.
namespace sparkout {

/// The number, as people count, of a numeric row, or the number of items of a list of structs.
[[nodiscard]] std::optional<double> singleNumberIn(const Field& field, const void* owner);

/// The value of a row that is not a single number; the meaning of null if it is not given.
[[nodiscard]] QString fieldText(const Field& field, const void* owner);

} // namespace sparkout
