// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QString>

/// The defaults of the tables. Only an input that need not stand in a file has one worth going
/// back to: a required input is the user's own, and its initial value means nothing.
namespace sparkout {

[[nodiscard]] bool hasDefault(const Field& field);
/// Whether the member has its default; true where there is none.
[[nodiscard]] bool isDefault(const Field& field, const void* owner);
/// Whether the member is as a new project has it, be it required or not; of an object all in it is,
/// a list is empty.
[[nodiscard]] bool isAsNew(const Field& field, const void* owner);
/// "0.3", "210 GPa", "between centres", or what "not given" means.
[[nodiscard]] QString defaultText(const Field& field);
/// The same of the member's own value; it is a number, a choice or a yes or no.
[[nodiscard]] QString valueText(const Field& field, const void* owner);
void setDefault(const Field& field, void* owner);

} // namespace sparkout
