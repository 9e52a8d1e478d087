// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace sparkout {

/// A text in its form for searching: case, ё and е, decimal comma and point, and letters that look
/// alike in Cyrillic and Latin (25А and 25A, 500×50 and 500x50) make no difference.
[[nodiscard]] QString searchForm(const QString& text);

/// A grade in Latin letters, as used in papers: ШХ15 → ShKh15.
[[nodiscard]] QString inLatinLetters(const QString& text);

/// Whether a text in its search form contains every word of a query.
[[nodiscard]] bool matchesQuery(const QString& searchFormOfText, const QString& query);

} // namespace sparkout
