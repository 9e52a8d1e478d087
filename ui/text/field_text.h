// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"
#include "core/project/project.h"
#include "core/result.h"

#include <QString>
#include <QStringList>

#include <optional>

/// Values of inputs and outputs as texts, and the defaults of the tables. Only an optional input
/// has a useful default: a required input is the user's own, and its initial value has no meaning.
namespace sparkout {

[[nodiscard]] bool hasDefault(const Field& field);
/// Whether the member has its default; true if it has none.
[[nodiscard]] bool isDefault(const Field& field, const void* owner);
/// Whether the member has the value of a new project, required or not; for an object all its
/// members, for a list its emptiness.
[[nodiscard]] bool isAsNew(const Field& field, const void* owner);
/// "0.3", "210 GPa", "between centres", or the meaning of "not given".
[[nodiscard]] QString defaultText(const Field& field);
/// The member's own value in this form; it is a number, a choice or a yes or no.
[[nodiscard]] QString valueText(const Field& field, const void* owner);
void setDefault(const Field& field, void* owner);

/// The number, as people count, of a numeric row, or the number of items of a list of structs.
[[nodiscard]] std::optional<double> singleNumberIn(const Field& field, const void* owner);

/// The value of a row that is not a single number, without unit and with all digits; the meaning of
/// null if it is not given.
[[nodiscard]] QString fieldText(const Field& field, const void* owner);

/// The changes of another operation to inputs outside the stages, and the axial feeds that it gives
/// them: "Ground length L_p: 100 mm → 50 mm", "Axial feed: not used → 1800 mm/min, 300 mm/min".
[[nodiscard]] QStringList changesOfOperation(const Project& before, const Project& after);

// The texts and numbers of outputs, in the current language.

/// Without the unit, as short as its place in a table requires.
[[nodiscard]] QString outputLabel(const OutputRow& row);
/// With the unit, standing alone; `revolutions`: counts revolutions instead of double strokes.
[[nodiscard]] QString outputName(const OutputRow& row, bool revolutions = false);
/// The shortest form for a table.
[[nodiscard]] QString outputBrief(const OutputRow& row, bool revolutions = false);
[[nodiscard]] QString outputHint(const OutputRow& row);

/// A number in its displayed unit; a share or an estimate unchanged.
[[nodiscard]] std::optional<double> outputNumber(const OutputRow& row, const OutputValue& value);
/// The number as a text by threeDigits(); empty if there is none. For amounts, which are never
/// negative.
[[nodiscard]] QString outputText(const OutputRow& row, const OutputValue& value);

/// Three significant digits, at most three decimals, but at least one digit. 0 for a value that is
/// not positive.
[[nodiscard]] QString threeDigits(double value);

} // namespace sparkout
