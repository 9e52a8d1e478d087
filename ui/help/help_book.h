// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <vector>

namespace sparkout {

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
