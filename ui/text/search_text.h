// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace sparkout {

/// A text as it is searched: case, ё and е, decimal comma and point, letters that look alike in
/// Cyrillic and Latin (25А and 25A, 500×50 and 500x50) make no difference.
[[nodiscard]] QString searchForm(const QString& text);

/// A grade in Latin letters, as it stands in papers: ШХ15 → ShKh15.
[[nodiscard]] QString inLatinLetters(const QString& text);

/// Whether every word of a query stands somewhere in a text that is in its search form.
[[nodiscard]] bool matchesQuery(const QString& searchFormOfText, const QString& query);

} // namespace sparkout
