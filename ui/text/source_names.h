// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string_view>
#include <utility>
#include <vector>

namespace sparkout {

/// The text of a source in the current language: "MODEL-5" → "model page, section 5, traverse
/// cycle". Empty for a key that core/SOURCES.md does not have.
[[nodiscard]] QString sourceText(std::string_view key);

/// Every source with its key and text.
[[nodiscard]] std::vector<std::pair<QString, QString>> sourceTexts();

} // namespace sparkout
