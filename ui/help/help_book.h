// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>

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

/// A heading of a page and the text below it.
struct HelpSection {
    QString anchor; ///< empty: the page's beginning
    QString title;
    QString text; ///< without markup
};

struct HelpPage {
    QString id; ///< "feeds"; links name it as "help:feeds#anchor"
    QString title;
    QString group; ///< group in the contents
    QString html;
    std::vector<HelpSection> sections;
};

/// The pages of the help in the current language: those written in resources/help, with additions
/// generated from the tables of the inputs, the list of sources and the window's commands.
class HelpBook {
public:
    explicit HelpBook(const QString& shortcuts); ///< HTML of the window's keys

    [[nodiscard]] const std::vector<HelpPage>& pages() const { return m_pages; }
    [[nodiscard]] const HelpPage* find(const QString& id) const; ///< null if there is none

    struct Hit {
        const HelpPage* page;
        const HelpSection* section;
        [[nodiscard]] QString topic() const; ///< "feeds#mouse"
    };
    /// Sections that contain every word in any of its forms, first those with them in the title.
    [[nodiscard]] std::vector<Hit> search(const QString& words) const;

private:
    std::vector<HelpPage> m_pages;
};

} // namespace sparkout
