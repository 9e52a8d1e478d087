// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QString>
#include <QVariantMap>

/// Structs of texts in the settings: each text is one line under the key of its row, without empty
/// ones and limited to the length that its row allows.
namespace sparkout {

[[nodiscard]] QString textIn(const Field& field, const void* owner); ///< converted to one line

[[nodiscard]] QVariantMap keptTexts(const StructInfo& table, const void* owner);
void readKeptTexts(const QVariantMap& kept, const StructInfo& table, void* owner);

} // namespace sparkout
