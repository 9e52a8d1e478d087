// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/field.h"

#include <QString>
#include <QVariantMap>

/// Structs of texts as the settings keep them: each text in one line under the key of its row, the
/// empty ones left out, none longer than its row allows.
namespace sparkout {

[[nodiscard]] QString textIn(const Field& field, const void* owner); ///< in one line

[[nodiscard]] QVariantMap keptTexts(const StructInfo& table, const void* owner);
void readKeptTexts(const QVariantMap& kept, const StructInfo& table, void* owner);

} // namespace sparkout
