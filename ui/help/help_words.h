// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <memory>
#include <vector>

struct sb_stemmer;

namespace sparkout {

/// Search words for the help, in the current language. A word of a text matches if it begins with
/// one of them or differs only by its ending: "feeds" and "feed", «подачей» and «подача». Case, and
/// е for ё, make no difference.
class HelpWords {
public:
    explicit HelpWords(const QString& wanted);

    [[nodiscard]] bool isEmpty() const { return m_wanted.empty(); }
    /// Whether the text contains each word.
    [[nodiscard]] bool areIn(const QString& text) const;

    struct Place {
        qsizetype at, length;
    };
    /// The occurrences of any of them in the text.
    [[nodiscard]] std::vector<Place> placesIn(const QString& text) const;

private:
    struct Wanted {
        QString word, stem; ///< folded
        [[nodiscard]] bool is(const QString& found, const HelpWords& words) const;
    };
    [[nodiscard]] QString stemOf(const QString& folded) const;

    std::unique_ptr<sb_stemmer, void (*)(sb_stemmer*)> m_stemmer;
    std::vector<Wanted> m_wanted;
};

} // namespace sparkout
