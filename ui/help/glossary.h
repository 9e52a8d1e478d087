// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

#include <vector>

namespace sparkout {

/// A term of the program in both languages, from resources/help/glossary.json.
struct Term {
    QString english, russian;
    QString englishMeaning, russianMeaning;
    /// Stems of Russian words, one of which occurs in each translation of a text with the English
    /// term. Empty for a common word with many translations.
    QStringList stems;
    QStringList banned; ///< Russian words for the same that are not used
};

/// The terms in the order of their English names.
[[nodiscard]] std::vector<Term> glossary();

/// The terms as a table in the current language, in its order, each with its name in the other.
[[nodiscard]] QString glossaryHtml();

} // namespace sparkout
